using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>Makes measured parts that differ a little from a given one, as a gauge finds them during a day.</summary>
internal static class DemoPart
{
    /// <summary>Makes a measurement similar to another one.</summary>
    /// <param name="part">The other one, as CSV with a label and coordinates.</param>
    /// <param name="serial">The seed: the same number gives the same part.</param>
    /// <param name="spread">Largest change of a coordinate, in mm.</param>
    public static string Near(string part, int serial, double spread)
    {
        var seed = (uint)serial;
        return Each(part, (_, _, value) => value + (spread * Next()));

        // Numerical Recipes' linear congruential generator: the same on every computer.
        double Next()
        {
            seed = (1664525 * seed) + 1013904223;
            return ((seed >> 8) / (double)(1 << 23)) - 1;
        }
    }

    /// <summary>Makes the counterpart of a part, with the deviations of another counterpart from its own part.</summary>
    /// <param name="part">The part.</param>
    /// <param name="like">The other counterpart.</param>
    /// <param name="of">The part that the other counterpart belongs to, with the same labels in the same order.</param>
    public static string Counterpart(string part, string like, string of)
    {
        var (parts, others) = (Rows(part), Rows(of));
        return Each(like, (row, column, value) => value + Number(parts[row][column]) - Number(others[row][column]));
    }

    /// <summary>Makes a measurement with other positions.</summary>
    /// <param name="like">The measurement.</param>
    /// <param name="places">Its new positions, by label, mm; points not listed stay.</param>
    public static string At(string like, IReadOnlyDictionary<string, Point2> places)
    {
        var rows = Rows(like);
        return Each(
            like, (row, column, value) => !places.TryGetValue(rows[row][0], out var place) ? value : column == 1 ? place.X : place.Y);
    }

    private static string Each(string csv, Func<int, int, double, double> change)
    {
        var rows = Rows(csv);
        var text = new StringBuilder(string.Join(',', rows[0])).Append('\n');
        for (var row = 1; row < rows.Length; row++)
        {
            text.Append(rows[row][0]);
            for (var column = 1; column < rows[row].Length; column++)
            {
                text.Append(CultureInfo.InvariantCulture, $",{change(row, column, Number(rows[row][column])):0.0000}");
            }

            text.Append('\n');
        }

        return text.ToString();
    }

    private static string[][] Rows(string csv) => [.. csv.TrimEnd('\n').Split('\n').Select(l => l.TrimEnd('\r').Split(','))];

    private static double Number(string field) => double.Parse(field, CultureInfo.InvariantCulture);
}
