using System.Text;
using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Defines the surface, its measurement and the use of its error. A setter writes this file once for a free-form piece.</summary>
/// <remarks>The schema describes every key (<see cref="FreeformTemplate.Schema"/>). Lengths in millimeters, angles in degrees.</remarks>
public sealed record FreeformJob
{
    /// <summary>The code of a job of another kind than the expected one.</summary>
    public const string OtherKind = "other-kind";

    private static readonly Lazy<JsonSchema> Schema = new(() => JsonSchema.Parse(
        Encoding.UTF8.GetBytes(FreeformTemplate.Schema), "freeform.schema.json"));

    internal FreeformJob()
    {
    }

    /// <summary>The file name, as given by the caller.</summary>
    public required string File { get; init; }

    /// <summary>SHA-256 of the file's bytes as 64 lowercase hexadecimal digits.</summary>
    public required string Sha256 { get; init; }

    /// <summary>The name of the job in the report.</summary>
    public required string Name { get; init; }

    /// <summary>The shop's order number; null if the job has none.</summary>
    public string? WorkOrder { get; init; }

    /// <summary>The nominal surface and its open side.</summary>
    public required JobSurface Surface { get; init; }

    /// <summary>The stock on the surface before finishing.</summary>
    public required JobStock Stock { get; init; }

    /// <summary>The ball end mill with its speed and feed.</summary>
    public required JobTool Tool { get; init; }

    /// <summary>How the surface is measured.</summary>
    public required JobMeasuring Measuring { get; init; }

    /// <summary>How the measured points are fitted.</summary>
    public required JobFit Fit { get; init; }

    /// <summary>How the surface is cut.</summary>
    public required JobToolpath Toolpath { get; init; }

    /// <summary>How the error is compensated.</summary>
    public required JobMirror Compensation { get; init; }

    /// <summary>The tolerance that the surface is judged by; null if the job states none.</summary>
    public ProfileTolerance? Profile { get; init; }

    /// <summary>A motion of the whole piece that moves a point off the surface by more than this, in millimeters, asks whether the origin
    /// is right: half of what may be compensated, if not given.</summary>
    public required double CommonMotionMm { get; init; }

    internal IReadOnlyDictionary<string, JsonPlace> Places { get; init; } = new Dictionary<string, JsonPlace>();

    /// <summary>Where the file names another file, a dialect, a template or a tool.</summary>
    /// <param name="path">The JSON path, such as <c>$.surface</c>, <c>$.toolpath.dialect</c>, <c>$.measuring.template</c>,
    /// <c>$.toolpath.tool.name</c> or <c>$.measuring.cutBy</c>.</param>
    /// <returns>Null if the file does not name it.</returns>
    public JsonPlace? PlaceOf(string path) => Places.TryGetValue(path, out var place) ? place : null;

    /// <summary>Parses a job.</summary>
    /// <param name="bytes">JSON with comments and trailing commas allowed.</param>
    /// <param name="file">Name for messages. Relative paths are resolved against it.</param>
    /// <exception cref="InputException">The bytes are not JSON or violate the schema, or the job contradicts itself. The exception
    /// lists all problems.</exception>
    public static FreeformJob Parse(ReadOnlySpan<byte> bytes, string file)
    {
        var document = JsonInput.Read(bytes, file);
        if (document.Kind == JsonItemKind.Object && document.Find("kind") is { Kind: JsonItemKind.Text, Text: "mating" } kind)
        {
            throw new InputException(
                file,
                [
                    JsonRefusal.At(
                        kind,
                        OtherKind,
                        "a mating job",
                        "a free-form job: for two pieces that must fit use errormatch match and verify, or name the job of the surface"),
                ]);
        }

        var problems = Schema.Value.Check(document);
        if (problems.Count > 0)
        {
            throw new InputException(file, problems);
        }

        var reader = new FreeformJobReader(document);
        var job = reader.Read(file, ContentHash.Sha256(bytes));
        return reader.Problems.Count == 0 ? job : throw new InputException(file, reader.Problems);
    }

    /// <summary>Resolves a path of the job: relative paths start from the job's folder, absolute paths are kept.</summary>
    public string PathOf(string path) => PathText.Beside(File, path);
}

/// <summary>The nominal surface of a job.</summary>
/// <param name="File">IGES (.igs, .iges), STEP (.stp, .step) or a grid of points (.csv), relative to the job.</param>
/// <param name="Entity">Name or number, from 1, of the surface if the file has several; null if it has one.</param>
/// <param name="OutsideIsUp">True if the material is below the surface, so that the normal points to +z; false for -z.</param>
public sealed record JobSurface(string File, string? Entity, bool OutsideIsUp);

/// <summary>A ball end mill with its speed and feed.</summary>
/// <param name="DiameterMm">Diameter of the ball.</param>
/// <param name="Flutes">Number of cutting edges.</param>
/// <param name="SpindleRpm">Revolutions per minute.</param>
/// <param name="FeedMmPerMin">Feed along the path.</param>
public sealed record JobTool(double DiameterMm, int Flutes, double SpindleRpm, double FeedMmPerMin)
{
    /// <summary>Radius of the ball in millimeters.</summary>
    public double RadiusMm => DiameterMm / 2;
}

/// <summary>How the measured error is compensated.</summary>
/// <param name="Mirror">True: each place is moved by its own error, mirrored. False: the whole surface is moved by the mean error, like a
/// modified tool radius.</param>
/// <param name="Gain">Compensated share of the error; 1 is the pure mirror.</param>
/// <param name="LimitMm">Largest plausible compensation. The job stops beyond it.</param>
public sealed record JobMirror(bool Mirror, double Gain, double LimitMm)
{
    /// <summary>The largest plausible change of the compensation from one piece of a lot to the next; null for no limit of its
    /// own.</summary>
    public double? StepLimitMm { get; init; }

    /// <summary>The pure mirror, limited to 0.2 mm.</summary>
    public static JobMirror Default { get; } = new(true, 1, 0.2);
}

/// <summary>How measured points are fitted.</summary>
/// <param name="Method">The method of fitting.</param>
/// <param name="OfError">True: the error over (u, v) is fitted and added to the exact nominal surface. False: a surface is fitted to the
/// compensation points, as in the paper.</param>
/// <param name="CurveToleranceMm">Mean distance from points to a fitted curve that determines its degree (1 um in the paper).</param>
public sealed record JobFit(FitMethod Method, bool OfError, double CurveToleranceMm)
{
    /// <summary>The best method for the error field, with 1 um.</summary>
    public static JobFit Default { get; } = new(FitMethod.Best, true, 0.001);
}
