namespace ErrorMatching.Mating;

/// <summary>Where a measuring move can start.</summary>
internal static class MeasuringMove
{
    // A move is looked at in steps of this length, mm.
    private const double StepMm = 0.1;

    // Tried in turn where there is less room, as shares of the wanted approach.
    private static readonly double[] _shares = [1, 0.75, 0.5, 0.25];

    /// <summary>The longest of some approaches along which the ball has room, mm; null if it has along none.</summary>
    /// <param name="wantedMm">The approach that is wanted.</param>
    /// <param name="hasRoom">Whether the ball has room at a distance from where it touches, mm.</param>
    public static double? ApproachMm(double wantedMm, Func<double, bool> hasRoom)
    {
        foreach (var share in _shares)
        {
            var approach = share * wantedMm;
            var steps = (int)Math.Ceiling(approach / StepMm);
            if (Enumerable.Range(0, steps + 1).All(k => hasRoom(approach * k / steps)))
            {
                return approach;
            }
        }

        return null;
    }
}
