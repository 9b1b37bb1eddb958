using System.Globalization;
using System.Text;

namespace ErrorMatching.Freeform;

/// <summary>Compensation points as a table: <c>point,x,y,z,errorUm</c>.</summary>
public static class CompensationCsv
{
    /// <summary>Writes the table: UTF-8 without a byte order mark, lines ending in a line feed, millimeters to the nanometer.</summary>
    public static byte[] Write(CompensationResult result)
    {
        ArgumentNullException.ThrowIfNull(result);
        var text = new StringBuilder("point,x,y,z,errorUm\n");
        foreach (var (sample, expected) in result.Samples.Zip(result.Expected))
        {
            var p = result.PointOf(expected);
            text.Append(
                CultureInfo.InvariantCulture,
                $"{sample.Point},{Number(p.X)},{Number(p.Y)},{Number(p.Z)},{(sample.ErrorMm * 1000) + 0.0:0.####}\n");
        }

        return Encoding.UTF8.GetBytes(text.ToString());
    }

    // Adding zero turns -0 into 0.
    private static string Number(double value) => (Math.Round(value, 6) + 0.0).ToString("0.######", CultureInfo.InvariantCulture);
}
