using System.Text;
using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>The built-in dialects, and shops' dialects from files.</summary>
public static class NcDialects
{
    private const string GenericName = "generic";
    private const string FanucName = "fanuc";
    private const string DeltaName = "delta-nc300";
    private const string SiemensName = "siemens-840d";
    private const string LinuxCncName = "linuxcnc";
    private const string KlartextName = "heidenhain-klartext";
    private static readonly string[] BuiltInNames =
    [
        GenericName, FanucName, DeltaName, "haas", "mazak-eia", "mitsubishi-m80", "okuma-osp", SiemensName, LinuxCncName, "grbl",
        KlartextName,
    ];

    // Read on first access, because a run needs only one of them.
    private static readonly Lazy<NcDialect>[] BuiltIn = [.. BuiltInNames.Select(n => new Lazy<NcDialect>(() => DialectChain.BuiltIn(n)))];

    /// <summary>Names of the built-in dialects, in list order.</summary>
    public static IReadOnlyList<string> Names => BuiltInNames;

    /// <summary>Names, besides other files, that a file may give as <c>like</c>: the built-in dialects, and <c>iso</c>, the part that
    /// they all share.</summary>
    public static IReadOnlyList<string> Bases { get; } = ["iso", .. BuiltInNames];

    /// <summary>The common part of most ISO milling controls.</summary>
    public static NcDialect Generic => Named(GenericName);

    /// <summary>Fanuc series 0i and 30i milling.</summary>
    public static NcDialect FanucMill => Named(FanucName);

    /// <summary>Delta NC300 series milling, as on the paper's machining center.</summary>
    public static NcDialect DeltaNc300 => Named(DeltaName);

    /// <summary>Siemens SINUMERIK 840D sl milling.</summary>
    public static NcDialect Siemens840D => Named(SiemensName);

    /// <summary>LinuxCNC 2.9.</summary>
    public static NcDialect LinuxCnc => Named(LinuxCncName);

    /// <summary>Heidenhain TNC controls for milling, programs in Klartext.</summary>
    public static NcDialect HeidenhainKlartext => Named(KlartextName);

    /// <summary>All built-in dialects, in list order.</summary>
    public static IReadOnlyList<NcDialect> All => [.. Names.Select(Named)];

    /// <summary>The JSON Schema (draft 2020-12) of dialect files, with a description of each key.</summary>
    public static string Schema => Encoding.UTF8.GetString(DialectChain.Resource("dialect.schema"));

    /// <summary>The dialect with a name; the same object each time.</summary>
    /// <exception cref="InputException">No dialect has this name (<see cref="NcInputCodes.UnknownDialect"/>).</exception>
    public static NcDialect Named(string name) => Array.IndexOf(BuiltInNames, name) is var index and >= 0
        ? BuiltIn[index].Value
        : throw new InputException(new Refusal(
            NcInputCodes.UnknownDialect,
            $"\"{name}\" is no known dialect. {Hint(name)}"
                + $"Known are {string.Join(", ", Names)}; a shop's own is a file that ends in .json."));

    /// <summary>Whether a document may name a dialect so: it is known, or names a file.</summary>
    public static bool IsName(string dialect) => IsFile(dialect) || Names.Contains(dialect, StringComparer.Ordinal);

    /// <summary>What is expected in a document instead of an unknown name, as the end of a sentence: the name that was probably meant,
    /// and all of them.</summary>
    public static string ExpectedInsteadOf(string dialect)
    {
        ArgumentNullException.ThrowIfNull(dialect);
        var near = NearestTo(dialect) is { } name ? $"\"{name}\", or " : "";
        return $"{near}one of {string.Join(", ", Names)}, or a shop's own file that ends in .json";
    }

    private static string Hint(string name) => NearestTo(name) is { } near ? $"Did you mean {near}? " : "";

    // A name that is only begun, such as siemens, has the first one that begins so.
    private static string? NearestTo(string name) =>
        NearestName.To(name, Names) ?? (name.Length < 3 ? null
            : Names.FirstOrDefault(n => n.Contains(name, StringComparison.OrdinalIgnoreCase)));

    /// <summary>Whether a text names a dialect file, not a built-in dialect: it ends in <c>.json</c>.</summary>
    public static bool IsFile(string dialect)
    {
        ArgumentNullException.ThrowIfNull(dialect);
        return DialectChain.IsFile(dialect);
    }

    /// <summary>Reads the dialect in a file; files that it continues are found relative to its folder.</summary>
    /// <param name="path">The file.</param>
    /// <exception cref="InputException">As for <see cref="Parse"/>.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">Reading the file is not permitted.</exception>
    public static NcDialect Read(string path) => Parse(JsonInput.Load(path, DialectChain.Limits), path);

    /// <summary>Reads a dialect from bytes.</summary>
    /// <param name="bytes">JSON with comments and trailing commas allowed, at most 1 MiB.</param>
    /// <param name="file">Name for messages; files that it continues are found relative to its folder.</param>
    /// <exception cref="InputException">
    /// The bytes are not JSON (as for <see cref="JsonInput.Read"/>), violate <see cref="Schema"/> (as for
    /// <see cref="JsonSchema.Check"/>), name an invalid code (<c>bad-subject</c>), state a code twice (<c>stated-twice</c>), have the
    /// name of a built-in dialect (<c>name-taken</c>), or continue a file that does not exist (<c>unknown-like</c>) or leads back
    /// (<c>circular-like</c>). The error names the faulty file, which may be one of the continued files.
    /// </exception>
    public static NcDialect Parse(ReadOnlySpan<byte> bytes, string file) => DialectChain.Own(bytes, file);
}
