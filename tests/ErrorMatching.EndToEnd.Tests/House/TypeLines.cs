namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// Counts the lines of each type in C# sources: from its first line to its closing brace, all partial parts together. A nested type counts
/// for itself and not for the one around it.
/// </summary>
internal sealed class TypeLines
{
    private static readonly HashSet<string> Modifiers = new(StringComparer.Ordinal)
    {
        "public", "internal", "private", "protected", "file", "static", "sealed", "abstract", "readonly", "ref", "unsafe", "partial",
        "new", "record",
    };

    private readonly Dictionary<string, int> _lines = new(StringComparer.Ordinal);

    /// <summary>Lines by the name of the type; a nested one is <c>Outer.Inner</c>, a generic one <c>Name`1</c>.</summary>
    public IReadOnlyDictionary<string, int> Lines => _lines;

    /// <summary>Adds the types of a source file.</summary>
    /// <param name="project">What the names begin with, since two projects can have a type of the same name.</param>
    /// <param name="source">The text of the file.</param>
    public void Add(string project, string source)
    {
        var open = new Stack<(string Name, int First, int Depth, int Nested)>();
        var (depth, parentheses) = (0, 0);
        (string Name, int First)? declared = null;
        var tokens = Tokens(source).ToList();
        for (var i = 0; i < tokens.Count; i++)
        {
            var (text, line) = tokens[i];
            if (declared is null && text is "class" or "struct" or "interface" or "enum" or "record" && i > 0
                && Modifiers.Contains(tokens[i - 1].Text) && i + 1 < tokens.Count
                && IsName(tokens[i + 1].Text) && tokens[i + 1].Text is not ("class" or "struct"))
            {
                var outer = open.Count == 0 ? project : open.Peek().Name;
                declared = ($"{outer}.{tokens[i + 1].Text}{Arity(tokens, i + 2)}", FirstLine(tokens, i));
                parentheses = 0;
                continue;
            }

            parentheses += text is "(" or "[" ? 1 : text is ")" or "]" ? -1 : 0;
            depth += text == "{" ? 1 : text == "}" ? -1 : 0;
            if (declared is { } type && parentheses == 0 && text is "{" or ";")
            {
                declared = null;
                open.Push((type.Name, type.First, text == "{" ? depth : depth + 1, 0));
            }

            if (open.TryPeek(out var ended) && ((text == "}" && depth == ended.Depth - 1) || (text == ";" && ended.Depth == depth + 1)))
            {
                open.Pop();
                var all = line - ended.First + 1;
                _lines[ended.Name] = _lines.GetValueOrDefault(ended.Name) + all - ended.Nested;
                if (open.TryPop(out var around))
                {
                    open.Push(around with { Nested = around.Nested + all });
                }
            }
        }
    }

    // Modifiers stand before the keyword.
    private static int FirstLine(List<(string Text, int Line)> tokens, int keyword)
    {
        while (keyword > 0 && Modifiers.Contains(tokens[keyword - 1].Text))
        {
            keyword--;
        }

        return tokens[keyword].Line;
    }

    private static string Arity(List<(string Text, int Line)> tokens, int at)
    {
        if (at >= tokens.Count || tokens[at].Text != "<")
        {
            return "";
        }

        var (count, depth) = (1, 0);
        for (; at < tokens.Count; at++)
        {
            depth += tokens[at].Text == "<" ? 1 : tokens[at].Text == ">" ? -1 : 0;
            count += depth == 1 && tokens[at].Text == "," ? 1 : 0;
            if (depth == 0)
            {
                break;
            }
        }

        return FormattableString.Invariant($"`{count}");
    }

    private static bool IsName(string text) => char.IsLetter(text[0]) || text[0] == '_';

    // Words and single signs, without comments, texts and characters.
    private static IEnumerable<(string Text, int Line)> Tokens(string source)
    {
        var line = 1;
        for (var at = 0; at < source.Length;)
        {
            var c = source[at];
            var end = IsText(source, at) ? BehindText(source, at) : BehindPlain(source, at);
            if (end == 0)
            {
                end = at + 1;
                while (IsWord(c) && end < source.Length && IsWord(source[end]))
                {
                    end++;
                }

                if (!char.IsWhiteSpace(c))
                {
                    yield return (source[at..end], line);
                }
            }

            line += source.AsSpan(at, end - at).Count('\n');
            at = end;
        }
    }

    private static bool IsWord(char c) => char.IsLetterOrDigit(c) || c == '_';

    private static bool IsText(string source, int at)
    {
        while (at < source.Length && source[at] is '$' or '@')
        {
            at++;
        }

        return at < source.Length && source[at] == '"';
    }

    // Behind a comment, a character or a line for the compiler; 0 where none begins.
    private static int BehindPlain(string source, int at)
    {
        var rest = source.AsSpan(at);
        if (rest.StartsWith("//", StringComparison.Ordinal) || rest[0] == '#')
        {
            return rest.IndexOf('\n') is >= 0 and var length ? at + length : source.Length;
        }

        if (rest.StartsWith("/*", StringComparison.Ordinal))
        {
            return rest[2..].IndexOf("*/", StringComparison.Ordinal) is >= 0 and var length ? at + length + 4 : source.Length;
        }

        if (rest[0] != '\'')
        {
            return 0;
        }

        var end = at + 1;
        while (end < source.Length && source[end] != '\'')
        {
            end += source[end] == '\\' ? 2 : 1;
        }

        return end + 1;
    }

    private static int BehindText(string source, int at)
    {
        var (dollars, isVerbatim) = (0, false);
        for (; source[at] != '"'; at++)
        {
            dollars += source[at] == '$' ? 1 : 0;
            isVerbatim |= source[at] == '@';
        }

        var quotes = 0;
        while (at + quotes < source.Length && source[at + quotes] == '"')
        {
            quotes++;
        }

        if (quotes >= 3 && !isVerbatim)
        {
            var close = source.IndexOf(new string('"', quotes), at + quotes, StringComparison.Ordinal);
            return close < 0 ? source.Length : close + quotes;
        }

        for (at++; at < source.Length; at++)
        {
            if (isVerbatim && source[at] == '"' && at + 1 < source.Length && source[at + 1] == '"')
            {
                at++;
            }
            else if (source[at] == '"')
            {
                break;
            }
            else if (!isVerbatim && source[at] == '\\')
            {
                at++;
            }
            else if (dollars > 0 && source[at] == '{')
            {
                at = source[at + 1] == '{' ? at + 1 : BehindHole(source, at + 1) - 1;
            }
        }

        return Math.Min(at + 1, source.Length);
    }

    // Behind the brace that closes what is computed inside a text; there can be texts in it.
    private static int BehindHole(string source, int at)
    {
        for (var depth = 1; at < source.Length && depth > 0;)
        {
            depth += source[at] == '{' ? 1 : source[at] == '}' ? -1 : 0;
            at = IsText(source, at) ? BehindText(source, at) : BehindPlain(source, at) is > 0 and var behind && source[at] != '#' ? behind
                : at + 1;
        }

        return at;
    }
}
