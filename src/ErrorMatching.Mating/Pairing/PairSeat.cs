using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>Where a part seats in its counterpart: the motion that leaves the most air at the tightest place, and how far the part can move
/// from there.</summary>
/// <remarks>If the part can be lifted off everywhere at once, no air is the largest. Then the seat is the part pressed home: the smallest
/// mean gap without overlap.</remarks>
internal sealed class PairSeat
{
    // A gap up to here is rounding.
    private const double Rounding = 1e-9;

    // A multiplier up to here is none.
    private const double NoShare = 1e-7;

    private PairSeat(PairMotions motions, double[] motion, double? tightestMm, IReadOnlyList<int> contacts, IReadOnlyList<double> gaps)
    {
        (TightestMm, Contacts) = (tightestMm, contacts);
        Shift = new(motion[0], motion[1]);
        Turn = Angle.FromRadians(motion[2] / motions.ArmMm);
        GapsMm = [.. gaps.Select((g, k) => g + motions.ChangeAt(k, motion))];
    }

    /// <summary>The shift of the part to the seat.</summary>
    public Vector2 Shift { get; }

    /// <summary>The turn of the part to the seat, about the middle of the motions.</summary>
    public Angle Turn { get; }

    /// <summary>The air at the tightest place, negative for an overlap; null if the part can be lifted off everywhere at once.</summary>
    public double? TightestMm { get; }

    /// <summary>The places that determine the seat.</summary>
    public IReadOnlyList<int> Contacts { get; }

    /// <summary>The gaps at the seat.</summary>
    public IReadOnlyList<double> GapsMm { get; }

    /// <summary>How far the part can move; null if it does not go together.</summary>
    public PairPlay? Play { get; private init; }

    /// <summary>True if the part goes together with its counterpart.</summary>
    public static bool GoesTogether(double? tightestMm) => tightestMm is null or >= -Rounding;

    /// <summary>The seat for gaps.</summary>
    /// <param name="motions">The motions of their places.</param>
    /// <param name="gaps">The gaps, positive for air.</param>
    public static PairSeat Find(PairMotions motions, IReadOnlyList<double> gaps)
    {
        var limits = motions.Limits(gaps);
        var seat = motions.Seat(Smallest(gaps));
        seat.Solve(limits);
        if (IsBounded(motions, seat))
        {
            var tightest = seat.Value;
            for (var k = 0; k < gaps.Count; k++)
            {
                limits[k] -= tightest - Rounding;
            }

            return new(motions, Middle(motions, limits, null), tightest, Determining(motions, seat), gaps)
            {
                Play = GoesTogether(tightest) ? PlayOf(motions, gaps, Math.Max(0, -tightest)) : null,
            };
        }

        var toward = motions.MeanChange();
        var home = motions.Furthest([.. toward.Select(t => -t)]);
        home.Solve(limits);
        return new(
            motions, Middle(motions, [.. limits, Rounding - home.Value], toward), null, Determining(motions, home), gaps)
        {
            Play = PlayOf(motions, gaps, 0),
        };
    }

    /// <summary>True if the solution is determined by places, not by the limits of the motion.</summary>
    public static bool IsBounded(PairMotions motions, LinearProgram solved)
    {
        for (var b = 0; b < solved.Basis.Count; b++)
        {
            if (motions.IsBound(solved.Basis[b]) && solved.Multipliers[b] > NoShare)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>The place with the smallest gap.</summary>
    public static int Smallest(IReadOnlyList<double> gaps)
    {
        var smallest = 0;
        for (var k = 1; k < gaps.Count; k++)
        {
            smallest = gaps[k] < gaps[smallest] ? k : smallest;
        }

        return smallest;
    }

    private static int[] Determining(PairMotions motions, LinearProgram solved) =>
        [.. solved.Basis.Where((row, b) => row < motions.Count && solved.Multipliers[b] > NoShare).Order()];

    // Where the limits leave a choice, the middle of it: a part between rails is drawn where it is along them.
    private static double[] Middle(PairMotions motions, double[] limits, double[]? more)
    {
        var middle = new double[PairMotions.Parts];
        for (var part = 0; part < PairMotions.Parts; part++)
        {
            var (up, down) = (Reach(motions, part, 1, limits, more), Reach(motions, part, -1, limits, more));
            middle[part] = (up.Mm - down.Mm) / 2;
            limits[motions.Count + (2 * part)] = middle[part] + Rounding;
            limits[motions.Count + (2 * part) + 1] = Rounding - middle[part];
        }

        return middle;
    }

    private static PairPlay PlayOf(PairMotions motions, IReadOnlyList<double> gaps, double rounding)
    {
        var limits = motions.Limits(gaps);
        for (var k = 0; k < gaps.Count; k++)
        {
            limits[k] += rounding;
        }

        return new(Find(0, 1), Find(1, 1), Find(2, Angle.FromRadians(1 / motions.ArmMm).Degrees));

        PlayRange? Find(int part, double factor)
        {
            var (up, down) = (Reach(motions, part, 1, limits, null), Reach(motions, part, -1, limits, null));
            return up.IsFree || down.IsFree ? null : new(-down.Mm * factor, up.Mm * factor);
        }
    }

    private static (double Mm, bool IsFree) Reach(PairMotions motions, int part, double direction, double[] limits, double[]? more)
    {
        var along = new double[PairMotions.Parts];
        along[part] = direction;
        var program = motions.Furthest(along, more);
        return (program.Solve(limits) ? program.Value : 0, !IsBounded(motions, program));
    }
}
