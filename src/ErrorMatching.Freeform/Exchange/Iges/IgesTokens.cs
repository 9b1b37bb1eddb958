using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Splits free-format data into parameters. It handles the file's own delimiters and Hollerith strings that contain them, and
/// reads records on demand (IGES 5.3, section 2.2.3).</summary>
/// <param name="records">Returns the columns of a record by its number from 0; null after the last.</param>
/// <param name="delimiter">Delimiter between parameters.</param>
/// <param name="terminator">Delimiter after the last parameter.</param>
/// <param name="fail">Creates the error for a place in the text.</param>
internal sealed class IgesTokens(
    Func<int, ReadOnlyMemory<char>?> records, char delimiter, char terminator, Func<int, string, InputException> fail)
{
    private char[] _text = new char[64];
    private int _length;
    private int _records;

    /// <summary>The columns read so far.</summary>
    public ReadOnlyMemory<char> Text => _text.AsMemory(0, _length);

    /// <summary>Returns the parameters up to the terminator.</summary>
    /// <param name="mustEnd">False if the terminator may be missing at the end of the records.</param>
    public List<IgesToken> Split(bool mustEnd)
    {
        var tokens = new List<IgesToken>();
        var at = 0;
        while (true)
        {
            at = SkipBlanks(at);
            var start = at;
            while (Has(at) && char.IsAsciiDigit(_text[at]))
            {
                at++;
            }

            at = at > start && Has(at) && _text[at] == 'H' ? String(tokens, start, at) : Plain(tokens, start, at);
            if (!Has(at))
            {
                return mustEnd ? throw fail(start, $"the record does not end with {ExchangeLimits.Quote(terminator.ToString())}") : tokens;
            }

            if (_text[at] == terminator)
            {
                return tokens;
            }

            at++;
        }
    }

    private int String(List<IgesToken> tokens, int start, int at)
    {
        if (!int.TryParse(_text.AsSpan(start, at - start), NumberStyles.None, CultureInfo.InvariantCulture, out var length)
            || !Has(at + (long)length))
        {
            throw fail(
                start, $"a string of {ExchangeLimits.Quote(new(_text, start, at - start))} characters, which is longer than what follows");
        }

        tokens.Add(new(at + 1, length, IsText: true));
        var end = SkipBlanks(at + 1 + length);
        return !Has(end) || _text[end] == delimiter || _text[end] == terminator
            ? end
            : throw fail(
                start,
                $"{ExchangeLimits.Quote(_text[end].ToString())} behind a string of {length} characters; "
                    + $"{ExchangeLimits.Quote(delimiter.ToString())} or {ExchangeLimits.Quote(terminator.ToString())} is expected: is the "
                    + $"string as long as it says?");
    }

    private int Plain(List<IgesToken> tokens, int start, int at)
    {
        while (Has(at) && _text[at] != delimiter && _text[at] != terminator)
        {
            at++;
        }

        var end = at;
        while (end > start && _text[end - 1] == ' ')
        {
            end--;
        }

        tokens.Add(new(start, end - start, IsText: false));
        return at;
    }

    private int SkipBlanks(int at)
    {
        while (Has(at) && _text[at] == ' ')
        {
            at++;
        }

        return at;
    }

    private bool Has(long at)
    {
        while (at >= _length)
        {
            if (records(_records) is not { } more)
            {
                return false;
            }

            _records++;
            if (_length + more.Length > _text.Length)
            {
                Array.Resize(ref _text, Math.Max(2 * _text.Length, _length + more.Length));
            }

            more.Span.CopyTo(_text.AsSpan(_length));
            _length += more.Length;
        }

        return true;
    }
}
