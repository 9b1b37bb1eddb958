using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Reads the log that a probing program writes: a line that names the plan, then one a point, then one that says that it is whole.</summary>
/// <remarks>
/// <c>ERRORMATCH PROBE PLAN 0123456789ABCDEF MM</c>, then <c>P12 C X1.5 Y2. Z-3.25</c>: point 12, C for the ball's center or S for the contact, coordinates; then <c>END</c>, which may be missing. Behind a program
/// that follows a measurement, <c>CUTBY</c> names it behind the first line. Controls pad numbers with spaces and zeros, and
/// put lines of their own around the file, which begin with a percent sign or a semicolon.
/// </remarks>
internal sealed class ProbingLogReader(string file, MeasuringPlan plan)
{
    public const string FirstWord = "ERRORMATCH";
    private const string LastWord = "END";
    private const string CutBy = "CUTBY ";

    /// <summary>The measurement that the program followed which cut the surface just before; null if it followed none, or that is not known.</summary>
    public string? CutByMeasurement { get; private set; }

    public IReadOnlyList<RawPoint> Read(IReadOnlyList<string> lines)
    {
        var points = new List<RawPoint>();
        var (begun, ended) = (0, 0);
        for (var i = 0; i < lines.Count; i++)
        {
            var line = lines[i].Trim();
            if (line.Length == 0 || line[0] is '%' or ';')
            {
                continue;
            }

            if (line.StartsWith(FirstWord, StringComparison.Ordinal))
            {
                begun = begun == 0 ? i + 1 : throw new FreeformException("two-runs", file, FormattableString.Invariant($"a second run of the probing program begins here, the first began in line {begun}. Delete all but the one that counts."), i + 1);
                Head(line, i + 1);
            }
            else if (ended > 0)
            {
                throw new FreeformException("bad-log", file, FormattableString.Invariant($"found {Shown(line)} behind {LastWord} in line {ended}; expected nothing more."), i + 1);
            }
            else if (line.StartsWith(CutBy, StringComparison.Ordinal))
            {
                CutByMeasurement = line[CutBy.Length..].Trim().ToLowerInvariant();
            }
            else if (line == LastWord)
            {
                ended = i + 1;
            }
            else
            {
                points.Add(Point(line, i + 1));
            }
        }

        return points;
    }

    private void Head(string line, int number)
    {
        var words = line.Split(' ', StringSplitOptions.RemoveEmptyEntries);
        if (words is not [FirstWord, "PROBE", "PLAN", var id, var unit])
        {
            throw new FreeformException("bad-log", file, $"found {Shown(line)}; expected {FirstWord} PROBE PLAN, the plan's number, and MM.", number);
        }

        if (unit != "MM")
        {
            throw new FreeformException("bad-log", file, $"found the unit {Shown(unit)}; expected MM: the log of a probing program is in millimetres.", number);
        }

        var expected = ProbingProgram.PlanId(plan);
        if (id != expected)
        {
            throw new FreeformException("other-plan", file, $"the log belongs to the plan {Shown(id)}; that of the job is {expected}. Was the job or its surface changed behind surface probe?", number);
        }
    }

    private RawPoint Point(string line, int number)
    {
        var at = 0;
        var point = Number('P');
        var kind = at < line.Length && line[at] is 'C' or 'S' ? line[at++] : throw Fail();
        var position = new Point3(Number('X'), Number('Y'), Number('Z'));
        return at == line.Length && point is >= 0 and <= int.MaxValue && point == Math.Floor(point) && position.IsFinite ? new((int)point, null, null, position, kind == 'C', number) : throw Fail();

        double Number(char letter)
        {
            Skip();
            if (at >= line.Length || line[at++] != letter)
            {
                throw Fail();
            }

            Skip();
            var start = at;
            while (at < line.Length && (char.IsAsciiDigit(line[at]) || line[at] is '-' or '+' or '.'))
            {
                at++;
            }

            // The sign may stand before the padding.
            var text = line[start..at];
            if (text is "-" or "+")
            {
                Skip();
                start = at;
                while (at < line.Length && (char.IsAsciiDigit(line[at]) || line[at] is '.'))
                {
                    at++;
                }

                text += line[start..at];
            }

            text += Exponent();
            var value = double.TryParse(text, NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint | NumberStyles.AllowExponent, CultureInfo.InvariantCulture, out var read) ? read : throw Fail();
            Skip();
            return value;
        }

        // Of a value close to nothing: E-07, or EX-07 as Siemens writes it.
        string Exponent()
        {
            if (at >= line.Length || line[at] is not ('E' or 'e'))
            {
                return "";
            }

            at += at + 1 < line.Length && line[at + 1] is 'X' or 'x' ? 2 : 1;
            var start = at;
            while (at < line.Length && (char.IsAsciiDigit(line[at]) || (at == start && line[at] is '-' or '+')))
            {
                at++;
            }

            return "E" + line[start..at];
        }

        void Skip()
        {
            while (at < line.Length && line[at] is ' ' or '\t')
            {
                at++;
            }
        }

        FreeformException Fail() => new("bad-log", file, FormattableString.Invariant($"found {Shown(line)} at character {at + 1}; expected a point such as P12 C X1.5 Y2.0 Z-3.25."), number, at + 1);
    }

    internal static string Shown(string text) => "\"" + string.Concat((text.Length <= 60 ? text : text[..60] + "...").Select(c => char.IsControl(c) ? '?' : c)) + "\"";
}
