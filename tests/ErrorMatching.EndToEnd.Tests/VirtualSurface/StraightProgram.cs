using System.Globalization;
using System.Text.RegularExpressions;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>Reads programs of straight absolute moves in millimetres: all that a finishing or a probing program should hold. Written from
/// ISO 6983-1 and the controls' words for measuring; shares no code with the library.</summary>
internal static partial class StraightProgram
{
    /// <summary>All moves that have a beginning: the first one that names all three axes only sets where the tool is.</summary>
    public static IReadOnlyList<AxisMove> Read(string program)
    {
        var moves = new List<AxisMove>();
        var motion = 0.0;
        double? x = null, y = null, z = null;
        foreach (var line in program.Split('\n'))
        {
            var text = Comments().Replace(Texts().Replace(line.TrimEnd('\r'), ""), "").ToUpperInvariant();
            if (text.Length == 0
                || text[0] is '%' or '#'
                || text.Contains('=', StringComparison.Ordinal) && !text.Contains("MEAS=", StringComparison.Ordinal)
                || text.TrimStart().StartsWith('O'))
            {
                continue;
            }

            var measuring = text.Contains("MEAS=1", StringComparison.Ordinal);
            var machine = false;
            double? toX = null, toY = null, toZ = null;
            foreach (Match word in Words().Matches(text.Replace("MEAS=1", "", StringComparison.Ordinal)))
            {
                var value = double.Parse(word.Groups["value"].Value, CultureInfo.InvariantCulture);
                switch (word.Groups["letter"].Value)
                {
                    case "G" when value is 0 or 1: motion = value; break;
                    case "G" when value is 38.2 or 31: (motion, measuring) = (1, true); break;
                    case "G" when value is 2 or 3 or 91 or 20 or 70 or 18 or 19: throw new NotSupportedException($"G{value} in {line}");
                    case "G" when value is 53 or 28: machine = true; break;
                    case "X": toX = value; break;
                    case "Y": toY = value; break;
                    case "Z": toZ = value; break;
                }
            }

            if (machine)
            {
                // Where the machine goes by its own coordinates is not known in the work offset.
                (x, y, z) = (toX is null ? x : null, toY is null ? y : null, toZ is null ? z : null);
            }
            else if ((toX ?? toY ?? toZ) is not null)
            {
                var (a, b, c) = (toX ?? x, toY ?? y, toZ ?? z);
                if (x is { } x0 && y is { } y0 && z is { } z0)
                {
                    moves.Add(new(new(x0, y0, z0), new(a!.Value, b!.Value, c!.Value), motion == 0, measuring));
                }

                (x, y, z) = (a, b, c);
            }
        }

        return moves;
    }

    [GeneratedRegex(@"\([^)]*\)|;.*", RegexOptions.ExplicitCapture, 10_000)]
    private static partial Regex Comments();

    [GeneratedRegex("\"[^\"]*\"", RegexOptions.ExplicitCapture, 10_000)]
    private static partial Regex Texts();

    [GeneratedRegex(@"(?<letter>[A-Z])\s*(?<value>[-+]?[0-9]*\.?[0-9]+|[-+]?[0-9]+\.)(?![A-Z_\[(=])", RegexOptions.ExplicitCapture, 10_000)]
    private static partial Regex Words();
}
