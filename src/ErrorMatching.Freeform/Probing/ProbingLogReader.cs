using System.Globalization;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Reads the log that a probing program writes: a line that names the plan, then one a point,
/// then one that says that it is whole.</summary>
/// <remarks>
/// <c>ERRORMATCH PROBE PLAN 0123456789ABCDEF MM</c>, then <c>P12 C X1.5 Y2. Z-3.25</c>: point 12, C for the ball's center or S for the
/// contact, coordinates; then <c>END</c>, which may be missing. Behind a program that follows a measurement, <c>CUTBY</c> names it behind
/// the first line. Controls pad numbers with spaces and zeros, and put lines of their own around the file,
/// which begin with a percent sign or a semicolon.
/// </remarks>
internal sealed class ProbingLogReader(string file, MeasuringPlan plan)
{
    public const string FirstWord = "ERRORMATCH";
    private const string LastWord = "END";
    private const string CutBy = "CUTBY ";

    /// <summary>The measurement that the program followed which cut the surface just before;
    /// null if it followed none, or that is not known.</summary>
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
                begun = begun == 0
                    ? i + 1
                    : throw InputException.At(
                        "two-runs",
                        file,
                        string.Create(
                            CultureInfo.InvariantCulture,
                            $"a second run of the probing program begins here, the first began in line {begun}. Delete all but the one "
                                + $"that counts."),
                        i + 1);
                Head(line, i + 1);
            }
            else if (ended > 0)
            {
                throw InputException.At(
                    "bad-log",
                    file,
                    FormattableString.Invariant($"found {Shown(line)} behind {LastWord} in line {ended}; expected nothing more."),
                    i + 1);
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
                points.Add(new ProbedPointLine(file, line, i + 1).Read());
            }
        }

        return points;
    }

    private void Head(string line, int number)
    {
        var words = line.Split(' ', StringSplitOptions.RemoveEmptyEntries);
        if (words is not [FirstWord, "PROBE", "PLAN", var id, var unit])
        {
            throw InputException.At(
                "bad-log", file, $"found {Shown(line)}; expected {FirstWord} PROBE PLAN, the plan's number, and MM.", number);
        }

        if (unit != "MM")
        {
            throw InputException.At(
                "bad-log", file, $"found the unit {Shown(unit)}; expected MM: the log of a probing program is in millimetres.", number);
        }

        var expected = ProbingProgram.PlanId(plan);
        if (id != expected)
        {
            throw InputException.At(
                "other-plan",
                file,
                $"the log belongs to the plan {Shown(id)}; that of the job is {expected}. Was the job or its surface changed behind "
                    + $"surface probe?",
                number);
        }
    }

    internal static string Shown(string text) =>
        "\"" + string.Concat((text.Length <= 60 ? text : text[..60] + "...").Select(c => char.IsControl(c) ? '?' : c)) + "\"";
}

/// <summary>Reads one line of a probing log that says a point (<see cref="ProbedLine"/>).</summary>
/// <param name="file">The log.</param>
/// <param name="line">The line, without spaces around it.</param>
/// <param name="number">Its number in the file, from 1.</param>
internal sealed class ProbedPointLine(string file, string line, int number)
{
    /// <summary>The point.</summary>
    /// <exception cref="InputException">The line says none.</exception>
    public RawPoint Read() => ProbedLine.Read(line, out var read) is { } touch
        ? new(touch.Number, null, null, touch.Position, touch.IsCenter, number)
        : throw InputException.At(
            "bad-log",
            file,
            FormattableString.Invariant(
                $"found {ProbingLogReader.Shown(line)} at character {read + 1}; expected a point such as {ProbedLine.Example}."),
            number,
            read + 1);
}
