using System.Text.Json;
using System.Text.Json.Serialization;

namespace ErrorMatching.Jobs;

/// <summary>A mating job while it is edited: every field is the text as typed, right or wrong. Immutable; an edit creates a new
/// draft.</summary>
/// <remarks><see cref="MatingDraftCheck"/> checks it with the readers of the job's files; <see cref="MatingDraftFiles"/> writes and reads
/// these files.</remarks>
public sealed record MatingDraft
{
    /// <summary>The job's name in reports: the workpiece.</summary>
    public string Name { get; init; } = "";

    /// <summary>The shop's order number; empty for none.</summary>
    public string WorkOrder { get; init; } = "";

    /// <summary>File of the theoretical points, relative to the job.</summary>
    public string TheoreticalFile { get; init; } = "theoretical.csv";

    /// <summary>Default file of the measured part, relative to the job.</summary>
    public string MeasuredFile { get; init; } = "part.csv";

    /// <summary>The gauge.</summary>
    public GaugeDraft Gauge { get; init; } = new();

    /// <summary>The alignment of measured points.</summary>
    public AlignmentDraft Alignment { get; init; } = new();

    /// <summary>Label of the point whose measured position must match its design; empty for none.</summary>
    public string OriginPoint { get; init; } = "";

    /// <summary>Its allowed distance, mm.</summary>
    public string OriginLimit { get; init; } = "";

    /// <summary>The boundary in the order of cutting.</summary>
    public IReadOnlyList<FeatureDraft> Features { get; init; } = [];

    /// <summary>Theoretical points without a feature.</summary>
    public IReadOnlyList<PointDraft> OtherPoints { get; init; } = [];

    /// <summary>The piece to be cut.</summary>
    public CounterpartDraft Counterpart { get; init; } = new();

    /// <summary>How deviations are compensated.</summary>
    public CompensationDraft Compensation { get; init; } = new();

    /// <summary>How points are accepted near their limits.</summary>
    public DecisionDraft Decision { get; init; } = new();

    /// <summary>The tolerance chain.</summary>
    public IReadOnlyList<ChainLinkDraft> Chain { get; init; } = [];

    /// <summary>Comparisons in addition to those that every feature has.</summary>
    public IReadOnlyList<ComparisonDraft> Comparisons { get; init; } = [];

    /// <summary>The rules that distinguish the part's measurements from the counterpart's, as in the job; empty for none. Preserved but
    /// not editable.</summary>
    public string RecognitionJson { get; init; } = "";

    /// <summary>The schema reference for editors, as in the job; empty for none.</summary>
    public string SchemaUri { get; init; } = "";

    /// <summary>An imported program that replaces the job's; null to keep the job's own.</summary>
    public DraftProgram? Program { get; init; }

    /// <summary>True for a new job that was started from an empty draft in another job's place and is not saved yet.</summary>
    public bool IsBegunAnew { get; init; }

    /// <summary>All points, those of features first.</summary>
    [JsonIgnore]
    public IEnumerable<PointDraft> Points => Features.SelectMany(f => f.Points).Concat(OtherPoints);

    /// <summary>The smallest number greater than those of all labels.</summary>
    [JsonIgnore]
    internal int NextLabel => Points.Select(p => PointLabel.NumberOf(p.Label)).DefaultIfEmpty().Max() + 1;

    /// <summary>False for a draft from an external file with a wrong number of lists, a missing key, or a null entry in a list.</summary>
    [JsonIgnore]
    internal bool IsWhole =>
        Features.All(
            f => f is not null
                && f.Flanks.Count == f.Kind.LeastPoints.Count
                && f.Kind.Keys.All(k => f.Keys.ContainsKey(k.Name))
                && f.Flanks.All(k => k is not null && !k.Contains(null!)))
        && !OtherPoints.Contains(null!) && !Chain.Contains(null!) && !Comparisons.Contains(null!) && !Gauge.Contributions.Contains(null!);

    /// <summary>The draft as JSON, without the bytes of an imported program.</summary>
    public byte[] ToJson() => JsonSerializer.SerializeToUtf8Bytes(this, DraftJson.Default.MatingDraft);

    /// <summary>True if another draft has the same text in every field, and the same program.</summary>
    public bool IsSame(MatingDraft other)
    {
        ArgumentNullException.ThrowIfNull(other);
        return ReferenceEquals(this, other) || ToJson().AsSpan().SequenceEqual(other.ToJson());
    }

    /// <summary>An empty draft in this job's place. Settings of the place (files, dialect, format, rules) are kept. The measured
    /// counterpart is not, because it belongs to the previous piece.</summary>
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

