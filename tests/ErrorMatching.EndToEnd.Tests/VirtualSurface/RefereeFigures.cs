using System.Globalization;
using System.Text.RegularExpressions;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>What the touches of a run come to, by the referee: distances from the closed form of the design,
/// with nothing of the compensator's.</summary>
/// <param name="MeanMm">Mean error along the normal, in millimetres.</param>
/// <param name="StandardDeviationMm">Standard deviation, with n - 1.</param>
/// <param name="ProfileIsoMm">Profile by ISO 1101: twice the largest absolute error.</param>
internal sealed partial record RefereeFigures(double MeanMm, double StandardDeviationMm, double ProfileIsoMm)
{
    /// <summary>The figures of a log.</summary>
    /// <param name="log">The log: lines with the places of the ball's center.</param>
    /// <param name="sample">The design.</param>
    /// <param name="above">How far a center lies above the nominal surface where there is no error:
    /// the ball's radius and the stock, in millimetres.</param>
    public static RefereeFigures Of(string log, string sample, double above)
    {
        var errors = Centers().Matches(log)
            .Select(m => Height(sample, new(Number(m, "x"), Number(m, "y"), Number(m, "z"))) - above)
            .ToArray();
        var mean = errors.Average();
        return new(mean, Math.Sqrt(errors.Sum(e => (e - mean) * (e - mean)) / (errors.Length - 1)), 2 * errors.Max(Math.Abs));
    }

    // Distance along the normal: the foot is where nothing of the way is left along the surface.
    private static double Height(string sample, Place center)
    {
        var (x, y) = (center.X, center.Y);
        for (var step = 0; ; step++)
        {
            var (z, slopeX, slopeY) = Design(sample, x, y);
            var normal = new Place(-slopeX, -slopeY, 1).Unit();
            var way = center - new Place(x, y, z);
            var height = way.Dot(normal);
            var along = way - (normal * height);
            if (along.Length < 1e-12 || step == 100)
            {
                return along.Length < 1e-9 ? height : throw new InvalidOperationException($"{center} has no foot");
            }

            (x, y) = (x + along.X, y + along.Y);
        }
    }

    // Height and slopes of the paper's designs: quadratic profiles over 75 by 63 mm.
    private static (double Z, double SlopeX, double SlopeY) Design(string sample, double x, double y)
    {
        var (along, across, turnX, turnY) = (x - 37.5, y - 31.5, (2 * x / 75) - 1, (2 * y / 63) - 1);
        return sample switch
        {
            "surface-one" => (30 - (0.004 * x * x), -0.008 * x, 0),
            "surface-two" => (24 + (0.004 * across * across * turnX), 0.004 * across * across * 2 / 75, 0.008 * across * turnX),
            "surface-three" =>
                (
                    24 + (0.004 * ((across * across * turnX) + (along * along * turnY))),
                    0.004 * ((across * across * 2 / 75) + (2 * along * turnY)),
                    0.004 * ((2 * across * turnX) + (along * along * 2 / 63))),
            _ => throw new ArgumentOutOfRangeException(nameof(sample), sample, "no design of the paper"),
        };
    }

    private static double Number(Match line, string name) => double.Parse(line.Groups[name].Value, CultureInfo.InvariantCulture);

    [GeneratedRegex(
        @"^P[0-9]+ C X(?<x>[-0-9.]+) Y(?<y>[-0-9.]+) Z(?<z>[-0-9.]+)", RegexOptions.Multiline | RegexOptions.ExplicitCapture, 10_000)]
    private static partial Regex Centers();
}
