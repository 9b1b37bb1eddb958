using System.Security.Cryptography;
using System.Text;
using ErrorMatching.Json;

namespace ErrorMatching.Freeform;

/// <summary>Which surface is cut, how it is measured, and what is made of its error: the file that a setter writes once for a free-form piece.</summary>
/// <remarks>Every key of the file is described by its schema (<see cref="FreeformTemplate.Schema"/>). Lengths in millimetres, angles in degrees.</remarks>
public sealed record FreeformJob
{
    private static readonly Lazy<JsonSchema> Schema = new(() => JsonSchema.Parse(Encoding.UTF8.GetBytes(FreeformTemplate.Schema), "freeform.schema.json"));

    internal FreeformJob()
    {
    }

    /// <summary>The file as the caller named it.</summary>
    public required string File { get; init; }

    /// <summary>SHA-256 of the file's bytes as 64 lower-case hexadecimal digits.</summary>
    public required string Sha256 { get; init; }

    /// <summary>What the report calls the job.</summary>
    public required string Name { get; init; }

    /// <summary>The shop's number of the order; null if the job has none.</summary>
    public string? WorkOrder { get; init; }

    /// <summary>The nominal surface and which side of it is air.</summary>
    public required JobSurface Surface { get; init; }

    /// <summary>What is left on the surface before finishing.</summary>
    public required JobStock Stock { get; init; }

    /// <summary>The ball end mill and how it is driven.</summary>
    public required JobTool Tool { get; init; }

    /// <summary>How the surface is measured.</summary>
    public required JobMeasuring Measuring { get; init; }

    /// <summary>What is fitted to the measured points.</summary>
    public required JobFit Fit { get; init; }

    /// <summary>How the surface is cut.</summary>
    public required JobToolpath Toolpath { get; init; }

    /// <summary>What is made of the error.</summary>
    public required JobMirror Compensation { get; init; }

    internal IReadOnlyDictionary<string, JsonPlace> Places { get; init; } = new Dictionary<string, JsonPlace>();

    /// <summary>Where the file names another file, a dialect, a template or a tool.</summary>
    /// <param name="path">The JSON path, such as <c>$.surface</c>, <c>$.toolpath.dialect</c>, <c>$.measuring.template</c>, <c>$.toolpath.tool.name</c> or <c>$.measuring.cutBy</c>.</param>
    /// <returns>Null if it does not.</returns>
    public JsonPlace? PlaceOf(string path) => Places.TryGetValue(path, out var place) ? place : null;

    /// <summary>The job in some bytes.</summary>
    /// <param name="bytes">JSON with comments and trailing commas allowed.</param>
    /// <param name="file">Name for messages, and the place that relative paths start from.</param>
    /// <exception cref="JsonDocumentException">The bytes are no JSON, break the schema, or the job contradicts itself; all problems are in it.</exception>
    public static FreeformJob Parse(ReadOnlySpan<byte> bytes, string file)
    {
        var document = JsonInput.Read(bytes, file);
        var problems = Schema.Value.Check(document);
        if (problems.Count > 0)
        {
            throw new JsonDocumentException(file, problems);
        }

        var reader = new FreeformJobReader(document);
        var job = reader.Read(file, Convert.ToHexStringLower(SHA256.HashData(bytes)));
        return reader.Problems.Count == 0 ? job : throw new JsonDocumentException(file, reader.Problems);
    }

    /// <summary>A path of the job as seen from where the caller is: relative ones start from the job's folder, absolute ones stay.</summary>
    public string PathOf(string path) => Path.Combine(Path.GetDirectoryName(File) ?? "", path);
}
