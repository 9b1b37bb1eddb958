using System.Text;

namespace ErrorMatching.Mating.Tests;

/// <summary>Counterparts cut and measured one after the other, each by the program that the match of the one before it made. The boundary
/// is a line of five points that the tool follows above; the part is as designed unless it says otherwise.</summary>
/// <param name="uncertaintyMm">The gauge's.</param>
/// <param name="goesOn">True if each match knows those before it.</param>
/// <param name="delay">Number of counterparts that are cut before the one before them is measured.</param>
internal sealed class CounterpartSeries(double uncertaintyMm, bool goesOn = true, int delay = 0)
{
    private readonly List<(string Program, PreviousMatch? Match, double Mm)> _made = [(Programs.ToolAbove, null, 0)];

    /// <summary>Where the points are along the line.</summary>
    public static IReadOnlyList<double> Places { get; } = [5, 15, 25, 35, 45];

    /// <summary>Where the program for the next counterpart has the middle of the line, mm.</summary>
    public double NowMm => By(0).Mm;

    // What cuts a counterpart that many after the next one to be measured.
    private (string Program, PreviousMatch? Match, double Mm) By(int after) => _made[Math.Max(0, _made.Count - 1 - delay + after)];

    /// <summary>Measures the next counterpart and matches the program to it.</summary>
    /// <param name="heights">Where its points are.</param>
    /// <param name="toolChanged">True if the tool was changed before it.</param>
    /// <param name="isAgain">True to measure the last one once more: the new measurement replaces the old.</param>
    public MatchResult Measure(Func<int, double> heights, bool toolChanged = false, bool isAgain = false)
    {
        var by = By(isAgain ? -1 : 0);
        var input = Case(Line(heights), by.Program, uncertaintyMm).Input;
        var outcome = Matcher.Match(input with
        {
            Previous = goesOn ? by.Match : null,
            Latest = goesOn && delay > 0 ? _made[isAgain ? ^2 : ^1].Match : null,
            ToolChanged = toolChanged,
        });
        Assert.True(outcome.Result is not null, string.Join('\n', outcome.Refusals));
        var match = outcome.Result;

        // From the words of the program.
        var line = match.After.Motions[match.Maps[0].Passes[0].Feet[2].Motion];
        if (isAgain)
        {
            _made.RemoveAt(_made.Count - 1);
        }

        _made.Add((
            Encoding.Latin1.GetString(match.Program.Span),
            new("report.json", "", match.Lot!.Pieces),
            ((line.Start.Y + line.End.Y) / 2) - 3));
        return match;
    }

    /// <summary>Cuts a counterpart that nobody measures.</summary>
    public void Skip() => _made.Add(_made[^1]);

    /// <summary>The points of a line.</summary>
    public static string Line(Func<int, double> heights) =>
        string.Join("; ", Places.Select((x, i) => FormattableString.Invariant($"{i + 1} {x} {heights(i):R}")));

    /// <summary>The match of a counterpart that a program cut.</summary>
    public static MatchCase Case(string counterpart, string program, double uncertaintyMm) => new(program)
    {
        Theoretical = Line(_ => 0),
        Part = Line(_ => 0),
        Counterpart = counterpart,
        Features = [MatchCase.Feature("line", "L1", "N50", """["1", "2", "3", "4", "5"]""")],
        Compensation = """{ "from": "counterpart", "limitMm": 1 }""",
        Gauge = FormattableString.Invariant($""" "uncertaintyMm": {uncertaintyMm} """),
    };
}
