using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Finds the file of a dialect and the files that it continues, and builds the dialect from them.</summary>
internal static class DialectChain
{
    /// <summary>Maximum size of a file: a larger one is surely the wrong file, not one written by hand.</summary>
    public static readonly JsonLimits Limits = new(1024 * 1024, 16);

    private const int MostFiles = 16;
    private static readonly Lazy<JsonSchema> Schema = new(() => JsonSchema.Parse(Resource("dialect.schema"), "dialect.schema.json"));

    public static bool IsFile(string dialect) => dialect.EndsWith(".json", StringComparison.OrdinalIgnoreCase);

    public static byte[] Resource(string name)
    {
        using var stream = typeof(DialectChain).Assembly.GetManifestResourceStream($"ErrorMatching.Nc.Dialects.{name}.json")!;
        var bytes = new byte[stream.Length];
        stream.ReadExactly(bytes);
        return bytes;
    }

    public static NcDialect BuiltIn(string name) => Build([.. Bases(Embedded(name))]);

    /// <summary>Reads the dialect of a shop's file.</summary>
    /// <exception cref="InputException">The file, or one that it continues, cannot be used.</exception>
    public static NcDialect Own(ReadOnlySpan<byte> bytes, string file)
    {
        var documents = new List<DialectDocument> { Checked(bytes, file) };
        while (documents[0] is { Sha256: not null, Like: { } like } document)
        {
            if (NcDialects.Bases.Contains(like.Text, StringComparer.Ordinal))
            {
                documents.InsertRange(0, Bases(Embedded(like.Text)));
            }
            else if (IsFile(like.Text))
            {
                documents.Insert(0, Continued(document, like, documents));
            }
            else
            {
                throw Refuse(
                    document,
                    like,
                    "unknown-like",
                    $"\"{like.Text}\"",
                    $"{string.Join(", ", NcDialects.Bases)}, or a file that ends in .json");
            }
        }

        return Build(documents);
    }

    private static DialectDocument Continued(DialectDocument document, JsonItem like, List<DialectDocument> documents)
    {
        var file = PathText.Beside(document.File, like.Text);
        byte[] bytes;
        try
        {
            if (documents.Count >= MostFiles || documents.Exists(d => IsSame(d.File, file)))
            {
                throw Refuse(document, like, "circular-like", $"a chain of files that comes back to {file}", "a chain that ends");
            }

            bytes = JsonInput.Load(file, Limits);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException or ArgumentException)
        {
            throw Refuse(document, like, "unknown-like", $"{file}, which cannot be opened", "a file that can");
        }

        return Checked(bytes, file);
    }

    private static bool IsSame(string file, string other) =>
        string.Equals(Path.GetFullPath(file), Path.GetFullPath(other), StringComparison.Ordinal);

    private static DialectDocument Checked(ReadOnlySpan<byte> bytes, string file)
    {
        var root = JsonInput.Read(bytes, file, Limits);
        var problems = Schema.Value.Check(root);
        if (problems.Count > 0)
        {
            throw new InputException(file, problems);
        }

        var document = new DialectDocument(file, root, ContentHash.Sha256(bytes));
        if (document.Like is null)
        {
            throw Refuse(document, root, "missing-key", "no key \"like\"", "the key \"like\" with the dialect that this one continues");
        }

        return NcDialects.Bases.Contains(document.Name, StringComparer.Ordinal)
            ? throw Refuse(document, root["name"], "name-taken", $"\"{document.Name}\"", "a name that no built-in dialect has")
            : document;
    }

    private static List<DialectDocument> Bases(DialectDocument document)
    {
        var documents = new List<DialectDocument> { document };
        while (documents[0].Like is { } like)
        {
            documents.Insert(0, Embedded(like.Text));
        }

        return documents;
    }

    // Tests check the files that come with the library against the schema.
    private static DialectDocument Embedded(string name) =>
        new(name + ".json", JsonInput.Read(Resource(name), name + ".json", Limits), null);

    private static NcDialect Build(IReadOnlyList<DialectDocument> documents)
    {
        var tables = new DialectTables();
        foreach (var document in documents)
        {
            var reader = new DialectReader(document, tables);
            reader.Apply();
            if (reader.Problems.Count > 0)
            {
                throw new InputException(document.File, reader.Problems);
            }
        }

        var last = documents[^1];
        return new(
            last.Name,
            last.Root["description"].Text,
            tables,
            [.. documents.Where(d => d.Sha256 is not null).Reverse().Select(d => new DialectFile(d.File, d.Sha256!))],
            () => DialectPage.Of(documents));
    }

    private static InputException Refuse(DialectDocument document, JsonItem item, string code, string found, string expected) =>
        new(document.File, [JsonRefusal.At(item, code, found, expected)]);
}

/// <summary>A file from which a dialect was read.</summary>
/// <param name="File">The file as named by the caller or by the file that continues it, relative to the caller's place.</param>
/// <param name="Sha256">SHA-256 of its bytes as 64 lower-case hexadecimal digits.</param>
public sealed record DialectFile(string File, string Sha256);
