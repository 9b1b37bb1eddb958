using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>The text of a program, or the text around its moves, with placeholders, for a control, a probe or a shop.</summary>
/// <remarks>A line that starts with <c>@</c> is a directive. <c>@about</c> states the purpose of the template. Sections start with their
/// names. <c>@if</c> to <c>@endif</c>, optionally with <c>@else</c>, depends on a condition. Every other line is written with its
/// placeholders filled. A placeholder is a name in braces; <c>{{</c> is a brace.</remarks>
public abstract class ProgramTemplate
{
    /// <summary>Maximum template size in bytes.</summary>
    public const int MaxBytes = 1 << 18;

    private protected ProgramTemplate(TemplateContent content) => Content = content;

    /// <summary>The file name, as given by the caller, or the name of a built-in template.</summary>
    public string File => Content.File;

    /// <summary>Its purpose, in a sentence; empty if not stated.</summary>
    public string About => Content.About;

    /// <summary>True if it tests whether the job names the tool.</summary>
    public bool AsksForTool => Content.Sections.Values.Any(Asks);

    internal TemplateContent Content { get; }

    /// <summary>The lines of a section; none if it is missing.</summary>
    internal IReadOnlyList<TemplateItem> Section(string name) => Content.Sections.GetValueOrDefault(name) ?? [];

    /// <summary>Ensures that a tool named by the job is not silently omitted.</summary>
    /// <exception cref="InputException">The template does not use the tool (<c>bad-template</c>).</exception>
    internal void CheckAsksFor(ToolCall? tool, string key)
    {
        if (tool is not null && !AsksForTool)
        {
            throw InputException.At(
                "bad-template",
                File,
                $"it has no @if {TemplateGrammar.Tool}, but the job names a tool ({key}), which would be left out. Write the call of the "
                    + $"tool with "
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
        : throw InputException.At(
            "unknown-template",
            name,
            $"no {grammar.Extension} template is built in for it; there are {string.Join(", ", grammar.BuiltIn)}. Name one of them, or a "
                + $"file of your "
            + $"own, as \"template\" under \"{grammar.Under}\".");

    internal static TemplateContent Read(ReadOnlySpan<byte> bytes, string file, TemplateGrammar grammar) => bytes.Length > MaxBytes
        ? throw InputException.At(
            "bad-template",
            file,
            FormattableString.Invariant($"{bytes.Length} bytes; a template has at most {MaxBytes}. Is this the right file?"))
        : new TemplateReader(file, grammar).Read(bytes);

    private static byte[] Resource(string name, TemplateGrammar grammar)
    {
        using var stream = typeof(ProgramTemplate).Assembly.GetManifestResourceStream(name + "." + grammar.Extension)!;
        using var bytes = new MemoryStream();
        stream.CopyTo(bytes);
        return bytes.ToArray();
    }

    private static bool Asks(IEnumerable<TemplateItem> items) =>
        Asks(items, TemplateGrammar.Tool) || Asks(items, TemplateGrammar.ToolByName);

    /// <summary>True if lines depend on a condition.</summary>
    private protected static bool Asks(IEnumerable<TemplateItem> items, string condition) => items.Any(i =>
        (i.Kind == TemplateItemKind.If && i.Text == condition) || Asks(i.Body, condition) || Asks(i.Else, condition));
}
