using System.Globalization;
using System.Text.Json;

namespace ErrorMatching.Cell.Tests;

/// <summary>The measurement of the counterpart that the program of a report cuts next.</summary>
internal static class NextCounterpart
{
    /// <summary>Each key point is where it is designed, moved by what the program corrects and by the error of the process.</summary>
    /// <param name="report">The report of a match in feedback.</param>
    /// <param name="process">The error of the process, in multiples of what the first counterpart showed.</param>
    /// <param name="number">Makes its content another one than that of pieces with the same values.</param>
    public static string Of(ReadOnlyMemory<byte> report, double process, int number)
    {
        using var json = JsonDocument.Parse(report);
        var lot = json.RootElement.GetProperty("lot");
        var corrections = lot.GetProperty("correctionsUm");
        var errors = lot.GetProperty("pieces")[0].GetProperty("errorsUm");
        var rows = json.RootElement.GetProperty("keyPoints").EnumerateArray().Select((point, i) =>
        {
            var (design, normal) = (point.GetProperty("theoretical"), point.GetProperty("normal"));
            var mm = (corrections[i].GetDouble() + (process * errors[i].GetDouble())) / 1000;
            return string.Create(
                CultureInfo.InvariantCulture,
                $"{point.GetProperty("point").GetString()},{At("x"):0.0000},{At("y"):0.0000}");

            double At(string axis) => design.GetProperty(axis).GetDouble() + (mm * normal.GetProperty(axis).GetDouble());
        });
        return "point,x_mm,y_mm\n" + string.Join('\n', rows) + new string('\n', number);
    }
}
