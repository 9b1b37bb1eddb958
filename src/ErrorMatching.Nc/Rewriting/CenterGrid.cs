using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Chooses the center words of an arc from the grid points around the exact center. Both radii must agree, and the arc's middle
/// must be in its wished place. Rounding each word separately would let the radii differ by up to 1.4 increments, which some controls
/// refuse.</summary>
internal static class CenterGrid
{
    /// <summary>Largest difference of the two radii that is written if any grid point allows it, mm.</summary>
    public const double WantedMismatchMm = 0.001;

    /// <summary>How far an arc may be from where it is wanted before other radii are tried, in increments.</summary>
    private const double MostRounding = 1.4;

    private const int Reach = 2;

    /// <summary>Finds the center words.</summary>
    /// <param name="origin">Origin of the center words: the start, or the plane's origin.</param>
    /// <param name="start">Rounded start.</param>
    /// <param name="end">Rounded end.</param>
    /// <param name="wanted">The exact arc.</param>
    /// <param name="was">The center words before, mm; null if there were none. They stay if they are good enough.</param>
    /// <param name="increment">Least increment, mm.</param>
    /// <returns>Center words in steps of the least increment; null for a word that stays.</returns>
    /// <exception cref="InputException">The center is too far away for a number.</exception>
    public static (long? First, long? Second) Choose(Point2 origin, Point2 start, Point2 end, Arc2 wanted, Vector2? was, double increment)
    {
        var exact = wanted.Center - origin;
        var (first, second) = (NcNumber.Round(exact.X / increment, 0).Digits, NcNumber.Round(exact.Y / increment, 0).Digits);
        var free = FreeMismatch(start, end, wanted, increment);
        var best = Cheapest(free);
        var found = origin + new Vector2(best.First * increment, best.Second * increment);
        if (MiddleError(found, start, end, wanted) > increment || WholeError(found, start, end, wanted) > MostRounding * increment)
        {
            // Beyond half a turn, an arc moves further than its center. Prefer radii that differ slightly, within what controls accept.
            free = WantedMismatchMm;
            best = Cheapest(free, measuresWhole: true);
        }

        if (was is { } old && (old - exact).Length < 1.5 * increment && Cost(origin + old, start, end, wanted, free) is var kept
            && kept <= best.Cost + (increment / 4) && ArcCenter.Mismatch(start, end, origin + old) <= WantedMismatchMm)
        {
            return (null, null);
        }

        return (best.First, best.Second);

        (long First, long Second, double Cost) Cheapest(double freeMismatch, bool measuresWhole = false)
        {
            var cheapest = (first, second, Cost: double.PositiveInfinity);
            for (var i = first - Reach; i <= first + Reach; i++)
            {
                for (var j = second - Reach; j <= second + Reach; j++)
                {
                    var center = origin + new Vector2(i * increment, j * increment);
                    var cost = Cost(center, start, end, wanted, freeMismatch);
                    cost += measuresWhole ? 10 * Math.Max(0, WholeError(center, start, end, wanted) - (MostRounding * increment)) : 0;
                    cheapest = cost < cheapest.Cost ? (i, j, cost) : cheapest;
                }
            }

            return cheapest;
        }
    }

    private static double WholeError(Point2 center, Point2 start, Point2 end, Arc2 wanted) =>
        Arc2.Between(start, end, center, wanted.IsCounterClockwise).FurthestFrom(wanted.Circle);

    private static double MiddleError(Point2 center, Point2 start, Point2 end, Arc2 wanted) =>
        Math.Abs(wanted.Middle.DistanceTo(center) - ((start.DistanceTo(center) + end.DistanceTo(center)) / 2));

    // Radii may differ by half an increment, or by the arc's own mismatch beyond its rounding, which a fine grid cannot reduce.
    private static double FreeMismatch(Point2 start, Point2 end, Arc2 wanted, double increment) =>
        Math.Min(WantedMismatchMm / 2, Math.Max(increment / 2, ArcCenter.Mismatch(start, end, wanted.Center) - (1.5 * increment)));

    // Excess mismatch of the radii has the most weight, then the middle, then the exact center, which an offset must keep.
    private static double Cost(Point2 center, Point2 start, Point2 end, Arc2 wanted, double freeMismatch)
    {
        var mismatch = ArcCenter.Mismatch(start, end, center);
        return MiddleError(center, start, end, wanted) + (0.1 * mismatch) + (0.3 * center.DistanceTo(wanted.Center))
            + (10 * Math.Max(0, mismatch - freeMismatch));
    }
}
