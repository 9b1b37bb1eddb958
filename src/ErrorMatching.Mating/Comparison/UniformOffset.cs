namespace ErrorMatching.Mating;

/// <summary>Whether a whole correction is one uniform offset, which the control could make by itself.</summary>
internal static class UniformOffset
{
    /// <summary>How much corrections may differ and still count as one: half the usual least increment.</summary>
    public const double ToleranceMm = 0.0005;

    /// <summary>
    /// The tool-radius wear value that does the same as all corrections together, or null if there is none.
    /// Positive moves the tool away from the material.
    /// </summary>
    /// <remarks>
    /// A tool taken to be larger by w is led w further from the boundary, along the normal from the material to the tool. So the wear value
    /// is the common normal correction, with its sign. It exists only where every feature is compensated, every correction runs along its
    /// normal, and all are equal within <see cref="ToleranceMm"/>. A control that keeps wear as a diameter takes twice the value.
    /// </remarks>
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
