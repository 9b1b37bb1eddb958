using System.Globalization;
using System.Text.Json;
using System.Text.Json.Nodes;
using System.Text.Json.Serialization;
using System.Text.RegularExpressions;
using ErrorMatching.Json;
using ErrorMatching.Mating;

namespace ErrorMatching.Jobs;

/// <summary>A mating job while it is edited: the job's document, with every field the text as typed, right or wrong. Immutable; an edit
/// creates a new draft. Keys that nobody edits stay as they are.</summary>
/// <remarks>Fields are named by the paths of the job, such as <c>$.gauge.uncertaintyMm</c> (<see cref="DraftPaths"/>). Key points have a
/// file of their own, so they are beside the document. <see cref="MatingDraftCheck"/> checks a draft with the readers of the job's files;
/// <see cref="MatingDraftFiles"/> writes and reads these files.</remarks>
public sealed partial record MatingDraft
{
    /// <summary>The key of the features.</summary>
    internal const string FeaturesKey = "features";

    private static readonly SchemaPlace Place = MatingJob.Schema.Root;

    /// <summary>All keys of the job but those of its features.</summary>
    [JsonRequired]
    public DraftDocument Document { get; init; } = DraftDocument.Empty
        .With(Place, DraftPaths.Theoretical, "theoretical.csv")
        .With(Place, DraftPaths.Measured, "part.csv")
        .With(Place, DraftPaths.Format, "points");

    /// <summary>The boundary in the order of cutting.</summary>
    public IReadOnlyList<FeatureDraft> Features { get; init; } = [];

    /// <summary>Theoretical points without a feature.</summary>
    public IReadOnlyList<PointDraft> OtherPoints { get; init; } = [];

    /// <summary>The text at a path: as typed; the texts of a list with commas between them; an object as JSON. Empty if there is
    /// none.</summary>
    /// <param name="path">The path.</param>
    public string this[string path] => InFeature(path) is var (feature, key) ? Features[feature][key] : Document[path];

    /// <summary>The job's name in reports: the workpiece.</summary>
    [JsonIgnore]
    public string Name
    {
        get => this[DraftPaths.Name];
        init => Document = Document.With(Place, DraftPaths.Name, value);
    }

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

    /// <summary>False for a draft from an external file with a wrong feature, or a null entry in a list.</summary>
    [JsonIgnore]
    internal bool IsWhole => Features.All(f => f is { IsWhole: true }) && !OtherPoints.Contains(null!);

    /// <summary>The word at a path; without one, the first that the schema allows, which then holds.</summary>
    /// <param name="path">The path of a value for which the schema lists words.</param>
    public string Word(string path) => this[path] is { Length: > 0 } word ? word : PlaceOf(path).Words[0];

    /// <summary>What the schema says of the value at a path.</summary>
    /// <param name="path">The path.</param>
    public static SchemaPlace PlaceOf(string path) => DraftDocument.PlaceOf(Place, path);

    /// <summary>The draft with another text at a path. An empty text takes the key away.</summary>
    /// <param name="path">The path.</param>
    /// <param name="text">The text as typed.</param>
    public MatingDraft With(string path, string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        return InFeature(path) is var (feature, key)
            ? WithFeature(feature, f => f.With(key, text)) : this with { Document = Document.With(Place, path, text) };
    }

    /// <summary>The draft without what it has at a path.</summary>
    /// <param name="path">The path; not one of a feature.</param>
    public MatingDraft Without(string path) => With(path, "");

    /// <summary>The draft with what another one has at some paths, or without them.</summary>
    /// <param name="from">The other draft.</param>
    /// <param name="paths">The paths; not of features.</param>
    public MatingDraft With(MatingDraft from, params IEnumerable<string> paths)
    {
        ArgumentNullException.ThrowIfNull(from);
        return this with { Document = paths.Aggregate(Document, (to, path) => to.With(Place, path, from.Document)) };
    }

    /// <summary>The number of items of the list at a path; 0 if there is none.</summary>
    /// <param name="path">The path; not one of a feature.</param>
    public int Count(string path) => Document.Count(path);

    /// <summary>The draft with one more item without any text at the end of a list.</summary>
    /// <param name="list">The path of the list; not one of a feature.</param>
    public MatingDraft WithItem(string list) => this with { Document = Document.WithItem(Place, list) };

    /// <summary>The draft without an item of a list, and without the list if it was the last.</summary>
    /// <param name="list">The path of the list; not one of a feature.</param>
    /// <param name="index">Index of the item, from 0.</param>
    public MatingDraft WithoutItem(string list, int index) => this with { Document = Document.WithoutItem(Place, list, index) };

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
    public MatingDraft Emptied() =>
        new MatingDraft { IsBegunAnew = true }.With(
            this,
            DraftPaths.Schema,
            DraftPaths.Theoretical,
            DraftPaths.Measured,
            DraftPaths.Format,
            DraftPaths.Dialect,
            DraftPaths.Recognition);

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
    public MatingDraft WithSameLimits() => this with { Features = [.. Features.Select(f => f.WithLimitsOf(Features[0]))] };

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

    /// <summary>A draft of a job's document, with its points from their own file.</summary>
    /// <param name="root">The job.</param>
    /// <param name="points">The points.</param>
    internal static MatingDraft Read(JsonItem root, IReadOnlyList<PointDraft> points)
    {
        var byLabel = points.ToDictionary(p => p.Label, StringComparer.Ordinal);
        var document = (JsonObject)JsonNode.Parse(root.ToJson())!;
        document[FeaturesKey] = new JsonArray();
        FeatureDraft[] features = [
            .. root[FeaturesKey].Items.Select(f => FeatureDraft.Read(f, l => byLabel.GetValueOrDefault(l) ?? new PointDraft(l)))];
        var used = features.SelectMany(f => f.Points).Select(p => p.Label).ToHashSet(StringComparer.Ordinal);
        return new()
        {
            Document = new(document),
            Features = features,
            OtherPoints = [.. points.Where(p => !used.Contains(p.Label))],
        };
    }

    /// <summary>The job's document.</summary>
    internal JsonObject Write()
    {
        var job = Document.Copy();
        DraftDocument.Put(job, Place, FeaturesKey, new JsonArray([.. Features.Select(f => f.Write())]));
        DraftDocument.Finish(job, Place);
        return job;
    }

    private static (int Feature, string Key)? InFeature(string path) =>
        OfFeature().Match(path) is { Success: true } match
            ? (int.Parse(match.Groups["feature"].Value, CultureInfo.InvariantCulture), match.Groups["key"].Value)
            : null;

    [GeneratedRegex(
        @"^\$\." + FeaturesKey + @"\[(?<feature>[0-9]{1,9})\]\.(?<key>.+)$",
        RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture,
        Timeout.Infinite)]
    private static partial Regex OfFeature();
}

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
