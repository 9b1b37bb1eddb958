using ErrorMatching.Nc;

namespace ErrorMatching.Freeform;

/// <summary>What stands before and behind the moves of a program that cuts: the call of the tool, the work offset, the spindle.</summary>
/// <remarks>
/// Sections are <c>@head</c> and <c>@tail</c>. Behind <c>@if tool</c> goes the call of the tool that the job names, behind its <c>@else</c> what stops the machine where the job names none, so that nobody cuts with the tool
/// that happens to be in the spindle.
/// </remarks>
public sealed class FinishingTemplate : ProgramTemplate
{
    internal const string Head = "head", Tail = "tail";

    private static readonly TemplateGrammar Grammar = new()
    {
        Extension = "finishing",
        Under = "toolpath",
        BuiltIn = ["delta-nc300", "fanuc", "generic", "linuxcnc", "siemens-840d"],
        Sections = [Head, Tail],
        Needed = Head,
        NeededHint = "what stands before the moves, down to G0 Z{travel}",
        Places = [.. FinishingValues.OfProgram, .. TemplateGrammar.ToolPlaces],
        Conditions = [TemplateGrammar.Tool, TemplateGrammar.ToolByName],
    };

    private FinishingTemplate(TemplateContent content)
        : base(content)
    {
    }

    /// <summary>Names of the built-in templates: those of the dialects.</summary>
    public static IReadOnlyList<string> Names => Grammar.BuiltIn;

    /// <summary>What may stand in braces.</summary>
    public static IReadOnlyList<string> Places => Grammar.Places;

    /// <summary>What may stand behind <c>@if</c>: whether the job names the tool, and whether by name.</summary>
    public static IReadOnlyList<string> Conditions => Grammar.Conditions;

    /// <summary>A built-in template.</summary>
    /// <param name="name">One of <see cref="Names"/>.</param>
    /// <exception cref="FreeformException">No built-in template has this name (<c>unknown-template</c>).</exception>
    public static FinishingTemplate Named(string name) => new(BuiltIn(name, Grammar));

    /// <summary>The built-in template for a dialect: its own, or for a shop's dialect that of the control that spells alike.</summary>
    public static FinishingTemplate For(NcDialect dialect)
    {
        ArgumentNullException.ThrowIfNull(dialect);
        return Named(Names.Contains(dialect.Name, StringComparer.Ordinal) ? dialect.Name : dialect.Syntax switch
        {
            NcSyntax.Siemens => NcDialects.Siemens840D.Name,
            NcSyntax.LinuxCnc => NcDialects.LinuxCnc.Name,
            _ => NcDialects.Generic.Name,
        });
    }

    /// <summary>The text of a built-in template, to begin a shop's own with.</summary>
    /// <param name="name">One of <see cref="Names"/>.</param>
    /// <exception cref="FreeformException">As of <see cref="Named"/>.</exception>
    public static string TextOf(string name) => TextOf(name, Grammar);

    /// <summary>The template in some bytes.</summary>
    /// <param name="bytes">UTF-8.</param>
    /// <param name="file">Name for messages.</param>
    /// <exception cref="FreeformException">The bytes are no template (<c>bad-template</c>), with the line.</exception>
    public static FinishingTemplate Parse(ReadOnlySpan<byte> bytes, string file) => new(Read(bytes, file, Grammar));

    /// <summary>True if what is written for a job calls its tool; false if the program stops with an alarm instead, because the job names no tool.</summary>
    public bool CallsTool(FreeformJob job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return !AsksForTool || job.Toolpath.Tool is not null;
    }
}
