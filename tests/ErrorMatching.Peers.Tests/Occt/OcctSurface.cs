using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Peers.Tests;

/// <summary>Our curves and surfaces as DRAW's commands that make the same ones, and DRAW's numbers as ours.</summary>
internal static class OcctSurface
{
    /// <summary>The command that makes the curve under a name. Clamped knots are expected.</summary>
    public static string Command(string name, SplineCurve curve)
    {
        var text = new StringBuilder($"bsplinecurve {name} {Knots(curve.Knots)}");
        for (var i = 0; i < curve.Poles.Length; i++)
        {
            Append(text, curve.Poles[i], curve.IsRational ? curve.Weights[i] : 1);
        }

        return text.Append('\n').ToString();
    }

    /// <summary>The command that makes the surface under a name; there, u runs faster. Clamped knots are expected.</summary>
    public static string Command(string name, SplineSurface surface)
    {
        var text = new StringBuilder($"bsplinesurf {name} {Knots(surface.KnotsU)} {Knots(surface.KnotsV)}");
        for (var j = 0; j < surface.CountV; j++)
        {
            for (var i = 0; i < surface.CountU; i++)
            {
                var pole = (i * surface.CountV) + j;
                Append(text, surface.Poles[pole], surface.IsRational ? surface.Weights[pole] : 1);
            }
        }

        return text.Append('\n').ToString();
    }

    /// <summary>A number with all its digits.</summary>
    public static string Number(double x) => x.ToString("R", CultureInfo.InvariantCulture);

    /// <summary>The lines that the script printed behind a word, as numbers.</summary>
    public static double[][] Lines(string output, string word) => [.. output.Split('\n')
        .Where(l => l.StartsWith(word + " ", StringComparison.Ordinal))
        .Select(
            l => l.Split(' ', StringSplitOptions.RemoveEmptyEntries)
                .Skip(1)
                .Select(n => double.Parse(n, CultureInfo.InvariantCulture))
                .ToArray())];

    private static void Append(StringBuilder text, Point3 pole, double weight) =>
        text.Append(' ').AppendJoin(' ', Number(pole.X), Number(pole.Y), Number(pole.Z), Number(weight));

    private static string Knots(KnotVector knots) =>
        $"{knots.Degree} {knots.Breaks.Count} " + string.Join(' ', knots.Breaks.Select(b => $"{Number(b)} {knots.Multiplicity(b)}"));
}
