using System.Text;
using ErrorMatching.Nc;

namespace ErrorMatching.Freeform;

/// <summary>The text of a probing program with places for values and a loop over points: how a control, a probe or a shop wants it.</summary>
/// <remarks>
/// A line that begins with <c>@</c> steers: <c>@about</c> says what the template is for; <c>@head</c>, <c>@definitions</c>, <c>@body</c> and <c>@tail</c> begin the sections; <c>@each point</c> to <c>@next</c>
/// stands for each point; <c>@if</c> to <c>@endif</c>, with <c>@else</c> between, for where one of <see cref="Conditions"/> holds. Every other line is written with its places filled: a place is one of
/// <see cref="Places"/> in braces, <c>{{</c> is a brace. Head and tail are left out where the program follows another one; definitions then go to its beginning, the body to its end.
/// </remarks>
public sealed class ProbingTemplate
{
    /// <summary>Largest template that is read, in bytes.</summary>
    public const int MaxBytes = 1 << 18;

    internal const string Head = "head", Definitions = "definitions", Body = "body", Tail = "tail";
    internal const string AlongAxis = "along-axis", Merged = "merged";

    private static readonly string[] BuiltIn = ["siemens-840d", "fanuc", "fanuc-p98xx", "linuxcnc"];

    internal ProbingTemplate(string file, string about, IReadOnlyDictionary<string, IReadOnlyList<TemplateItem>> sections) => (File, About, Sections) = (file, about, sections);

    /// <summary>Names of the built-in templates; a dialect's own has its name.</summary>
    public static IReadOnlyList<string> Names => BuiltIn;

    /// <summary>What may stand in braces: values of the program, then those of a point within <c>@each point</c>. Lengths in millimetres in the least increment of the control.</summary>
    public static IReadOnlyList<string> Places { get; } = [.. ProbingValues.OfProgram, .. ProbingValues.OfPoint];

    /// <summary>What may stand behind <c>@if</c>: whether the measuring move is along an axis, which one, and whether the program follows another.</summary>
    public static IReadOnlyList<string> Conditions { get; } = [AlongAxis, "along-x", "along-y", "along-z", Merged];

    /// <summary>The file as the caller named it, or the name of a built-in template.</summary>
    public string File { get; }

    /// <summary>What it is for, in a sentence; empty where it does not say.</summary>
    public string About { get; }

    internal IReadOnlyDictionary<string, IReadOnlyList<TemplateItem>> Sections { get; }

    /// <summary>A built-in template.</summary>
    /// <param name="name">One of <see cref="Names"/>, such as a dialect's.</param>
    /// <exception cref="FreeformException">No built-in template has this name (<c>unknown-template</c>).</exception>
    public static ProbingTemplate Named(string name)
    {
        if (!BuiltIn.Contains(name, StringComparer.Ordinal))
        {
            throw new FreeformException("unknown-template", name, $"no probing template is built in for it; there are {string.Join(", ", BuiltIn)}. Name one of them, or a file of your own, as \"template\" under \"measuring\".");
        }

        using var stream = typeof(ProbingTemplate).Assembly.GetManifestResourceStream(name + ".probing")!;
        using var bytes = new MemoryStream();
        stream.CopyTo(bytes);
        return Parse(bytes.ToArray(), name);
    }

    /// <summary>The built-in template for a dialect: the one of its name, else the one of its family for a shop's own dialect.</summary>
    /// <exception cref="FreeformException">There is none (<c>unknown-template</c>).</exception>
    public static ProbingTemplate For(NcDialect dialect)
    {
        ArgumentNullException.ThrowIfNull(dialect);
        return Named(dialect.Files.Count == 0 ? dialect.Name
            : dialect.Syntax == NcSyntax.Siemens ? "siemens-840d"
            : dialect.Syntax == NcSyntax.LinuxCnc ? "linuxcnc"
            : dialect.MeaningOf("DPRNT"u8) == NcMeaning.Harmless ? "fanuc"
            : dialect.Name);
    }

    /// <summary>The text of a built-in template, to begin a shop's own with.</summary>
    /// <param name="name">One of <see cref="Names"/>.</param>
    /// <exception cref="FreeformException">As of <see cref="Named"/>.</exception>
    public static string TextOf(string name)
    {
        var template = Named(name);
        using var stream = typeof(ProbingTemplate).Assembly.GetManifestResourceStream(template.File + ".probing")!;
        using var reader = new StreamReader(stream, Encoding.UTF8);
        return reader.ReadToEnd();
    }

    /// <summary>The template in some bytes.</summary>
    /// <param name="bytes">UTF-8.</param>
    /// <param name="file">Name for messages.</param>
    /// <exception cref="FreeformException">The bytes are no template (<c>bad-template</c>), with the line.</exception>
    public static ProbingTemplate Parse(ReadOnlySpan<byte> bytes, string file) => bytes.Length > MaxBytes
        ? throw new FreeformException("bad-template", file, FormattableString.Invariant($"{bytes.Length} bytes; a template has at most {MaxBytes}. Is this the right file?"))
        : new ProbingTemplateReader(file).Read(bytes);
}
