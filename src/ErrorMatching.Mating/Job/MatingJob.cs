using System.Text;
using System.Text.Json.Nodes;
using ErrorMatching.Geometry;
using ErrorMatching.Json;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>The file that a setter writes once for a mating: what is measured, how it is judged, and which program blocks of the
/// counterpart follow.</summary>
/// <remarks>The schema (<see cref="JobTemplate.Schema"/>) describes every key. Lengths are in millimeters, angles in degrees.</remarks>
public sealed record MatingJob
{
    /// <summary>The code of a job of another kind than the expected one.</summary>
    public const string OtherKind = "other-kind";

    private static readonly Lazy<JsonSchema> WholeSchema = new(() => JsonSchema.Parse(
        Encoding.UTF8.GetBytes(JobTemplate.Schema), "mating.schema.json"));

    private static readonly Lazy<JsonSchema> SchemaWithoutBlocks = new(WithoutBlocks);

    internal MatingJob()
    {
    }

    /// <summary>The schema that jobs are checked against (<see cref="JobTemplate.Schema"/>).</summary>
    public static JsonSchema Schema => WholeSchema.Value;

    /// <summary>The file, as the caller named it.</summary>
    public required string File { get; init; }

    /// <summary>SHA-256 of the file's bytes as 64 lower-case hexadecimal digits.</summary>
    public required string Sha256 { get; init; }

    /// <summary>The job's name in reports.</summary>
    public required string Name { get; init; }

    /// <summary>The shop's order number; null if the job has none.</summary>
    public string? WorkOrder { get; init; }

    /// <summary>The files of the part.</summary>
    public required JobPart Part { get; init; }

    /// <summary>The gauge's file format and accuracy.</summary>
    public required JobGauge Gauge { get; init; }

    /// <summary>How measured points are moved before they are compared.</summary>
    public required JobAlignment Alignment { get; init; }

    /// <summary>The point whose measured position must match its design; null if none is checked.</summary>
    public JobOriginCheck? OriginCheck { get; init; }

    /// <summary>The mating boundary in the order of cutting; at least one feature.</summary>
    public required IReadOnlyList<JobFeature> Features { get; init; }

    /// <summary>Labels of key points that somebody took out of the job because their reading did not fit; no feature has them.</summary>
    public IReadOnlyList<string> Without { get; init; } = [];

    /// <summary>The largest motion of the part as a whole that is taken for the part's own, mm; null for the largest limit, and for any if
    /// work offsets are allowed. A larger one asks whether the origin is right.</summary>
    public double? CommonMotionMm { get; init; }

    /// <summary>The piece to be cut, and its program.</summary>
    public required JobCounterpart Counterpart { get; init; }

    /// <summary>How deviations are compensated.</summary>
    public required JobCompensation Compensation { get; init; }

    /// <summary>By what a correction may be made.</summary>
    public required JobCorrection Correction { get; init; }

    /// <summary>How points are accepted near their limits.</summary>
    public required DecisionRule Rule { get; init; }

    /// <summary>Combined standard uncertainty of the deviation that decisions are based on: the gauge's, because feed-forward compares a
    /// measured point with an exact one; times the square root of 2 in feedback, which compares two measured points.</summary>
    public double DeviationUncertaintyMm =>
        Gauge.Uncertainty.CombinedMm * (Compensation.From == CompensationSource.Counterpart ? Math.Sqrt(2) : 1);

    /// <summary>The part of it that all points share, as a growth of the outline.</summary>
    public double DeviationUncertaintySharedMm =>
        Gauge.Uncertainty.SharedMm * (Compensation.From == CompensationSource.Counterpart ? Math.Sqrt(2) : 1);

    /// <summary>The dimensions that add up to the mating dimension; null if the job has none.</summary>
    public ToleranceChain? Chain { get; init; }

    /// <summary>Rules that distinguish measurements of the part from those of the counterpart; null if the job has none.</summary>
    public SourceRules? Recognition { get; init; }

