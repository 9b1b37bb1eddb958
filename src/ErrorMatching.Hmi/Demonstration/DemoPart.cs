using System.Globalization;
using System.Text;

namespace ErrorMatching.Hmi;

/// <summary>Measured parts that are a little different from another one: what a gauge finds in the course of a day.</summary>
internal static class DemoPart
{
    /// <summary>A measurement like another one.</summary>
    /// <param name="part">The other one, as CSV with a label and two coordinates.</param>
    /// <param name="serial">Decides how it is different: the same number gives the same part.</param>
    /// <param name="spread">How far a point is away at most, in mm.</param>
    public static string Near(string part, int serial, double spread)
    {
        var lines = part.TrimEnd('\n').Split('\n');
        var text = new StringBuilder(lines[0]).Append('\n');
        var seed = (uint)serial;
        foreach (var line in lines.Skip(1))
        {
            var fields = line.TrimEnd('\r').Split(',');
            text.Append(CultureInfo.InvariantCulture, $"{fields[0]},{Moved(fields[1]):0.0000},{Moved(fields[2]):0.0000}\n");
        }

        return text.ToString();

        double Moved(string coordinate) => double.Parse(coordinate, CultureInfo.InvariantCulture) + (spread * Next());

        // Numerical Recipes' linear congruential generator: the same on every computer.
        double Next()
        {
            seed = (1664525 * seed) + 1013904223;
            return ((seed >> 8) / (double)(1 << 23)) - 1;
        }
    }
}
