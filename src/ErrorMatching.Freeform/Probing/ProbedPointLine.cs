using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Reads one line of a probing log that says a point, from left to right: <c>P12 C X1.5 Y2. Z-3.25</c>.</summary>
/// <param name="file">The log.</param>
/// <param name="line">The line, without spaces around it.</param>
/// <param name="number">Its number in the file, from 1.</param>
internal sealed class ProbedPointLine(string file, string line, int number)
{
    private int _at;

    /// <summary>The point.</summary>
    /// <exception cref="InputException">The line says none.</exception>
    public RawPoint Read()
    {
        var point = Number('P');
        var kind = Next is 'C' or 'S' ? line[_at++] : throw Fail();
        var position = new Point3(Number('X'), Number('Y'), Number('Z'));
        var isPoint = _at == line.Length && point is >= 0 and <= int.MaxValue && point == Math.Floor(point) && position.IsFinite;
        return isPoint ? new((int)point, null, null, position, kind == 'C', number) : throw Fail();
    }

    // The character that comes next; behind the line's end it is none that can stand there.
    private char Next => _at < line.Length ? line[_at] : '\0';

    private double Number(char letter)
    {
        SkipSpaces();
        if (_at >= line.Length || line[_at++] != letter)
        {
            throw Fail();
        }

        SkipSpaces();
        var text = Take(c => char.IsAsciiDigit(c) || c is '-' or '+' or '.');
        if (text is "-" or "+")
        {
            // The sign may stand before the padding.
            SkipSpaces();
            text += Take(c => char.IsAsciiDigit(c) || c is '.');
        }

        const NumberStyles Style = NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint | NumberStyles.AllowExponent;
        var value = double.TryParse(text + Exponent(), Style, CultureInfo.InvariantCulture, out var read) ? read : throw Fail();
        SkipSpaces();
        return value;
    }

    // Of a value close to nothing: E-07, or EX-07 as Siemens writes it.
    private string Exponent()
    {
        if (Next is not ('E' or 'e'))
        {
            return "";
        }

        _at++;
        _at += Next is 'X' or 'x' ? 1 : 0;
        var sign = Next is '-' or '+' ? line[_at++].ToString() : "";
        return "E" + sign + Take(char.IsAsciiDigit);
    }

    private string Take(Func<char, bool> belongs)
    {
        var start = _at;
        while (_at < line.Length && belongs(line[_at]))
        {
            _at++;
        }

        return line[start.._at];
    }

    private void SkipSpaces()
    {
        while (Next is ' ' or '\t')
        {
            _at++;
        }
    }

    private InputException Fail() => InputException.At(
        "bad-log",
        file,
        FormattableString.Invariant(
            $"found {ProbingLogReader.Shown(line)} at character {_at + 1}; expected a point such as P12 C X1.5 Y2.0 Z-3.25."),
        number,
        _at + 1);
}
