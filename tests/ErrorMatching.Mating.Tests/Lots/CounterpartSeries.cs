using System.Text;

namespace ErrorMatching.Mating.Tests;

/// <summary>Counterparts cut and measured one after the other, each by the program that the match of the one before it made. The boundary
/// is a line of five points that the tool follows above; the part is as designed unless it says otherwise.</summary>
internal sealed class CounterpartSeries(double uncertaintyMm, bool goesOn = true)
{
    private string _program = Programs.ToolAbove;
    private PreviousMatch? _previous;

    /// <summary>Where the points are along the line.</summary>
    public static IReadOnlyList<double> Places { get; } = [5, 15, 25, 35, 45];

    /// <summary>Where the program for the next counterpart has the middle of the line, mm.</summary>
    public double NowMm { get; private set; }

    /// <summary>Measures the next counterpart and matches the program to it.</summary>
    /// <param name="heights">Where its points are.</param>
    /// <param name="toolChanged">True if the tool was changed before it.</param>
    public MatchResult Measure(Func<int, double> heights, bool toolChanged = false)
    {
        var input = Case(Line(heights), _program, uncertaintyMm).Input;
        var outcome = Matcher.Match(input with { Previous = goesOn ? _previous : null, ToolChanged = toolChanged });
        Assert.True(outcome.Result is not null, string.Join('\n', outcome.Refusals));
        var match = outcome.Result;
        (_program, _previous) = (Encoding.Latin1.GetString(match.Program.Span), new("report.json", "", match.Lot!.Pieces));

        // From the words of the program.
        var line = match.After.Motions[match.Maps[0].Passes[0].Feet[2].Motion];
        NowMm = ((line.Start.Y + line.End.Y) / 2) - 3;
        return match;
    }

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
