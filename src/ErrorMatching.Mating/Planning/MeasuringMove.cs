namespace ErrorMatching.Mating;

/// <summary>Where a measuring move can start.</summary>
internal static class MeasuringMove
{
    /// <summary>The least gap beside the ball where it goes down, mm: a piece that deviates less, or stands off its work offset by less, is
    /// not met there.</summary>
    public const double LeastGapMm = 0.25;

    // Rounding of a program's words.
    private const double RoundingMm = 0.01;

    // A move is looked at in steps of this length, mm.
    private const double StepMm = 0.1;

    // Tried in turn where there is less room, as shares of the wanted approach.
    private static readonly double[] _shares = [1, 0.75, 0.5, 0.25];

    /// <summary>The approach where the ball goes down with the largest gap beside it, of several as large the longest, mm; null if it has
    /// room along none.</summary>
    /// <param name="wantedMm">The approach that is wanted.</param>
    /// <param name="enoughMm">A gap that is large enough: by so much, the piece can deviate.</param>
    /// <param name="gapMm">The gap beside the ball, as designed, at a distance from where it touches, mm; negative without room.</param>
    public static double? ApproachMm(double wantedMm, double enoughMm, Func<double, double> gapMm)
    {
        (double ApproachMm, double GapMm)? best = null;
        foreach (var approach in _shares.Select(s => s * wantedMm))
        {
            var steps = (int)Math.Ceiling(approach / StepMm);
            var gap = Math.Min(gapMm(approach), enoughMm);
            if (gap + RoundingMm >= Math.Min(LeastGapMm, approach) && !(gap <= best?.GapMm + RoundingMm)
                && Enumerable.Range(0, steps + 1).All(k => gapMm(approach * k / steps) >= -RoundingMm))
            {
                best = (approach, gap);
            }
        }

        return best?.ApproachMm;
    }
}