    /// <summary>Comparisons in addition to those that every feature has.</summary>
    public required IReadOnlyList<JobComparison> Verify { get; init; }

    /// <summary>Where the job names the measured counterpart; null if it names none.</summary>
    public JsonPlace? MeasuredPlace { get; init; }

    /// <summary>Labels of all key points in the order of cutting, each once.</summary>
    public IReadOnlyList<string> KeyPoints => [.. Features.SelectMany(f => f.Points)];

    /// <summary>Labels of all points that the theoretical and measured files must contain: the key points, the datum's points and the
    /// checked origin.</summary>
    public IReadOnlyList<string> NeededPoints =>
        [
            .. KeyPoints.Concat(
                new[] { Alignment.Origin, Alignment.Direction, OriginCheck?.Point }.OfType<string>()).Distinct(StringComparer.Ordinal)];

    /// <summary>Reads a job from a file.</summary>
    /// <param name="path">The file.</param>
    /// <exception cref="InputException">As of <see cref="Parse"/>.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">Access to the file is denied.</exception>
    public static MatingJob Read(string path) => Parse(JsonInput.Load(path), path);

    /// <summary>Reads a job from bytes.</summary>
    /// <param name="bytes">JSON with comments and trailing commas allowed.</param>
    /// <param name="file">File name for messages, and base of relative paths.</param>
    /// <exception cref="InputException">The bytes are not JSON, violate the schema, or the job contradicts itself; the exception lists all
    /// problems.</exception>
    public static MatingJob Parse(ReadOnlySpan<byte> bytes, string file) => Checked(bytes, file, Schema);

    /// <summary>Reads a job whose features may not name their blocks yet, because these are still being searched for. Do not match with
    /// it.</summary>
    /// <param name="bytes">JSON with comments and trailing commas allowed.</param>
    /// <param name="file">File name for messages, and base of relative paths.</param>
    /// <exception cref="InputException">As for <see cref="Parse"/>, except for missing blocks.</exception>
    public static MatingJob ParseWithoutBlocks(ReadOnlySpan<byte> bytes, string file) => Checked(bytes, file, SchemaWithoutBlocks.Value);

    private static MatingJob Checked(ReadOnlySpan<byte> bytes, string file, JsonSchema schema)
    {
        var document = JsonInput.Read(bytes, file);
        if (document.Kind == JsonItemKind.Object && document.Find("kind") is { Kind: JsonItemKind.Text, Text: "freeform" } kind)
        {
            throw new InputException(
                file,
                [
                    JsonRefusal.At(
                        kind,
                        OtherKind,
                        "a free-form job",
                        "a mating job: for a surface use errormatch surface, or name the job of the two pieces that must fit"),
                ]);
        }

        var problems = schema.Check(document);
        if (problems.Count > 0)
        {
            throw new InputException(file, problems);
        }

        var reader = new JobReader(document);
        var job = reader.Read(file, ContentHash.Sha256(bytes));
        return reader.Problems.Count == 0 ? job : throw new InputException(file, reader.Problems);
    }

    /// <summary>Resolves a path of the job: a relative path starts from the job's folder, an absolute one is unchanged.</summary>
    public string PathOf(string path) => PathText.Beside(File, path);

    private static JsonSchema WithoutBlocks()
    {
        var schema = JsonNode.Parse(JobTemplate.Schema)!;
        schema["$defs"]!["blocks"]!.AsObject().Remove("minItems");
        foreach (var feature in schema["properties"]!["features"]!["items"]!["oneOf"]!.AsArray())
        {
            feature!["required"]!.AsArray().RemoveAll(k => k!.GetValue<string>() == "blocks");
        }

        return JsonSchema.Parse(Encoding.UTF8.GetBytes(schema.ToJsonString()), "mating.schema.json");
    }
}

/// <summary>The files of the cut and measured piece, as the job writes them.</summary>
/// <param name="Theoretical">The key points as designed.</param>
/// <param name="Measured">The same points as measured.</param>
public sealed record JobPart(string Theoretical, string Measured);
