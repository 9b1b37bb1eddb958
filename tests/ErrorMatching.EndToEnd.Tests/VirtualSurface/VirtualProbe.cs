using System.Globalization;
using System.Text;
using System.Text.RegularExpressions;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A control that runs a probing program of G38.2 moves over a cut surface and writes the log that the program asks for.</summary>
internal static partial class VirtualProbe
{
    /// <summary>The log of a run.</summary>
    /// <param name="program">The program.</param>
    /// <param name="surface">The piece.</param>
    /// <param name="stylusRadius">Radius of the stylus ball in millimetres.</param>
    /// <param name="repeatability">Standard deviation of the place of a touch along the move, in millimetres.</param>
    /// <param name="random">What does not repeat.</param>
    /// <exception cref="InvalidOperationException">A move ends without a touch.</exception>
    public static string Run(string program, CutSurface surface, double stylusRadius, double repeatability, Random random)
    {
        var touches = StraightProgram.Read(program)
            .Where(m => m.IsMeasuring)
            .Select(m => Touch(m, surface, stylusRadius, repeatability, random))
            .ToArray();
        var log = new StringBuilder();
        var next = 0;
        foreach (Match line in LogLines().Matches(program))
        {
            var text = line.Groups["text"].Value;
            if (text.Contains("#5061", StringComparison.Ordinal))
            {
                var at = touches[next++];
                text = text.Replace("#5061", Six(at.X), StringComparison.Ordinal)
                    .Replace("#5062", Six(at.Y), StringComparison.Ordinal)
                    .Replace("#5063", Six(at.Z), StringComparison.Ordinal);
            }

            log.Append(text).Append('\n');
        }

        return next == touches.Length
            ? log.ToString()
            : throw new InvalidOperationException($"{touches.Length} touches, {next} lines in the log");
    }

    private static Place Touch(AxisMove move, CutSurface surface, double stylusRadius, double repeatability, Random random)
    {
        var at = surface.Touch(move.From, move.To, stylusRadius)
            ?? throw new InvalidOperationException($"nothing touched between {move.From} and {move.To}");
        return at + ((move.To - move.From).Unit() * (repeatability * Normal(random)));
    }

    // Box and Muller.
    private static double Normal(Random random) =>
        Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());

    private static string Six(double value) => value.ToString("0.000000", CultureInfo.InvariantCulture);

    [GeneratedRegex(@"\(LOG,(?<text>[^)]*)\)", RegexOptions.ExplicitCapture, 10_000)]
    private static partial Regex LogLines();
}
