using System.Text;
using ErrorMatching.Json;

namespace ErrorMatching.Nc;

/// <summary>The dialects that are built in, and those that shops write as files.</summary>
public static class NcDialects
{
    private const string GenericName = "generic";
    private const string FanucName = "fanuc";
    private const string DeltaName = "delta-nc300";
    private const string SiemensName = "siemens-840d";
    private const string LinuxCncName = "linuxcnc";
    private static readonly string[] BuiltInNames = [GenericName, FanucName, DeltaName, SiemensName, LinuxCncName];

    // Read when first asked for: a run needs one of them.
    private static readonly Lazy<NcDialect>[] BuiltIn = [.. BuiltInNames.Select(n => new Lazy<NcDialect>(() => DialectChain.BuiltIn(n)))];

    /// <summary>Names of the built-in dialects, in the order in which they are listed.</summary>
    public static IReadOnlyList<string> Names => BuiltInNames;

    /// <summary>What a file may name as <c>like</c>, beside other files:
    /// the built-in dialects, and <c>iso</c>, the part that they all share.</summary>
    public static IReadOnlyList<string> Bases { get; } = ["iso", .. BuiltInNames];

    /// <summary>What most ISO milling controls have in common.</summary>
    public static NcDialect Generic => Named(GenericName);

    /// <summary>Fanuc series 0i and 30i milling.</summary>
    public static NcDialect FanucMill => Named(FanucName);

    /// <summary>Delta NC300 series milling, as on the paper's machining center.</summary>
    public static NcDialect DeltaNc300 => Named(DeltaName);

    /// <summary>Siemens SINUMERIK 840D sl milling.</summary>
    public static NcDialect Siemens840D => Named(SiemensName);

    /// <summary>LinuxCNC 2.9.</summary>
    public static NcDialect LinuxCnc => Named(LinuxCncName);

    /// <summary>All built-in dialects, in the order in which they are listed.</summary>
    public static IReadOnlyList<NcDialect> All => [.. Names.Select(Named)];

    /// <summary>The JSON Schema (draft 2020-12) of dialect files, with a description of each key.</summary>
    public static string Schema => Encoding.UTF8.GetString(DialectChain.Resource("dialect.schema"));

    /// <summary>The dialect of a name; the same object each time.</summary>
    /// <exception cref="NcException">No dialect has this name (<see cref="NcErrorCode.UnknownDialect"/>).</exception>
    public static NcDialect Named(string name) => Array.IndexOf(BuiltInNames, name) is var index and >= 0
        ? BuiltIn[index].Value
        : throw new NcException(
            NcErrorCode.UnknownDialect,
            $"\"{name}\" is no known dialect. Known are {string.Join(", ", Names)}; a shop's own is a file that ends in .json.");

    /// <summary>Whether a text names a dialect's file and not a built-in dialect: it ends in <c>.json</c>.</summary>
    public static bool IsFile(string dialect)
    {
        ArgumentNullException.ThrowIfNull(dialect);
        return DialectChain.IsFile(dialect);
    }

    /// <summary>The dialect in a file; files that it continues are found from its folder.</summary>
    /// <param name="path">The file.</param>
    /// <exception cref="JsonDocumentException">As of <see cref="Parse"/>.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">The file must not be read.</exception>
    public static NcDialect Read(string path) => Parse(JsonInput.Load(path, DialectChain.Limits), path);

    /// <summary>The dialect in some bytes.</summary>
    /// <param name="bytes">JSON with comments and trailing commas allowed, at most 1 MiB.</param>
    /// <param name="file">Name for messages; files that it continues are found from its folder.</param>
    /// <exception cref="JsonDocumentException">
    /// The bytes are no JSON (as of <see cref="JsonInput.Read"/>), break <see cref="Schema"/> (as of <see cref="JsonSchema.Check"/>), name
    /// a code that is none (<c>bad-subject</c>), state one twice (<c>stated-twice</c>), have the name of a built-in dialect
    /// (<c>name-taken</c>), or continue what is not there (<c>unknown-like</c>) or leads back (<c>circular-like</c>). The error names the
    /// file that is wrong, which may be one of those that are continued.
    /// </exception>
    public static NcDialect Parse(ReadOnlySpan<byte> bytes, string file) => DialectChain.Own(bytes, file);
}
