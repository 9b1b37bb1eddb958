using System.Text;
using ErrorMatching.Jobs;
using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Reads the configuration of a cell and everything that can be known of it without asking a machine, a store or a folder.</summary>
public static class CellSettingsReader
{
    private static readonly Lazy<JsonSchema> Schema = new(() => JsonSchema.Parse(Encoding.UTF8.GetBytes(CellTemplate.Schema), "cell.schema.json"));

    /// <summary>The configuration in a file.</summary>
    /// <param name="file">The file.</param>
    /// <exception cref="JsonDocumentException">As of <see cref="Parse"/>.</exception>
    /// <exception cref="InputException">The file cannot be opened, or is larger than any that people write.</exception>
    public static CellSettings Read(string file) => Parse(InputFile.Bytes(file, JsonLimits.Default.MaxBytes), file);

    /// <summary>The configuration in some bytes.</summary>
    /// <param name="bytes">JSON with comments and trailing commas allowed.</param>
    /// <param name="file">Name for messages, and the place that relative paths start from. The files of the jobs are read from there.</param>
    /// <exception cref="JsonDocumentException">
    /// The bytes are no JSON, break the schema, or the configuration contradicts itself or its jobs, a job's file that is missing or wrong among them; all problems are in it, in the order of the document.
    /// </exception>
    public static CellSettings Parse(ReadOnlySpan<byte> bytes, string file)
    {
        var document = JsonInput.Read(bytes, file);
        var problems = new CellProblems();
        problems.RefuseControlCharacters(document);
        problems.AddRange(Schema.Value.Check(document).Where(p => !problems.Has(p.Path)));
        problems.ThrowIfAny(file);
        var settings = new CellReader(document, file, problems).Read();
        problems.ThrowIfAny(file);
        return settings;
    }
}
