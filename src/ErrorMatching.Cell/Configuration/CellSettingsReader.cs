using System.Text;
using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <summary>Reads the configuration of a cell and checks everything that can be checked without a machine, a store or a folder.</summary>
public static class CellSettingsReader
{
    private static readonly Lazy<JsonSchema> Schema = new(() => JsonSchema.Parse(
        Encoding.UTF8.GetBytes(CellTemplate.Schema), "cell.schema.json"));

    /// <summary>Reads the configuration from a file.</summary>
    /// <param name="file">The file.</param>
    /// <exception cref="InputException">As for <see cref="Parse"/>. The file cannot be opened, or is implausibly large for a
    /// configuration.</exception>
    public static CellSettings Read(string file) => Parse(InputFile.Bytes(file, JsonLimits.Default.MaxBytes), file);

    /// <summary>Parses the configuration from bytes.</summary>
    /// <param name="bytes">JSON with comments and trailing commas allowed.</param>
    /// <param name="file">File name for messages; relative paths start at its folder. The jobs' files are read from there.</param>
    /// <exception cref="InputException">The bytes are not JSON or break the schema, the configuration contradicts itself or its
    /// jobs, or a job's file is missing or wrong. The exception lists all problems, in document order.</exception>
    public static CellSettings Parse(ReadOnlySpan<byte> bytes, string file)
    {
        var document = JsonInput.Read(bytes, file);
        var problems = new CellProblems();
        problems.RefuseControlCharacters(document);
        problems.AddRange(Schema.Value.Check(document).Where(p => p.Place.Path is not { } path || !problems.Has(path)));
        problems.ThrowIfAny(file);
        var settings = new CellReader(document, file, problems).Read();
        problems.ThrowIfAny(file);
        return settings;
    }
}
