using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Finds cuts that would move with an offset although they belong to no feature.</summary>
internal static class OtherCuts
{
    /// <summary>The first one; -1 if there is none. Up to two cuts at either end of a run of cuts lead to
    /// the contour and from it, and an arc between two features rounds their corner: they do not count.</summary>
    /// <param name="path">The program.</param>
    /// <param name="maps">The features on it.</param>
    /// <param name="moves">True for a motion that moves with the offset.</param>
    public static int First(NcPath path, IReadOnlyList<FeatureMap> maps, Func<int, bool> moves)
    {
        var own = new bool[path.Motions.Length];
        foreach (var pass in maps.SelectMany(m => m.Passes))
        {
            own.AsSpan(pass.First, pass.Last - pass.First + 1).Fill(true);
        }

        for (var i = 0; i < own.Length; i++)
        {
            if (own[i] || !moves(i) || !Cuts(path.Motions[i]) || IsLead(path, own, i))
            {
                continue;
            }

            return i;
        }

        return -1;
    }

    private static bool Cuts(in NcMotion motion) =>
        motion.Has(MotionFlags.Cycle) || (motion.Kind != MotionKind.Rapid && motion.MovesInPlane);

    // One or two cuts between a feature and the end of the run of cuts, or an arc between two features.
    private static bool IsLead(NcPath path, bool[] own, int motion) =>
        !path.Motions[motion].Has(MotionFlags.Cycle)
            && (LeadsTo(path, own, motion, 1)
                || LeadsTo(path, own, motion, -1)
                || (path.Motions[motion].IsArc && IsOwn(own, motion - 1) && IsOwn(own, motion + 1)));

    private static bool LeadsTo(NcPath path, bool[] own, int motion, int step) => IsOwn(own, motion + step)
        ? EndsRun(path, motion, -step) || (!IsOwn(own, motion - step) && EndsRun(path, motion - step, -step))
        : EndsRun(path, motion, -step) && !EndsRun(path, motion, step) && IsOwn(own, motion + (2 * step));

    private static bool IsOwn(bool[] own, int motion) => motion >= 0 && motion < own.Length && own[motion];

    private static bool EndsRun(NcPath path, int motion, int step) =>
        motion + step < 0 || motion + step >= path.Motions.Length || !Cuts(path.Motions[motion + step]);
}
