using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Measurement;

/// <summary>A line of the log that a probing program of ours writes, for one touch: <c>P12 C X1.5 Y2. Z-3.25</c>.</summary>
/// <param name="Number">Number of the point in its plan.</param>
/// <param name="IsCenter">True for the center of the ball (<c>C</c>), false for the contact (<c>S</c>).</param>
/// <param name="Position">The place in millimeters.</param>
public sealed record ProbedLine(int Number, bool IsCenter, Point3 Position)
{
    /// <summary>First words of a log: the plan's number and <c>MM</c> follow.</summary>
    public const string Head = "ERRORMATCH PROBE PLAN";

    /// <summary>Last line of a log.</summary>
    public const string End = "END";

    /// <summary>A line as it should look, for messages.</summary>
    public const string Example = "P12 C X1.5 Y2.0 Z-3.25";

    /// <summary>Reads a line from left to right. Controls pad numbers with blanks and zeros, put the sign before the padding, and write
    /// small values with exponents (<c>E-07</c>, <c>EX-07</c>).</summary>
    /// <param name="line">The line, without spaces around it.</param>
    /// <param name="read">Number of characters that could be read.</param>
    /// <returns>Null if the line says no point.</returns>
    public static ProbedLine? Read(string line, out int read)
    {
        ArgumentNullException.ThrowIfNull(line);
        var at = 0;
        var number = Number('P');
        var kind = at < line.Length && line[at] is 'C' or 'S' ? line[at] : '\0';
        at += kind == '\0' ? 0 : 1;
        Point3? position = kind == '\0' || number is null ? null : Place();
        read = at;
        return position is { IsFinite: true } place && at == line.Length && number is >= 0 and <= int.MaxValue
            && number == Math.Floor(number.Value)
                ? new((int)number.Value, kind == 'C', place)
                : null;

        Point3? Place() => Number('X') is { } x && Number('Y') is { } y && Number('Z') is { } z ? new Point3(x, y, z) : null;

        double? Number(char letter)
        {
            Skip();
            if (at >= line.Length || line[at] != letter)
            {
                return null;
            }

            at++;
            Skip();
            var text = Take(c => char.IsAsciiDigit(c) || c is '-' or '+' or '.');
            if (text is "-" or "+")
            {
                Skip();
                text += Take(c => char.IsAsciiDigit(c) || c is '.');
            }

            const NumberStyles Style = NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint | NumberStyles.AllowExponent;
            if (!double.TryParse(text + Exponent(), Style, CultureInfo.InvariantCulture, out var value))
            {
                return null;
            }

            Skip();
            return value;
        }

        string Exponent()
        {
            if (at >= line.Length || line[at] is not ('E' or 'e'))
            {
                return "";
            }

            at++;
            at += at < line.Length && line[at] is 'X' or 'x' ? 1 : 0;
            var sign = at < line.Length && line[at] is '-' or '+' ? line[at++].ToString() : "";
            return "E" + sign + Take(char.IsAsciiDigit);
        }

        string Take(Func<char, bool> belongs)
        {
            var start = at;
            while (at < line.Length && belongs(line[at]))
            {
                at++;
            }

            return line[start..at];
        }

        void Skip() => Take(c => c is ' ' or '\t');
    }
}
