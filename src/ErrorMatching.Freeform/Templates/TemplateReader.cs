using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Reads a template and reports errors by line.</summary>
internal sealed class TemplateReader(string file, TemplateGrammar grammar)
{
    private readonly Dictionary<string, IReadOnlyList<TemplateItem>> _sections = new(StringComparer.Ordinal);
    private readonly Stack<(TemplateItem Item, bool InElse)> _open = new();
    private List<TemplateItem>? _section;
    private readonly List<string> _assumes = [];
    private string _about = "";
    private string? _beside;
    private int _line;

    private bool IsInEach => _open.Any(o => o.Item.Kind == TemplateItemKind.Each);

    public TemplateContent Read(ReadOnlySpan<byte> bytes)
    {
        string text;
        try
        {
            text = new UTF8Encoding(false, true).GetString(bytes);
        }
        catch (DecoderFallbackException)
        {
            throw InputException.At("bad-template", file, "bytes that are no UTF-8 text. Save the template as UTF-8.");
        }

        foreach (var line in text.TrimStart('\uFEFF').ReplaceLineEndings("\n").TrimEnd('\n').Split('\n'))
        {
            _line++;
            if (line.StartsWith('@'))
            {
                Steer(line.TrimEnd());
            }
            else
            {
                Add(line);
            }
        }

        if (_open.TryPeek(out var open))
        {
            throw Fail(
                $"{Word(open.Item)} is never closed",
                open.Item.Kind == TemplateItemKind.Each ? "@next behind it" : "@endif behind it",
                open.Item.Line);
        }

        return _sections.ContainsKey(grammar.Needed)
            ? new(file, _about, _sections) { Assumes = _assumes, Beside = _beside }
            : throw Fail($"there is no section @{grammar.Needed}", $"@{grammar.Needed}, and in it {grammar.NeededHint}");
    }

    private void Steer(string line)
    {
        var parts = line.Split(' ', 2, StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);
        var (word, argument) = (parts[0], parts.Length > 1 ? parts[1] : "");
        switch (word)
        {
            case "@about":
                _about = argument;
                break;
            case "@assumes" when grammar.HasPoints:
                _assumes.Add(argument.Length > 0 ? argument : throw Fail(word, "what the program takes for granted behind it"));
                break;
            case "@refuse" when grammar.HasPoints:
                Lines().Add(
                    new(
                        _line,
                        IsInEach && argument.Length > 0 ? argument : throw Fail(line, "a reason behind @refuse, within @each point"),
                        TemplateItemKind.Refuse));
                break;
            case "@each" when grammar.HasPoints:
                Open(
                    argument == "point" && !IsInEach ? TemplateItemKind.Each : throw Fail(line, "@each point, not within another one"),
                    argument);
                break;
            case "@if":
                Open(TemplateItemKind.If, Condition(argument, line));
                break;
            case "@else":
                var (item, inElse) = Top(TemplateItemKind.If, line);
                _ = inElse ? throw Fail("a second @else", "@endif") : _open.Pop();
                _open.Push((item, true));
                break;
            case "@next":
                Top(TemplateItemKind.Each, line);
                _open.Pop();
                break;
            case "@endif":
                Top(TemplateItemKind.If, line);
                _open.Pop();
                break;
            default:
                Begin(word, argument);
                break;
        }
    }

    private string Condition(string argument, string line)
    {
        if (grammar.PointConditions.Contains(argument, StringComparer.Ordinal))
        {
            return IsInEach ? argument : throw Fail(line, "conditions of a point only within @each point");
        }

        return grammar.Conditions.Contains(argument, StringComparer.Ordinal)
            ? argument
            : throw Fail(line, $"@if with one of {string.Join(", ", grammar.PointConditions.Concat(grammar.Conditions))}");
    }

    private void Begin(string word, string argument)
    {
        var name = word[1..];
        if (!grammar.Sections.Contains(name, StringComparer.Ordinal))
        {
            var (sections, loop) = (
                string.Join(", ", grammar.Sections.Select(s => "@" + s)),
                grammar.HasPoints ? "@assumes, @each point, @next, @refuse, " : "");
            throw Fail(word, $"@about, {sections}, {loop}@if, @else or @endif");
        }

        if (name == grammar.Beside)
        {
            _beside = IsFileName(argument)
                ? argument
                : throw Fail($"{word} {argument}".Trim(), "the name of a file, such as MASK.A, behind it");
        }

        if (_open.TryPeek(out var open))
        {
            throw Fail($"{word} within {Word(open.Item)} of line {open.Item.Line}", "the loop or condition closed before");
        }

        _section = [];
        if (!_sections.TryAdd(name, _section))
        {
            throw Fail($"a second section {word}", "each section once");
        }
    }

    // It is written beside the program, in no other folder, and controls know few letters.
    private static bool IsFileName(string name) =>
        name.Length is > 0 and <= 32 && name[0] != '.' && name.All(c => char.IsAsciiLetterOrDigit(c) || c is '.' or '_' or '-');

    private void Open(TemplateItemKind kind, string argument)
    {
        var item = new TemplateItem(_line, argument, kind);
        Lines().Add(item);
        _open.Push((item, false));
    }

    private (TemplateItem Item, bool InElse) Top(TemplateItemKind kind, string line) =>
        _open.TryPeek(out var top) && top.Item.Kind == kind
            ? top
            : throw Fail(line, kind == TemplateItemKind.Each ? "@each point before it" : "@if before it, and nothing else open");

    private void Add(string line)
    {
        if (_section is null && line.Trim().Length == 0)
        {
            return;
        }

        foreach (var place in TemplateText.PlacesOf(
            line, () => Fail(line.Trim(), "a closing brace behind an opening one; a brace itself is written {{")))
        {
            CheckPlace(place);
        }

        Lines().Add(new(_line, line, TemplateItemKind.Line));
    }

    private void CheckPlace(string place)
    {
        if (grammar.PointPlaces.Contains(place, StringComparer.Ordinal))
        {
            _ = IsInEach ? place : throw Fail($"{{{place}}}", "it within @each point only");
        }
        else if (!grammar.Places.Contains(place, StringComparer.Ordinal))
        {
            throw Fail($"{{{place}}}", $"one of {string.Join(", ", grammar.Places.Concat(grammar.PointPlaces))}");
        }
        else if (TemplateGrammar.ToolPlaces.Contains(place, StringComparer.Ordinal)
            && !_open.Any(o => o.Item.Kind == TemplateItemKind.If && o.Item.Text is TemplateGrammar.Tool && !o.InElse))
        {
            throw Fail($"{{{place}}}", $"it behind @if {TemplateGrammar.Tool} only: not every job names its tool");
        }
    }

    private List<TemplateItem> Lines() => _section is null
        ? throw Fail("a line outside of every section", $"{string.Join(", ", grammar.Sections.Select(n => "@" + n))} before it")
        : _open.TryPeek(out var top) ? (top.InElse ? top.Item.Else : top.Item.Body) : _section;

    private static string Word(TemplateItem item) => item.Kind == TemplateItemKind.Each ? "@each" : "@if " + item.Text;

    private InputException Fail(string found, string expected, int? line = null) =>
        InputException.At("bad-template", file, $"found {found}; expected {expected}.", line ?? Math.Max(1, _line));
}
