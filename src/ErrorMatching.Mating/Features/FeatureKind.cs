using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>
/// A kind of feature: how it is read from a job, edited and sketched. What a feature of the kind does by itself its <see
/// cref="JobFeature"/> says. Both stand in the kind's
/// folder, and nothing outside of it asks which kind a feature has; <see cref="FeatureKinds"/> lists them.
/// </summary>
public abstract class FeatureKind
{
    /// <summary>Only kinds of this project.</summary>
    private protected FeatureKind()
    {
    }

    /// <summary>Its word in jobs, reports and keys of texts: <c>line</c>.</summary>
    public abstract string Word { get; }

    /// <summary>What names of new features begin with: <c>L</c>.</summary>
    public abstract string Letter { get; }

    /// <summary>
    /// How many key points it takes at least: a number for each of its lists of points. A job with one list writes it as it is, one with
    /// several as a list of lists.
    /// </summary>
    public abstract IReadOnlyList<int> LeastPoints { get; }

    /// <summary>True if it is straight at both ends, so that no arc and no bend continues it.</summary>
    public abstract bool IsStraight { get; }

    /// <summary>Keys that a job's features of this kind have beside those of all.</summary>
    public abstract IReadOnlyList<FeatureKey> Keys { get; }

    /// <summary>
    /// The quantities that a report states of it: names with their unit at the end, such as <c>lengthMm</c>, and what people call them.
    /// </summary>
    public abstract IReadOnlyDictionary<string, string> Quantities { get; }

    /// <summary>What a verification compares of it, beside its deviations.</summary>
    public abstract IReadOnlyList<VerifiedQuantity> Verified { get; }

    /// <summary>How a job names its straight elements, for messages: <c>of a line</c>; null if it has none.</summary>
    internal abstract string? ElementWords { get; }

    /// <summary>Its outline through key points as designed, none of them missing.</summary>
    /// <param name="lists">As many lists of points as <see cref="LeastPoints"/> has numbers.</param>
    public abstract IReadOnlyList<Point2> Outline(IReadOnlyList<IReadOnlyList<Point2>> lists);

    /// <summary>A feature of which nothing is known but how many points it has, drawn about y = 0 from x = 0 on.</summary>
    /// <param name="counts">As many numbers of points as <see cref="LeastPoints"/> has.</param>
    /// <param name="step">From one point to the next, mm.</param>
    /// <param name="height">How far it rises or falls, mm.</param>
    public abstract FeatureSketch Sketch(IReadOnlyList<int> counts, double step, double height);

    /// <summary>
    /// What cuts a feature of the kind where it is sought by its key points and where these do not lie one behind the other from its
    /// first motion to its last, as on a closed
    /// contour.
    /// </summary>
    /// <param name="path">The program, interpreted.</param>
    /// <param name="cut">An uninterrupted cut.</param>
    /// <param name="motion">A motion of it that comes nearest to a key point.</param>
    /// <returns>All motions of the cut that belong to the feature; null where its key points bound it.</returns>
    internal virtual FoundPass? WholeOf(NcPath path, FoundPass cut, int motion) => null;

    /// <summary>The word.</summary>
    public sealed override string ToString() => Word;

    /// <summary>Makes the feature of a job that keeps the schema.</summary>
    internal abstract JobFeature Read(FeatureReading reading);
}
