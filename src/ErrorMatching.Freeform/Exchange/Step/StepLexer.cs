using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Parses the values of an instance in a STEP file (ISO 10303-21, section 6).</summary>
/// <param name="text">The text of the file.</param>
/// <param name="at">Where parsing starts.</param>
/// <param name="fail">Creates the error for a place in the text.</param>
internal sealed class StepLexer(string text, int at, Func<int, string, InputException> fail)
{
    private const int LongestNumber = 100;

    /// <summary>The current position.</summary>
    public int At { get; private set; } = at;

    /// <summary>Skips blanks, line ends and comments.</summary>
    public static int SkipBlanks(string text, int at)
    {
        while (at < text.Length)
        {
            if (text[at] <= ' ')
            {
                at++;
            }
            else if (text[at] == '/' && at + 1 < text.Length && text[at + 1] == '*')
            {
                var end = text.IndexOf("*/", at + 2, StringComparison.Ordinal);
                at = end < 0 ? text.Length : end + 2;
            }
            else
            {
                return at;
            }
        }

        return text.Length;
    }

    /// <summary>Returns the next nonblank character without consuming it; 0 at the end.</summary>
    public char Peek()
    {
        At = SkipBlanks(text, At);
        return At < text.Length ? text[At] : '\0';
    }

    /// <summary>Consumes a required character.</summary>
    public void Take(char expected)
    {
        var found = Peek();
        At = found == expected ? At + 1 : throw Unexpected($"\"{expected}\"");
    }

    public string Keyword()
    {
        Peek();
        var start = At;
        while (At < text.Length && (char.IsAsciiLetterOrDigit(text[At]) || text[At] is '_' or '-' or '!'))
        {
            At++;
        }

        return At > start ? text[start..At].ToUpperInvariant() : throw Unexpected("the name of a type");
    }

    /// <summary>Reads values in parentheses.</summary>
    public List<StepValue> List(int depth = 0)
    {
        if (depth > ExchangeLimits.MaxDepth)
        {
            throw fail(At, $"lists are nested deeper than {ExchangeLimits.MaxDepth}");
        }

        Take('(');
        var items = new List<StepValue>();
        if (Peek() == ')')
        {
            At++;
            return items;
        }

        while (true)
        {
            items.Add(Value(depth));
            if (Peek() == ')')
            {
                At++;
                return items;
            }

            Take(',');
        }
    }

    private StepValue Value(int depth)
    {
        var next = Peek();
        switch (next)
        {
            case '$' or '*':
                At++;
                return StepValue.Omitted;
            case '(':
                return new(StepValueKind.List, "", 0, List(depth + 1));
            case '\'':
                return new(StepValueKind.Text, StepText.Read(text, Quoted('\'')), 0, []);
            case '"':
                Quoted('"');
                return StepValue.Omitted;
            case '.':
                var start = ++At;
                while (At < text.Length && (char.IsAsciiLetterOrDigit(text[At]) || text[At] == '_'))
                {
                    At++;
                }

                var word = text[start..At].ToUpperInvariant();
                Take('.');
                return new(StepValueKind.Word, word, 0, []);
            case '#':
                At++;
                return new(StepValueKind.Reference, "", Number(), []);
            case '+' or '-' or (>= '0' and <= '9'):
                return new(StepValueKind.Number, "", Number(), []);
            default:
                return new(StepValueKind.Typed, Keyword(), 0, List(depth + 1));
        }
    }

    private double Number()
    {
        var start = At;
        while (At < text.Length && (char.IsAsciiDigit(text[At]) || text[At] is '+' or '-' or '.' or 'E' or 'e'))
        {
            At++;
        }

        return At - start <= LongestNumber
            && double.TryParse(
                text.AsSpan(start, At - start),
                NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint | NumberStyles.AllowExponent,
                CultureInfo.InvariantCulture,
                out var number)
            && double.IsFinite(number)
            ? number
            : throw fail(start, $"{ExchangeLimits.Quote(text[start..At])} where a number is expected");
    }

    // The range between the quotation marks. A doubled mark stands for one.
    private Range Quoted(char mark)
    {
        var start = ++At;
        while (true)
        {
            var end = text.IndexOf(mark, At);
            if (end < 0)
            {
                throw fail(start - 1, "a string without end");
            }

            At = end + 1;
            if (At >= text.Length || text[At] != mark)
            {
                return start..end;
            }

            At++;
        }
    }

    private InputException Unexpected(string expected) =>
        fail(At, (At < text.Length ? ExchangeLimits.Quote(text[At].ToString()) : "the end of the file") + $" where {expected} is expected");
}
