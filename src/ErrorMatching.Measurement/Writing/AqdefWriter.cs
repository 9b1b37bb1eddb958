using System.Globalization;
using System.Text;

namespace ErrorMatching.Measurement;

/// <summary>Writes the result of a piece as Q-DAS AQDEF (one file <c>.dfq</c>): the coordinates of each point, and its deviation along the
/// normal with its limits.</summary>
/// <remarks>UTF-8 without a byte order mark, lines end with a line feed. The characteristics of a point are <c>P1.X</c>, <c>P1.Y</c>,
/// <c>P1.Z</c> and <c>P1.N</c>. The values have no time, because the library has no clock.</remarks>
public static class AqdefWriter
{
    // The longest texts that the standard allows.
    private const int MostOfNumber = 30, MostOfName = 80;

    /// <summary>The result as a file.</summary>
    /// <param name="piece">The result.</param>
    public static byte[] Write(PieceResult piece)
    {
        ArgumentNullException.ThrowIfNull(piece);
        var characteristics = piece.Points.SelectMany(Characteristics).ToArray();
        var text = new StringBuilder();
        Line(text, $"K0100 {characteristics.Length}");
        Line(text, $"K1001 {Text(piece.Name, MostOfNumber)}");
        Line(text, $"K1002 {Text(piece.Name, MostOfName)}");
        if (piece.WorkOrder is { Length: > 0 } order)
        {
            Line(text, $"K1053 {Text(order, MostOfNumber)}");
        }

        for (var i = 0; i < characteristics.Length; i++)
        {
            var (name, nominal, _, limits) = characteristics[i];
            var n = i + 1;
            Line(text, $"K2001/{n} {n}");
            Line(text, $"K2002/{n} {Text(name, MostOfName)}");
            Line(text, $"K2004/{n} 0");
            Line(text, $"K2022/{n} {WrittenNumber.Decimals}");
            Line(text, $"K2101/{n} {WrittenNumber.Of(nominal)}");
            if (limits is { } band)
            {
                Line(text, $"K2110/{n} {WrittenNumber.Of(band.LowerMm)}");
                Line(text, $"K2111/{n} {WrittenNumber.Of(band.UpperMm)}");
            }

            Line(text, $"K2142/{n} mm");
        }

        text.AppendJoin(
                AqdefReader.BetweenCharacteristics,
                characteristics.Select(c => WrittenNumber.Of(c.Actual) + AqdefReader.BetweenFields + '0'))
            .Append('\n');
        return Encoding.UTF8.GetBytes(text.ToString());
    }

    private static IEnumerable<(string Name, double Nominal, double Actual, (double LowerMm, double UpperMm)? Limits)> Characteristics(
        PointResult point)
    {
        yield return (point.Label + ".X", point.Nominal.X, point.Actual.X, null);
        yield return (point.Label + ".Y", point.Nominal.Y, point.Actual.Y, null);
        if (point.HasZ)
        {
            yield return (point.Label + ".Z", point.Nominal.Z, point.Actual.Z, null);
        }

        yield return (point.Label + ".N", 0, point.DeviationMm, point.Limits);
    }

    private static void Line(StringBuilder text, FormattableString line) =>
        text.Append(line.ToString(CultureInfo.InvariantCulture)).Append('\n');

    // A field is one line. Of a long text the end is kept, because it names the axis.
    private static string Text(string text, int most)
    {
        var line = string.Concat(text.Select(c => char.IsControl(c) ? ' ' : c)).Trim();
        return line.Length <= most ? line : line[^most..];
    }
}
