using System.Globalization;
using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>A STEP file (ISO 10303-21): the positions of its instances, which are parsed on demand.</summary>
internal sealed class StepFile
{
    private readonly string _text;
    private readonly Dictionary<long, (int Offset, int End, int Line)> _instances = [];
    private readonly List<long> _order = [];
    private long _budget;

    /// <summary>Finds the instances of a file.</summary>
    /// <exception cref="InputException">The file is not a STEP file, or is truncated or broken.</exception>
    public StepFile(ReadOnlySpan<byte> bytes, string name)
    {
        Name = name;
        _text = Encoding.Latin1.GetString(bytes);
        _budget = 1_000_000 + (8L * bytes.Length);
        if (!_text.AsSpan(StepLexer.SkipBlanks(_text, 0)).StartsWith("ISO-10303-21"))
        {
            throw InputException.At("no-step", name, "it does not begin with ISO-10303-21; a STEP file is expected", 1);
        }

        Index();
        if (_order.Count == 0)
        {
            throw InputException.At("no-data", name, "no instance (#1 = ...;) in its DATA section");
        }
    }

    public string Name { get; }

    /// <summary>Instances whose types satisfy a condition, in file order. The type of a complex instance is empty.</summary>
    public IEnumerable<StepInstance> Where(Func<string, bool> wanted) =>
        _order.Where(id => wanted(KeywordAt(_instances[id].Offset))).Select(id => At(id)!);

    /// <summary>Numbers of the instances whose types satisfy a condition, in file order: nothing of them is parsed.</summary>
    public IEnumerable<long> Ids(Func<string, bool> wanted) => _order.Where(id => wanted(KeywordAt(_instances[id].Offset)));

    /// <summary>True if an instance of the file contains a text, whatever it means there.</summary>
    public bool Contains(long id, string text) =>
        _text.AsSpan(_instances[id].Offset, _instances[id].End - _instances[id].Offset).Contains(text, StringComparison.OrdinalIgnoreCase);

    /// <summary>Line where an instance of the file starts.</summary>
    public int LineOf(long id) => _instances[id].Line;

    public int Count(Func<string, bool> wanted) => _order.Count(id => wanted(KeywordAt(_instances[id].Offset)));

    /// <summary>Returns an instance; null if the file has none with this number.</summary>
    /// <exception cref="InputException">It is broken.</exception>
    public StepInstance? At(long id)
    {
        if (!_instances.TryGetValue(id, out var place))
        {
            return null;
        }

        InputException Fail(int at, string problem) =>
            InputException.At(
                "bad-instance",
                Name,
                string.Create(CultureInfo.InvariantCulture, $"#{id}: {problem}"),
                place.Line + _text.AsSpan(place.Offset, Math.Min(at, _text.Length) - place.Offset).Count('\n'));
        var lexer = new StepLexer(_text, place.Offset, Fail);
        var records = new List<StepRecord>();
        if (lexer.Peek() == '(')
        {
            lexer.Take('(');
            while (lexer.Peek() != ')')
            {
                records.Add(new(this, id, place.Line, lexer.Keyword(), lexer.List()));
            }

            lexer.Take(')');
        }
        else
        {
            records.Add(new(this, id, place.Line, lexer.Keyword(), lexer.List()));
        }

        lexer.Take(';');
        _budget -= lexer.At - place.Offset;
        return records.Count == 0 ? throw Fail(place.Offset, "an instance without a type")
            : _budget < 0
                ? throw InputException.At(
                    "too-large",
                    Name,
                    $"instances refer to #{id.ToString(CultureInfo.InvariantCulture)} and others again and again",
                    place.Line)
            : new(id, place.Line, records);
    }

    private string KeywordAt(int offset)
    {
        var start = StepLexer.SkipBlanks(_text, offset);
        var end = start;
        while (end < _text.Length && (char.IsAsciiLetterOrDigit(_text[end]) || _text[end] == '_'))
        {
            end++;
        }

        return _text[start..end].ToUpperInvariant();
    }

    private void Index()
    {
        var (line, counted) = (1, 0);
        for (var at = StepLexer.SkipBlanks(_text, 0); at < _text.Length; at = StepLexer.SkipBlanks(_text, at))
        {
            line += _text.AsSpan(counted, at - counted).Count('\n');
            counted = at;
            var end = StatementEnd(at);
            if (end < 0)
            {
                throw InputException.At(
                    "truncated", Name, "the file ends within a statement: it is cut off, or a ; or ' is missing", line);
            }

            if (_text[at] == '#')
            {
                Add(at, end, line);
            }

            at = end + 1;
        }
    }

    private void Add(int at, int end, int line)
    {
        var digits = at + 1;
        while (char.IsAsciiDigit(_text[digits]))
        {
            digits++;
        }

        var equals = StepLexer.SkipBlanks(_text, digits);
        if (!long.TryParse(_text.AsSpan(at + 1, digits - at - 1), NumberStyles.None, CultureInfo.InvariantCulture, out var id)
            || id > 1L << 52
            || equals >= end
            || _text[equals] != '=')
        {
            throw InputException.At(
                "bad-instance", Name, $"{ExchangeLimits.Quote(_text[at..end])}; #number = TYPE(...); is expected", line);
        }

        if (!_instances.TryAdd(id, (equals + 1, end, line)))
        {
            throw InputException.At("bad-instance", Name, string.Create(CultureInfo.InvariantCulture, $"#{id} is there twice"), line);
        }

        _order.Add(id);
    }

    // The semicolon that ends a statement, outside strings and comments; -1 if there is none.
    private int StatementEnd(int at)
    {
        while (at < _text.Length)
        {
            var next = _text.AsSpan(at).IndexOfAny(';', '\'', '/');
            if (next < 0)
            {
                return -1;
            }

            at += next;
            switch (_text[at])
            {
                case ';':
                    return at;
                case '\'':
                    at = _text.IndexOf('\'', at + 1) + 1;
                    if (at == 0)
                    {
                        return -1;
                    }

                    break;
                default:
                    var after = StepLexer.SkipBlanks(_text, at);
                    at = after > at ? after : at + 1;
                    break;
            }
        }

        return -1;
    }
}
