using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>The text before and after the moves of a cutting program: tool call, work offset, spindle.</summary>
/// <remarks>The sections are <c>@head</c> and <c>@tail</c>. After <c>@if tool</c>, the template calls the tool that the job names. After
/// its <c>@else</c>, it stops the machine if the job names none, so that no wrong tool cuts.</remarks>
public sealed class FinishingTemplate : ProgramTemplate
{
    internal const string Head = "head", Tail = "tail";

    private static readonly TemplateGrammar Grammar = new()
    {
        Extension = "finishing",
        Under = "toolpath",
        BuiltIn =
        [
            "delta-nc300", "fanuc", "generic", "grbl", "haas", "linuxcnc", "mazak-eia", "mitsubishi-m80", "okuma-osp", "siemens-840d",
        ],
        Sections = [Head, Tail],
        Needed = Head,
        NeededHint = "what stands before the moves, down to G0 Z{travel}",
        Places = [.. FinishingValues.OfProgram, .. TemplateGrammar.ToolPlaces],
        Conditions = [TemplateGrammar.Tool, TemplateGrammar.ToolByName, TemplateGrammar.Order],
    };

    private FinishingTemplate(TemplateContent content)
        : base(content)
    {
    }

    /// <summary>Names of the built-in templates, which are those of the dialects.</summary>
    public static IReadOnlyList<string> Names => Grammar.BuiltIn;

    /// <summary>The placeholders in braces.</summary>
    public static IReadOnlyList<string> Places => Grammar.Places;

    /// <summary>The conditions after <c>@if</c>: whether the job names the tool, and whether by name; whether it has
    /// the number of an order.</summary>
    public static IReadOnlyList<string> Conditions => Grammar.Conditions;

    /// <summary>A built-in template.</summary>
    /// <param name="name">One of <see cref="Names"/>.</param>
    /// <exception cref="InputException">No built-in template has this name (<c>unknown-template</c>).</exception>
    public static FinishingTemplate Named(string name) => new(BuiltIn(name, Grammar));

    /// <summary>The built-in template for a dialect: its own, or for a shop's own dialect, the one for its syntax.</summary>
    /// <exception cref="InputException">Moves cannot be written in the dialect (<c>unknown-template</c>).</exception>
    public static FinishingTemplate For(NcDialect dialect)
    {
        ArgumentNullException.ThrowIfNull(dialect);
        return Named(Names.Contains(dialect.Name, StringComparer.Ordinal) || !dialect.HasCodes ? dialect.Name : dialect.Syntax switch
        {
            NcSyntax.Siemens => NcDialects.Siemens840D.Name,
            NcSyntax.LinuxCnc => NcDialects.LinuxCnc.Name,
            _ => NcDialects.Generic.Name,
        });
    }

    /// <summary>The text of a built-in template, as a start for a shop's own.</summary>
    /// <param name="name">One of <see cref="Names"/>.</param>
    /// <exception cref="InputException">As for <see cref="Named"/>.</exception>
    public static string TextOf(string name) => TextOf(name, Grammar);

    /// <summary>Parses a template.</summary>
    /// <param name="bytes">UTF-8.</param>
    /// <param name="file">Name for messages.</param>
    /// <exception cref="InputException">The bytes are not a template (<c>bad-template</c>), with the line.</exception>
    public static FinishingTemplate Parse(ReadOnlySpan<byte> bytes, string file) => new(Read(bytes, file, Grammar));

    /// <summary>True if a job's program calls its tool; false if it stops with an alarm because the job names no tool.</summary>
    public bool CallsTool(FreeformJob job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return !AsksForTool || job.Toolpath.Tool is not null;
    }
}
