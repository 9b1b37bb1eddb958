using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>One uninterrupted cut along a feature: consecutive motions in its plane, possibly with zero-length blocks between them. A
/// feature cut at several depths has several passes.</summary>
/// <param name="First">Position of the first motion in the path.</param>
/// <param name="Last">Position of the last motion in the path.</param>
/// <param name="Starts">Length of the nominal boundary before each motion, and at the end of the last.</param>
/// <param name="Feet">The feature's key points, in the order of the job.</param>
public sealed record FeaturePass(int First, int Last, IReadOnlyList<double> Starts, IReadOnlyList<KeyPointFoot> Feet)
{
    /// <summary>Positions of the motions with a length, ascending; includes the first and the last of the pass.</summary>
    internal static IEnumerable<int> Moving(NcPath path, int first, int last) =>
        Enumerable.Range(first, last - first + 1).Where(i => path.Motions[i].MovesInPlane);

    /// <summary>Length of the nominal boundary from the start of the pass to a foot, mm.</summary>
    public double Along(KeyPointFoot foot)
    {
        ArgumentNullException.ThrowIfNull(foot);
        var (from, to) = (Starts[foot.Motion - First], Starts[foot.Motion - First + 1]);
        return from + ((to - from) * foot.Fraction);
    }
}

/// <summary>Motions that cut a sought boundary in one pass.</summary>
/// <param name="First">Position of the first motion in the path.</param>
/// <param name="Last">Position of the last motion in the path.</param>
public sealed record FoundPass(int First, int Last);
