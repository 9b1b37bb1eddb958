using System.Text.Json.Serialization;
using ErrorMatching.Mating;

namespace ErrorMatching.Jobs;

/// <summary>A feature of the mating boundary as it is being typed.</summary>
public sealed record FeatureDraft
{
    /// <summary>What shape it is.</summary>
    public FeatureKind Kind { get; init; }

    /// <summary>Its name.</summary>
    public string Name { get; init; } = "";

    /// <summary>Its key points in the order of cutting: one list, or for a triangle one for each of its two flanks.</summary>
    public IReadOnlyList<IReadOnlyList<PointDraft>> Flanks { get; init; } = [[]];

    /// <summary>Selectors of the blocks that cut it, with commas between them.</summary>
    public string Blocks { get; init; } = "";

    /// <summary>The selectors of blocks that stand there, each for itself.</summary>
    [JsonIgnore]
    public IReadOnlyList<string> BlockList => DraftList.Blocks(Blocks);

    /// <summary><c>stated</c> where <see cref="Lower"/> and <see cref="Upper"/> hold, else <c>chain:worst-case</c> or <c>chain:rss</c>.</summary>
    public string Tolerance { get; init; } = Stated;

    /// <summary>Lower limit of the deviation, mm.</summary>
    public string Lower { get; init; } = "";

    /// <summary>Upper limit of the deviation, mm.</summary>
    public string Upper { get; init; } = "";

    /// <summary>The plane of its points: <c>XY</c>, <c>ZX</c> or <c>YZ</c>.</summary>
    public string Plane { get; init; } = "XY";

    /// <summary>How a line is fitted: <c>tls</c> or <c>ols</c>.</summary>
    public string Method { get; init; } = "tls";

    /// <summary>Degree of a curve; empty or <c>auto</c> to have it chosen.</summary>
    public string Degree { get; init; } = "";

    /// <summary>Weight against overfitting of a curve; empty or <c>auto</c> to have it chosen.</summary>
    public string Ridge { get; init; } = "";

    /// <summary>The word for limits that are stated.</summary>
    public const string Stated = "stated";

    /// <summary>All its points in the order of cutting.</summary>
    [JsonIgnore]
    public IEnumerable<PointDraft> Points => Flanks.SelectMany(f => f);

    /// <summary>A new feature with as few points as its kind takes, whose labels no point of the draft has.</summary>
    /// <param name="kind">Its kind.</param>
    /// <param name="name">Its name.</param>
    /// <param name="draft">The draft that it is for.</param>
    public static FeatureDraft New(FeatureKind kind, string name, MatingDraft draft)
    {
        ArgumentNullException.ThrowIfNull(draft);
        var next = draft.NextLabel;
        int[] counts = kind switch { FeatureKind.Line => [2], FeatureKind.Triangle => [2, 2], _ => [3] };
        return new() { Kind = kind, Name = name, Flanks = [.. counts.Select(c => (IReadOnlyList<PointDraft>)[.. Enumerable.Range(0, c).Select(_ => new PointDraft(PointLabel.Of(next++)))])] };
    }
}
