using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>A kind of feature: how it is read from a job, edited and sketched. Its <see cref="JobFeature"/> implements its behavior. Both
/// are in the kind's folder, and no code outside that folder checks a feature's kind. <see cref="FeatureKinds"/> lists the
/// kinds.</summary>
public abstract class FeatureKind
{
    /// <summary>Only this project defines kinds.</summary>
    private protected FeatureKind()
    {
    }

    /// <summary>Its word in jobs, reports and text keys, such as <c>line</c>.</summary>
    public abstract string Word { get; }

    /// <summary>Prefix of the names of new features, such as <c>L</c>.</summary>
    public abstract string Letter { get; }

    /// <summary>Minimum number of key points: one number per list of points. A job writes a single list as it is, and several as a list
    /// of lists.</summary>
    public abstract IReadOnlyList<int> LeastPoints { get; }

    /// <summary>True if both ends are straight, so that no arc or bend continues the feature.</summary>
    public abstract bool IsStraight { get; }

    /// <summary>Job keys of this kind in addition to the common ones.</summary>
    public abstract IReadOnlyList<FeatureKey> Keys { get; }

    /// <summary>The quantities that a report lists: names that end with their unit, such as <c>lengthMm</c>, with their display
    /// names.</summary>
    public abstract IReadOnlyDictionary<string, string> Quantities { get; }

    /// <summary>Quantities that a verification compares in addition to the deviations.</summary>
    public abstract IReadOnlyList<VerifiedQuantity> Verified { get; }

    /// <summary>How a job refers to its straight elements, for messages, such as <c>of a line</c>; null if it has none.</summary>
    internal abstract string? ElementWords { get; }

    /// <summary>Its outline through the key points as designed, none of them missing.</summary>
    /// <param name="lists">One list of points per number in <see cref="LeastPoints"/>.</param>
    public abstract IReadOnlyList<Point2> Outline(IReadOnlyList<IReadOnlyList<Point2>> lists);

    /// <summary>A sketch of a feature with only its point counts known, drawn about y = 0 from x = 0.</summary>
    /// <param name="counts">One point count per number in <see cref="LeastPoints"/>.</param>
    /// <param name="step">Distance between points, mm.</param>
    /// <param name="height">Rise or fall, mm.</param>
    public abstract FeatureSketch Sketch(IReadOnlyList<int> counts, double step, double height);

    /// <summary>The motions that cut a feature of this kind in a search by key points that do not follow one another from its first
    /// motion to its last, as on a closed contour.</summary>
    /// <param name="path">The program, interpreted.</param>
    /// <param name="cut">An uninterrupted cut.</param>
    /// <param name="motion">A motion of it nearest to a key point.</param>
    /// <returns>All motions of the cut that belong to the feature; null if its key points delimit it.</returns>
    internal virtual FoundPass? WholeOf(NcPath path, FoundPass cut, int motion) => null;

    /// <summary>The word.</summary>
    public sealed override string ToString() => Word;

    /// <summary>Creates the feature from a job that conforms to the schema.</summary>
    internal abstract JobFeature Read(FeatureReading reading);
}

/// <summary>A job key that only some kinds of features have.</summary>
/// <param name="Name">The key, such as <c>method</c>.</param>
/// <param name="Words">The words that it accepts; empty for a number, or <c>auto</c> to have it chosen.</param>
public sealed record FeatureKey(string Name, IReadOnlyList<string> Words)
{
    /// <summary>The default: the first of its words; empty for a number, which is then chosen automatically.</summary>
    public string Default => Words.Count > 0 ? Words[0] : "";
}

/// <summary>A sketch of a feature whose position is unknown.</summary>
/// <param name="Points">Its key points in the order of cutting.</param>
/// <param name="Outline">The boundary through them.</param>
/// <param name="WidthMm">Its extent along x.</param>
public sealed record FeatureSketch(IReadOnlyList<Point2> Points, IReadOnlyList<Point2> Outline, double WidthMm);
