using System.Text;

namespace ErrorMatching.Freeform;

/// <summary>The text of a program, or of what stands around its moves, with places for values: how a control, a probe or a shop wants it.</summary>
/// <remarks>
/// A line that begins with <c>@</c> steers: <c>@about</c> says what the template is for; sections begin with their names; <c>@if</c> to
/// <c>@endif</c>, with <c>@else</c> between, is for where a condition holds.
/// Every other line is written with its places filled: a place is a name in braces, <c>{{</c> is a brace.
/// </remarks>
public abstract class ProgramTemplate
{
    /// <summary>Largest template that is read, in bytes.</summary>
    public const int MaxBytes = 1 << 18;

    private protected ProgramTemplate(TemplateContent content) => Content = content;

    /// <summary>The file as the caller named it, or the name of a built-in template.</summary>
    public string File => Content.File;

    /// <summary>What it is for, in a sentence; empty where it does not say.</summary>
    public string About => Content.About;

    /// <summary>True if it says what is written where the job names the tool, and where it does not.</summary>
    public bool AsksForTool => Content.Sections.Values.Any(Asks);

    internal TemplateContent Content { get; }

    /// <summary>The lines of a section; none where it is missing.</summary>
    internal IReadOnlyList<TemplateItem> Section(string name) => Content.Sections.GetValueOrDefault(name) ?? [];

    /// <summary>A tool that the job names is never left out without a word.</summary>
    /// <exception cref="FreeformException">The template has no place for it (<c>bad-template</c>).</exception>
    internal void CheckAsksFor(ToolCall? tool, string key)
    {
        if (tool is not null && !AsksForTool)
        {
            throw new FreeformException(
                "bad-template",
                File,
                $"it has no @if {TemplateGrammar.Tool}, but the job names a tool ({key}), which would be left out. Write the call of the tool with "
                + $"{{tool.number}} and {{tool.offset}} behind @if {TemplateGrammar.Tool}, or take {key} out of the job.");
        }
    }

    internal static string TextOf(string name, TemplateGrammar grammar)
    {
        _ = BuiltIn(name, grammar);
        return Encoding.UTF8.GetString(Resource(name, grammar));
    }

    internal static TemplateContent BuiltIn(string name, TemplateGrammar grammar) => grammar.BuiltIn.Contains(name, StringComparer.Ordinal)
        ? new TemplateReader(name, grammar).Read(Resource(name, grammar)) with { IsBuiltIn = true }
        : throw new FreeformException(
            "unknown-template",
            name,
            $"no {grammar.Extension} template is built in for it; there are {string.Join(", ", grammar.BuiltIn)}. Name one of them, or a file of your "
            + $"own, as \"template\" under \"{grammar.Under}\".");

    internal static TemplateContent Read(ReadOnlySpan<byte> bytes, string file, TemplateGrammar grammar) => bytes.Length > MaxBytes
        ? throw new FreeformException(
            "bad-template", file, FormattableString.Invariant($"{bytes.Length} bytes; a template has at most {MaxBytes}. Is this the right file?"))
        : new TemplateReader(file, grammar).Read(bytes);

    private static byte[] Resource(string name, TemplateGrammar grammar)
    {
        using var stream = typeof(ProgramTemplate).Assembly.GetManifestResourceStream(name + "." + grammar.Extension)!;
        using var bytes = new MemoryStream();
        stream.CopyTo(bytes);
        return bytes.ToArray();
    }

    private static bool Asks(IEnumerable<TemplateItem> items) => items.Any(i =>
        (i.Kind == TemplateItemKind.If && i.Text is TemplateGrammar.Tool or TemplateGrammar.ToolByName) || Asks(i.Body) || Asks(i.Else));
}
