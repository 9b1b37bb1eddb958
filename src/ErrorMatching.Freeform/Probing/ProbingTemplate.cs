using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>The text of a probing program with placeholders and a loop over points, for a control, a probe or a shop.</summary>
/// <remarks>The sections are <c>@head</c>, <c>@definitions</c>, <c>@body</c> and <c>@tail</c>. The lines from <c>@each point</c> to
/// <c>@next</c> are repeated for each point; <c>@refuse</c> among them says why a point cannot be touched. <c>@assumes</c> states what is
/// taken for granted of the control, and <c>@beside NAME</c> starts a file that the control needs beside the program. If
/// the program follows another one, head and tail are omitted; definitions go to its start, the body to its end.</remarks>
public sealed class ProbingTemplate : ProgramTemplate
{
    internal const string Head = "head", Definitions = "definitions", Body = "body", Tail = "tail", Beside = "beside";
    internal const string Grid = "grid", AlongAxis = "along-axis", Merged = "merged", Compensated = "compensated", Assumed = "assumed";
    internal const string InPlane = "in-plane", TowardPlus = "toward-plus";

    private static readonly TemplateGrammar Grammar = new()
    {
        Extension = "probing",
        Under = "measuring",
        BuiltIn = ["siemens-840d", "siemens-cycle978", "fanuc", "fanuc-p98xx", "haas-p98xx", "linuxcnc", "grbl", "heidenhain-klartext"],
        Sections = [Head, Definitions, Body, Tail, Beside],
        Beside = Beside,
        Needed = Body,
        NeededHint = "@each point to @next",
        Places = [.. ProbingValues.OfProgram, .. TemplateGrammar.ToolPlaces],
        PointPlaces = ProbingValues.OfPoint,
        Conditions = [Merged, Compensated, Assumed, TemplateGrammar.Tool, TemplateGrammar.ToolByName, TemplateGrammar.Order],
        PointConditions = [Grid, AlongAxis, "along-x", "along-y", "along-z", InPlane, TowardPlus],
    };

    private ProbingTemplate(TemplateContent content)
        : base(content)
    {
    }

    /// <summary>Names of the built-in templates. A dialect's own template has the dialect's name.</summary>
    public static IReadOnlyList<string> Names => Grammar.BuiltIn;

    /// <summary>The placeholders in braces: values of the program, then values of a point within <c>@each point</c>. Lengths are in
    /// millimeters, rounded to the control's least increment.</summary>
    public static IReadOnlyList<string> Places { get; } = [.. Grammar.Places, .. Grammar.PointPlaces];

    /// <summary>The conditions after <c>@if</c>: whether a point has a place in a grid; whether the measuring move is along an axis, and
    /// which one; whether it lies in the plane XY, and whether it goes along its axis in the positive direction; whether the program
    /// follows another one, and whether that one is compensated; whether values were assumed; whether the job names the probe as a tool,
    /// and whether by name; whether it has the number of an order.</summary>
    public static IReadOnlyList<string> Conditions { get; } = [.. Grammar.PointConditions, .. Grammar.Conditions];

    /// <summary>What it takes for granted of the control, in a few words each: the program stops for somebody to check it.</summary>
    public IReadOnlyList<string> Assumes => Content.Assumes;

    /// <summary>Name of the file that the control needs beside the program; null if there is none.</summary>
    public string? BesideName => Content.Beside;

    /// <summary>A built-in template.</summary>
    /// <param name="name">One of <see cref="Names"/>, such as a dialect's.</param>
    /// <exception cref="InputException">No built-in template has this name (<c>unknown-template</c>).</exception>
    public static ProbingTemplate Named(string name) => new(BuiltIn(name, Grammar));

    /// <summary>The built-in template for a dialect: its own, or the one of its family for a shop's own dialect.</summary>
    /// <exception cref="InputException">There is none (<c>unknown-template</c>).</exception>
    public static ProbingTemplate For(NcDialect dialect) => Named(NameFor(dialect));

    /// <summary>The same; null if there is none.</summary>
    public static ProbingTemplate? Find(NcDialect dialect) => NameFor(dialect) is var name && Names.Contains(name) ? Named(name) : null;

    private static string NameFor(NcDialect dialect)
    {
        ArgumentNullException.ThrowIfNull(dialect);
        return dialect.Files.Count == 0 ? dialect.Name == "haas" ? "fanuc" : dialect.Name
            : dialect.Syntax == NcSyntax.Siemens ? "siemens-840d"
            : dialect.Syntax == NcSyntax.LinuxCnc ? "linuxcnc"
            : dialect.Syntax == NcSyntax.Klartext ? "heidenhain-klartext"
            : dialect.MeaningOf("DPRNT"u8) == NcMeaning.Harmless ? "fanuc"
            : dialect.Name;
    }

    /// <summary>The text of a built-in template, as a start for a shop's own.</summary>
    /// <param name="name">One of <see cref="Names"/>.</param>
    /// <exception cref="InputException">As for <see cref="Named"/>.</exception>
    public static string TextOf(string name) => TextOf(name, Grammar);

    /// <summary>Ensures that no program moves by values that nobody stated without a word.</summary>
    /// <exception cref="InputException">The template says nothing of them (<c>bad-template</c>).</exception>
    internal void CheckAsksForAssumed(IReadOnlyList<string> assumed)
    {
        if (assumed.Count > 0 && !Asks([.. Grammar.Sections.SelectMany(Section)], Assumed))
        {
            throw InputException.At(
                "bad-template",
                File,
                $"it has no @if {Assumed}, and nobody stated {string.Join(", ", assumed)}. State them, or stop before the first move "
                    + $"behind @if {Assumed} with {{assumed}} in the message.");
        }
    }

    /// <summary>Parses a template.</summary>
    /// <param name="bytes">UTF-8.</param>
    /// <param name="file">Name for messages.</param>
    /// <exception cref="InputException">The bytes are not a template (<c>bad-template</c>), with the line.</exception>
    public static ProbingTemplate Parse(ReadOnlySpan<byte> bytes, string file) => new(Read(bytes, file, Grammar));
}
