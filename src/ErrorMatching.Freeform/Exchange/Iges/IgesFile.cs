using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>An IGES file: its unit and directory, and the parameters of each entity on demand.</summary>
internal sealed class IgesFile
{
    private readonly IgesSections _sections;
    private readonly Dictionary<int, IgesParameters> _parameters = [];
    private readonly (char Delimiter, char Terminator) _delimiters;
    private long _budget;

    /// <summary>Reads the global section and the directory.</summary>
    /// <exception cref="InputException">The file is not a fixed-form IGES file, or it is broken.</exception>
    public IgesFile(ReadOnlySpan<byte> bytes, string file)
    {
        _sections = new(bytes, file);
        _budget = 1_000_000 + (8L * bytes.Length);
        if (_sections.DirectoryCount == 0)
        {
            throw Fail("no-directory", "no directory (records with D in column 73); an IGES file of 80 columns is expected");
        }

        if (_sections.DirectoryCount % 2 != 0)
        {
            throw Fail(
                "bad-record",
                "the directory has an odd number of records; each entity has two",
                _sections.DirectoryLine(_sections.DirectoryCount - 1));
        }

        (var delimiter, var terminator, MillimetersPerUnit) = ReadGlobal();
        _delimiters = (delimiter, terminator);
        var entities = new IgesEntity[_sections.DirectoryCount / 2];
        for (var i = 0; i < entities.Length; i++)
        {
            entities[i] = IgesEntity.Read(_sections, 2 * i);
        }

        Entities = entities;
    }

    public string Name => _sections.File;

    public double MillimetersPerUnit { get; }

    /// <summary>The directory in file order.</summary>
    public IReadOnlyList<IgesEntity> Entities { get; }

    /// <summary>Resolves a pointer to an entity.</summary>
    /// <param name="sequence">The D number.</param>
    /// <param name="from">The entity that contains the pointer.</param>
    /// <param name="what">What the pointer should refer to, for the message.</param>
    public IgesEntity At(int sequence, IgesEntity from, string what)
    {
        var index = (sequence - 1) / 2;
        return sequence > 0 && sequence % 2 == 1 && index < Entities.Count
            ? Entities[index]
            : throw Fail(
                "bad-pointer",
                $"{from} points to D{sequence} for {what}; the directory has D1 to D{(2 * Entities.Count) - 1}, odd numbers",
                from.Line);
    }

    /// <summary>The parameters of an entity, starting at the first.</summary>
    public IgesParameters ParametersOf(IgesEntity entity)
    {
        if (_parameters.TryGetValue(entity.Sequence, out var known))
        {
            return known.Restart();
        }

        if (entity.FirstParameter < 1 || entity.FirstParameter > _sections.ParameterCount)
        {
            throw Fail(
                "bad-pointer",
                $"{entity} has its parameters at P{entity.FirstParameter}; the file has "
                    + $"{(_sections.ParameterCount == 0 ? "no parameters: is it cut off?" : $"P1 to P{_sections.ParameterCount}")}",
                entity.Line);
        }

        InputException At(int at, string problem) =>
            Fail("bad-record", $"{entity}: {problem}", _sections.ParameterLine(entity.FirstParameter - 1 + (at / 64)));
        var reader = new IgesTokens(r => Record(entity, r), _delimiters.Delimiter, _delimiters.Terminator, At);
        var tokens = reader.Split(mustEnd: true);
        var first = reader.Text.Span.Slice(tokens[0].Start, tokens[0].Length);
        if (!int.TryParse(first, NumberStyles.None, CultureInfo.InvariantCulture, out var type) || type != entity.Type)
        {
            throw At(0, $"its parameters begin with {ExchangeLimits.Quote(first.ToString())}; its type is expected");
        }

        var parameters = new IgesParameters(_sections, entity, reader.Text, tokens);
        _parameters.Add(entity.Sequence, parameters);
        return parameters;
    }

    public InputException Fail(string code, string problem, int? line = null) => InputException.At(code, Name, problem, line);

    // Records of different entities may overlap in a broken file. Their total must not exceed the size of the file.
    private ReadOnlyMemory<char>? Record(IgesEntity entity, int record)
    {
        _budget -= 64;
        return _budget >= 0
            ? _sections.Parameters(entity.FirstParameter - 1 + record)
            : throw Fail("too-large", "records of parameters overlap", entity.Line);
    }

    private (char Delimiter, char Terminator, double MillimetersPerUnit) ReadGlobal()
    {
        var head = (_sections.Global(0) ?? ReadOnlyMemory<char>.Empty).Span;
        var (delimiter, terminator) = (',', ';');
        if (head.StartsWith("1H"))
        {
            delimiter = head[2];
            head = head[4..];
            terminator = head.StartsWith("1H") ? head[2] : terminator;
        }
        else if (head.StartsWith(",1H"))
        {
            terminator = head[3];
        }

        if (delimiter == terminator || !IsDelimiter(delimiter) || !IsDelimiter(terminator))
        {
            throw Fail(
                "bad-delimiter",
                $"{ExchangeLimits.Quote(delimiter.ToString())} and {ExchangeLimits.Quote(terminator.ToString())} as delimiters; two "
                    + $"different characters are expected that no number has",
                _sections.GlobalLine(0));
        }

        InputException At(int at, string problem) => Fail("bad-record", $"global section: {problem}", _sections.GlobalLine(at / 72));
        var reader = new IgesTokens(_sections.Global, delimiter, terminator, At);
        var tokens = reader.Split(mustEnd: false);
        var text = reader.Text;
        string Value(int number) =>
            number <= tokens.Count ? text.Slice(tokens[number - 1].Start, tokens[number - 1].Length).Span.Trim().ToString() : "";
        var scale = Value(13) is { Length: > 0 } spelled
            ? double.TryParse(spelled.Replace('D', 'E'), NumberStyles.Float, CultureInfo.InvariantCulture, out var s)
            ? s
            : double.NaN
            : 1;
        var flag = Value(14) is { Length: > 0 } f
            ? int.TryParse(f, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var n)
            ? n
            : -1
            : 1;
        var millimeters = IgesUnit.Millimeters(flag, Value(15))
            ?? throw Fail(
                "bad-unit",
                $"unit flag {ExchangeLimits.Quote(Value(14))} with unit {ExchangeLimits.Quote(Value(15))} (parameters 14 and 15 of the "
                    + $"global section); 1 with INCH, 2 with MM or another pair of IGES is expected",
                _sections.GlobalLine(0));
        return double.IsFinite(scale) && scale > 0
            ? (delimiter, terminator, millimeters / scale)
            : throw Fail(
                "bad-unit",
                $"a model space scale of {ExchangeLimits.Quote(Value(13))} (parameter 13 of the global section); a positive number is "
                    + $"expected",
                _sections.GlobalLine(0));
    }

    private static bool IsDelimiter(char c) => c is > ' ' and <= '~' && !char.IsAsciiLetterOrDigit(c) && c is not ('+' or '-' or '.');
}
