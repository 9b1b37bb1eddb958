using System.Text.Json;
using System.Text.Json.Serialization;

namespace ErrorMatching.Jobs;

/// <summary>A mating job as it is being edited: every field as the text that was typed, right or wrong. It is never changed;
/// an edit makes another one.</summary>
/// <remarks>What is wrong with it <see cref="MatingDraftCheck"/> finds out by the readers that read the job's files;
/// <see cref="MatingDraftFiles"/> writes and reads these.</remarks>
public sealed record MatingDraft
{
    /// <summary>What the report calls the job: the workpiece.</summary>
    public string Name { get; init; } = "";

    /// <summary>The shop's number of the order; empty for none.</summary>
    public string WorkOrder { get; init; } = "";

    /// <summary>File of the theoretical points, relative to the job.</summary>
    public string TheoreticalFile { get; init; } = "theoretical.csv";

    /// <summary>File of the measured part that is used where none is given, relative to the job.</summary>
    public string MeasuredFile { get; init; } = "part.csv";

    /// <summary>The gauge.</summary>
    public GaugeDraft Gauge { get; init; } = new();

    /// <summary>How measured points are moved.</summary>
    public AlignmentDraft Alignment { get; init; } = new();

    /// <summary>Label of the point that must be measured where it is designed; empty for none.</summary>
    public string OriginPoint { get; init; } = "";

    /// <summary>How far it may be away, mm.</summary>
    public string OriginLimit { get; init; } = "";

    /// <summary>The boundary in the order of cutting.</summary>
    public IReadOnlyList<FeatureDraft> Features { get; init; } = [];

    /// <summary>Theoretical points that belong to no feature.</summary>
    public IReadOnlyList<PointDraft> OtherPoints { get; init; } = [];

    /// <summary>The piece to be cut.</summary>
    public CounterpartDraft Counterpart { get; init; } = new();

    /// <summary>What is made of the deviations.</summary>
    public CompensationDraft Compensation { get; init; } = new();

    /// <summary>The tolerance chain.</summary>
    public IReadOnlyList<ChainLinkDraft> Chain { get; init; } = [];

    /// <summary>Comparisons beside those that every feature has.</summary>
    public IReadOnlyList<ComparisonDraft> Comparisons { get; init; } = [];

    /// <summary>The rules that tell the part's measurements from the counterpart's, as the job has them; empty for none.
    /// They are kept and not edited.</summary>
    public string RecognitionJson { get; init; } = "";

    /// <summary>Where an editor finds the schema, as the job has it; empty for nowhere.</summary>
    public string SchemaUri { get; init; } = "";

    /// <summary>A program that was imported and takes the place of the job's; null while the job's own stays.</summary>
    public DraftProgram? Program { get; init; }

    /// <summary>True for another job than the one in whose place it is: it was begun from an empty draft, and is not saved yet.</summary>
    public bool IsBegunAnew { get; init; }

    /// <summary>All points, those of features first.</summary>
    [JsonIgnore]
    public IEnumerable<PointDraft> Points => Features.SelectMany(f => f.Points).Concat(OtherPoints);

    /// <summary>The smallest number behind those of all labels.</summary>
    [JsonIgnore]
    internal int NextLabel => Points.Select(p => PointLabel.NumberOf(p.Label)).DefaultIfEmpty().Max() + 1;

    /// <summary>
    /// False for a draft of a file that somebody else wrote: with lists or keys that a feature has not, or with nothing in a list.
    /// </summary>
    [JsonIgnore]
    internal bool IsWhole =>
        Features.All(
            f => f is not null
                && f.Flanks.Count == f.Kind.LeastPoints.Count
                && f.Kind.Keys.All(k => f.Keys.ContainsKey(k.Name))
                && f.Flanks.All(k => k is not null && !k.Contains(null!)))
        && !OtherPoints.Contains(null!) && !Chain.Contains(null!) && !Comparisons.Contains(null!) && !Gauge.Contributions.Contains(null!);

    /// <summary>The draft as JSON, without the bytes of an imported program.</summary>
    public byte[] ToJson() => JsonSerializer.SerializeToUtf8Bytes(this, DraftJson.Options);

    /// <summary>True if another draft has the same text in every field, and the same program.</summary>
    public bool IsSame(MatingDraft other)
    {
        ArgumentNullException.ThrowIfNull(other);
        return ReferenceEquals(this, other) || ToJson().AsSpan().SequenceEqual(other.ToJson());
    }

    /// <summary>An empty draft in the place of this one: what belongs to the job's place (files, dialect, format, rules) stays. A
    /// counterpart that was measured does not: it is of the piece that was there before.</summary>
    public MatingDraft Emptied() => new()
    {
        TheoreticalFile = TheoreticalFile,
        MeasuredFile = MeasuredFile,
        Gauge = new() { Format = Gauge.Format, FormatJson = Gauge.FormatJson },
        Counterpart = new() { Dialect = Counterpart.Dialect },
        RecognitionJson = RecognitionJson,
        SchemaUri = SchemaUri,
        IsBegunAnew = true,
    };

    /// <summary>The draft with as many points in a flank of a feature:
    /// new ones get numbers that no point has, those too many leave from the end.</summary>
    /// <param name="feature">Number of the feature, from 0.</param>
    /// <param name="flank">Number of the flank, from 0.</param>
    /// <param name="count">How many points, 0 or more.</param>
    public MatingDraft WithPoints(int feature, int flank, int count)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(count);
        var (was, next) = (Features[feature].Flanks[flank], NextLabel);
        IReadOnlyList<PointDraft> now = [
            .. was.Take(count), .. Enumerable.Range(0, Math.Max(0, count - was.Count)).Select(_ => new PointDraft(PointLabel.Of(next++)))];
        return WithFeature(feature, f => f with { Flanks = f.Flanks.Replaced(flank, now) });
    }

    /// <summary>The draft with the limits of the first feature, or their source, at all features.</summary>
    public MatingDraft WithSameLimits() => this with
    {
        Features = [
            .. Features.Select(f => f with { Tolerance = Features[0].Tolerance, Lower = Features[0].Lower, Upper = Features[0].Upper })]
    };

    /// <summary>The draft with coordinates and labels of rows at its points; what a row does not have stays.</summary>
    /// <param name="rowOf">The row of a point, by its number among all points and as it is; null for none.</param>
    internal MatingDraft WithRows(Func<int, PointDraft, PointDraft?> rowOf)
    {
        var next = 0;
        return this with
        {
            Features = [
                .. Features.Select(f => f with { Flanks = [.. f.Flanks.Select(k => (IReadOnlyList<PointDraft>)[.. k.Select(Filled)])] })],
            OtherPoints = [.. OtherPoints.Select(Filled)],
        };

        PointDraft Filled(PointDraft point) => rowOf(next++, point) is { } row
            ? new(row.Label.Length > 0 ? row.Label : point.Label, row.X, row.Y, row.Z.Length > 0 ? row.Z : point.Z) : point;
    }

    /// <summary>The draft with a feature changed.</summary>
    /// <param name="feature">Number of the feature, from 0.</param>
    /// <param name="change">What it becomes.</param>
    public MatingDraft WithFeature(int feature, Func<FeatureDraft, FeatureDraft> change)
    {
        ArgumentNullException.ThrowIfNull(change);
        return this with { Features = Features.Replaced(feature, change(Features[feature])) };
    }
}