    /// <summary>The draft with a given number of points in a flank. New points get unused numbers; surplus points are removed from the
    /// end.</summary>
    /// <param name="feature">Index of the feature, from 0.</param>
    /// <param name="flank">Index of the flank, from 0.</param>
    /// <param name="count">Number of points, 0 or more.</param>
    public MatingDraft WithPoints(int feature, int flank, int count)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(count);
        var (was, next) = (Features[feature].Flanks[flank], NextLabel);
        IReadOnlyList<PointDraft> now = [
            .. was.Take(count), .. Enumerable.Range(0, Math.Max(0, count - was.Count)).Select(_ => new PointDraft(PointLabel.Of(next++)))];
        return WithFeature(feature, f => f with { Flanks = f.Flanks.Replaced(flank, now) });
    }

    /// <summary>The draft with the first feature's limits, or their source, for all features.</summary>
    public MatingDraft WithSameLimits() => this with
    {
        Features = [
            .. Features.Select(f => f with { Tolerance = Features[0].Tolerance, Lower = Features[0].Lower, Upper = Features[0].Upper })]
    };

    /// <summary>The draft with coordinates and labels from rows; values that a row lacks stay.</summary>
    /// <param name="rowOf">The row of a point, given its index among all points and the point; null for none.</param>
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

    /// <summary>The draft with a changed feature.</summary>
    /// <param name="feature">Index of the feature, from 0.</param>
    /// <param name="change">The change.</param>
    public MatingDraft WithFeature(int feature, Func<FeatureDraft, FeatureDraft> change)
    {
        ArgumentNullException.ThrowIfNull(change);
        return this with { Features = Features.Replaced(feature, change(Features[feature])) };
    }
}

/// <summary>The alignment of measured points, as typed.</summary>
/// <param name="Kind"><c>none</c>, <c>datum</c> or <c>best-fit</c>.</param>
/// <param name="Origin">Label of the datum's origin.</param>
/// <param name="Direction">Label of the point that gives the datum's direction.</param>
/// <param name="LockX">True if a best fit must not shift along the first axis.</param>
/// <param name="LockY">True if a best fit must not shift along the second axis.</param>
/// <param name="LockRotation">True if a best fit must not rotate.</param>
public sealed record AlignmentDraft(
    string Kind = "none", string Origin = "", string Direction = "", bool LockX = false, bool LockY = false, bool LockRotation = false);

/// <summary>How deviations are compensated, as typed. An empty field means the job's default.</summary>
/// <param name="From"><c>part</c> or <c>counterpart</c>.</param>
/// <param name="Gain">Fraction of a deviation to compensate.</param>
/// <param name="Amount"><c>whole</c> or <c>excess</c>.</param>
/// <param name="Along"><c>normal</c> or <c>vector</c>.</param>
/// <param name="Limit">A larger deviation stops the job, mm.</param>
public sealed record CompensationDraft(
    string From = "part", string Gain = "", string Amount = "whole", string Along = "normal", string Limit = "");

/// <summary>How points are accepted near their limits, as typed. An empty field means the job's default.</summary>
/// <param name="Rule"><c>simple</c> or <c>guard-band</c>.</param>
/// <param name="Risk">Largest risk at an acceptance limit, %; of guard bands only.</param>
public sealed record DecisionDraft(string Rule = DecisionDraft.Simple, string Risk = "")
{
    /// <summary>The rule without guard bands, which is the default.</summary>
    public const string Simple = "simple";
}

/// <summary>A comparison in addition to those that every feature has, as typed.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Quantity"><c>angle</c>, <c>deviation</c> or <c>deviation-x</c>.</param>
/// <param name="Of">Two elements of an angle, or point labels, separated by commas; ranges are allowed.</param>
public sealed record ComparisonDraft(string Name = "", string Quantity = "angle", string Of = "");

/// <summary>A dimension of the tolerance chain, as typed.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Nominal">Its nominal value, mm.</param>
/// <param name="Lower">Its lower limit, mm.</param>
/// <param name="Upper">Its upper limit, mm.</param>
/// <param name="Sign"><c>1</c> if a larger dimension lengthens the chain, <c>-1</c> if it shortens it.</param>
public sealed record ChainLinkDraft(string Name = "", string Nominal = "", string Lower = "", string Upper = "", string Sign = "1");

/// <summary>Copies of immutable lists with one item changed.</summary>
public static class DraftLists
{
    /// <summary>The list with one item replaced.</summary>
    public static IReadOnlyList<T> Replaced<T>(this IReadOnlyList<T> list, int index, T item)
    {
        ArgumentNullException.ThrowIfNull(list);
        var copy = list.ToArray();
        copy[index] = item;
        return copy;
    }

    /// <summary>The list with one item removed.</summary>
    public static IReadOnlyList<T> Without<T>(this IReadOnlyList<T> list, int index)
    {
        ArgumentNullException.ThrowIfNull(list);
        return [.. list.Take(index), .. list.Skip(index + 1)];
    }
}
