using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Reads the parameters of one entity in sequence. Every error names the entity, parameter and line.</summary>
internal sealed class IgesParameters(IgesSections sections, IgesEntity entity, ReadOnlyMemory<char> text, IReadOnlyList<IgesToken> tokens)
{
    private int _next = 1; // the first one repeats the entity's type

    public int Left => Math.Max(0, tokens.Count - _next);

    /// <summary>Restarts after the entity type.</summary>
    public IgesParameters Restart()
    {
        _next = 1;
        return this;
    }

    /// <summary>Reads an integer; 0 if omitted.</summary>
    public int Int(string name)
    {
        var value = Take(name);
        return value.IsEmpty ? 0
            : int.TryParse(value, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var number) ? number
            : throw Fail("bad-number", $"{ExchangeLimits.Quote(value.ToString())} for {name}; a whole number is expected");
    }

    /// <summary>Reads an integer within limits.</summary>
    public int Int(string name, int least, int most)
    {
        var number = Int(name);
        return number >= least && number <= most ? number : throw Fail("bad-number", $"{number} for {name}; {least} to {most} is expected");
    }

    /// <summary>Reads a number; 0 if omitted.</summary>
    public double Real(string name)
    {
        var value = Take(name);
        if (value.IsEmpty)
        {
            return 0;
        }

        Span<char> spelled = stackalloc char[64];
        if (value.Length <= spelled.Length)
        {
            value.CopyTo(spelled);
            spelled = spelled[..value.Length];
            spelled.Replace('D', 'E');
            spelled.Replace('d', 'e');
            if (double.TryParse(
                spelled,
                NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint | NumberStyles.AllowExponent,
                CultureInfo.InvariantCulture,
                out var number)
                && double.IsFinite(number))
            {
                return number;
            }
        }

        throw Fail("bad-number", $"{ExchangeLimits.Quote(value.ToString())} for {name}; a number is expected");
    }

    public double[] Reals(string name, int count)
    {
        Need(count, name);
        var values = new double[count];
        for (var i = 0; i < count; i++)
        {
            values[i] = Real(name);
        }

        return values;
    }

    /// <summary>Reads a string; empty if omitted.</summary>
    public string Text(string name) => Take(name).ToString();

    /// <summary>Skips parameters; false if there are too few.</summary>
    public bool Skip(long count)
    {
        if (count < 0 || count > Left)
        {
            return false;
        }

        _next += (int)count;
        return true;
    }

    /// <summary>Throws if too few parameters remain, before memory is allocated for them.</summary>
    public void Need(long count, string name)
    {
        if (count > Left)
        {
            throw Fail("short-record", $"{Left} parameters are left where {count} are expected for {name}");
        }
    }

    /// <summary>Creates an error at the last parameter read.</summary>
    public InputException Fail(string code, string problem)
    {
        var at = tokens.Count == 0 ? 0 : tokens[Math.Clamp(_next - 1, 0, tokens.Count - 1)].Start;
        var record = Math.Clamp(entity.FirstParameter - 1 + (at / 64), 0, sections.ParameterCount - 1);
        return InputException.At(code, sections.File, $"{entity}: {problem}", sections.ParameterLine(record));
    }

    private ReadOnlySpan<char> Take(string name)
    {
        if (_next >= tokens.Count)
        {
            throw Fail("short-record", $"the record ends before {name}");
        }

        var token = tokens[_next++];
        return text.Span.Slice(token.Start, token.Length);
    }
}
