using System.Buffers;
using System.Globalization;
using System.Text;

namespace ErrorMatching.Reporting;

/// <summary>The recorded text of statements. Words are recorded as they are. A code with its values is the character U+001E (record
/// separator, as in RFC 7464) and a JSON array without spaces: the code, then each value as a text or again as an array. An array that
/// begins with an empty text has several statements in a row. Each statement has exactly one text.</summary>
/// <remarks>Nobody types U+001E, and words that nevertheless begin with it are recorded as the only statement in a row. So neither what a
/// person writes nor a sentence of an earlier version can pass for a statement.</remarks>
public static class StatementText
{
    /// <summary>Maximum length of a statement's text.</summary>
    public const int MostCharacters = 8000;

    /// <summary>Maximum length of a code.</summary>
    public const int MostOfCode = 64;

    private const char Marker = '\u001e';

    // What is written otherwise than it is: quotes and backslashes, control characters, and halves of a character without the other.
    private static readonly SearchValues<char> Special = SearchValues.Create(
        [.. Enumerable.Range(0, ' ').Concat(['"', '\\']).Concat(Enumerable.Range('\ud800', 0x800)).Select(c => (char)c)]);

    /// <summary>True if a text begins like a statement with a code.</summary>
    /// <param name="text">A recorded text.</param>
    public static bool IsMarked(string text) => text is [Marker, ..];

    /// <summary>True if a text can be a code: lower-case letters, digits and hyphens, beginning with a letter.</summary>
    /// <param name="text">The text.</param>
    public static bool IsCode(string text) =>
        text is [>= 'a' and <= 'z', ..] && text.Length <= MostOfCode
            && text.All(c => c is (>= 'a' and <= 'z') or (>= '0' and <= '9') or '-');

    /// <summary>Reads a statement with a code.</summary>
    /// <param name="text">Its recorded text.</param>
    /// <param name="forms">The known forms by their names. A code without a form is read all the same.</param>
    /// <exception cref="FormatException">It is not such a statement; the message says where, and what was expected.</exception>
    public static Statement Read(string text, IReadOnlyDictionary<string, SentenceForm> forms)
    {
        ArgumentNullException.ThrowIfNull(text);
        ArgumentNullException.ThrowIfNull(forms);
        if (text.Length > MostCharacters)
        {
            throw new FormatException(string.Create(
                CultureInfo.InvariantCulture, $"The statement has {text.Length} characters; at most {MostCharacters} are read."));
        }

        var reader = new Reader(text, forms);
        var statement = reader.Whole();
        return reader.IsAsRecorded || statement.Text == text ? statement
            : throw reader.Unexpected("a statement as it is recorded", 0);
    }

    /// <summary>The recorded text of a statement.</summary>
    internal static string Of(Statement statement)
    {
        if (statement.Words is { } words && !IsMarked(words))
        {
            return words;
        }

        var text = new StringBuilder().Append(Marker);
        if (statement.Words is not null)
        {
            text.Append("[\"\",");
            Append(text, statement);
            text.Append(']');
        }
        else
        {
            Append(text, statement);
        }

        return text.ToString();
    }

    private static void Append(StringBuilder text, Statement statement)
    {
        if (statement.Words is { } words)
        {
            Append(text, words);
            return;
        }

        text.Append('[');
        Append(text, statement.Code!);
        foreach (var value in statement.Values)
        {
            text.Append(',');
            Append(text, value);
        }

        text.Append(']');
    }

    // What no database accepts, as in other texts: half a character, and the character 0.
    private static void Append(StringBuilder text, string words)
    {
        text.Append('"');
        if (!words.AsSpan().ContainsAny(Special))
        {
            text.Append(words).Append('"');
            return;
        }

        foreach (var rune in words.EnumerateRunes())
        {
            _ = rune.Value switch
            {
                0 => text.Append('\ufffd'),
                '"' or '\\' => text.Append('\\').Append((char)rune.Value),
                < ' ' => text.Append(CultureInfo.InvariantCulture, $"\\u{rune.Value:x4}"),
                _ => text.Append(rune.ToString()),
            };
        }

        text.Append('"');
    }

    private sealed class Reader(string text, IReadOnlyDictionary<string, SentenceForm> forms)
    {
        private int _at;

        /// <summary>True if nothing was read that can be recorded in another way.</summary>
        public bool IsAsRecorded { get; private set; } = true;

        public Statement Whole()
        {
            Expect(Marker, "the character U+001E");
            var statement = Array(1);
            return _at == text.Length ? statement : throw Unexpected("the end", _at);
        }

        public FormatException Unexpected(string expected, int at) => new(string.Create(
            CultureInfo.InvariantCulture,
            $"Found {(at < text.Length ? $"\"{text[at]}\"" : "the end")} at character {at + 1} of a statement; expected {expected}."));

        private Statement Array(int depth)
        {
            var from = _at;
            if (depth > Statement.MostDepth)
            {
                throw Unexpected($"at most {Statement.MostDepth} statements within each other", from);
            }

            Expect('[', "\"[\"");
            var code = Text();
            var form = forms.GetValueOrDefault(code);
            if (code.Length > 0 && form is null && !IsCode(code))
            {
                throw Unexpected("a code", from + 1);
            }

            var values = new List<Statement>();
            while (_at < text.Length && text[_at] == ',')
            {
                _at++;
                values.Add(_at < text.Length && text[_at] == '[' ? Array(depth + 1) : Text());
            }

            Expect(']', "\",\" or \"]\"");
            IsAsRecorded &= code.Length > 0;
            return code.Length == 0 ? Statement.InARow(values) : Statement.Of(code, values, form);
        }

        private string Text()
        {
            Expect('"', "a text");
            var length = text.AsSpan(_at).IndexOfAny(Special);
            if (length >= 0 && text[_at + length] == '"')
            {
                (var from, _at) = (_at, _at + length + 1);
                return text[from..(from + length)];
            }

            IsAsRecorded = false;
            var words = new StringBuilder();
            for (; _at < text.Length && text[_at] != '"'; _at++)
            {
                words.Append(text[_at] switch
                {
                    '\\' => Escaped(),
                    < ' ' => throw Unexpected("no control character", _at),
                    var plain => plain,
                });
            }

            Expect('"', "the text's end");
            return words.ToString();
        }

        private char Escaped()
        {
            var next = ++_at < text.Length ? text[_at] : '\0';
            if (next is '"' or '\\')
            {
                return next;
            }

            if (next == 'u' && _at + 4 < text.Length
                && ushort.TryParse(text.AsSpan(_at + 1, 4), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out var number))
            {
                _at += 4;
                return (char)number;
            }

            throw Unexpected("\\\", \\\\ or \\u and four digits", Math.Min(_at, text.Length));
        }

        private void Expect(char wanted, string expected) =>
            _at += _at < text.Length && text[_at] == wanted ? 1 : throw Unexpected(expected, _at);
    }
}
