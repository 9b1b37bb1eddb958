namespace ErrorMatching.Mating;

/// <summary>Checks whether a whole correction is one uniform offset, which the control itself could apply.</summary>
internal static class UniformOffset
{
    /// <summary>Largest difference between corrections that are considered equal: half the usual smallest increment.</summary>
    public const double ToleranceMm = 0.0005;

    /// <summary>The tool-radius wear value equivalent to all corrections together, or null if there is none. Positive moves the tool away
    /// from the material.</summary>
    /// <remarks>A control that is given a tool larger by w moves it w farther from the boundary, along the normal from the material to
    /// the tool. The wear value is therefore the common normal correction, with its sign. It exists only if every feature is compensated,
    /// every correction is along its normal, and all are equal within <see cref="ToleranceMm"/>. Enter twice the value on a control that
    /// stores wear as a diameter.</remarks>
    public static double? RadiusWearMm(MatingDecision decision)
    {
        ArgumentNullException.ThrowIfNull(decision);
        var points = decision.Features.SelectMany(f => f.Points).ToArray();
        if (points.Length == 0 || decision.Features.Any(f => f.Decision != Decision.Compensated))
        {
            return null;
        }

        var middle = (points.Min(p => p.CorrectionNormalMm) + points.Max(p => p.CorrectionNormalMm)) / 2;
        return points.All(p => (p.Correction - (p.Point.Normal * middle)).Length <= ToleranceMm) ? middle : null;
    }
}
