using System.Text;
using ErrorMatching.Testing;

namespace ErrorMatching.Mating.Tests;

/// <summary>Lots of counterparts, each corrected by a whole match of the one before it: what they cost against a filter that knows how
/// the process behaves.</summary>
public sealed class LotThroughMatchTests(ITestOutputHelper output)
{
    private static readonly int Lots = Depth.Of(1, 20);

    // A single lot may be unlucky.
    private static readonly double Luck = Lots == 1 ? 0.1 : 0;
    private static readonly double[] _x = [5, 15, 25, 35, 45];

    // The squares of what the pieces show, the noise included, as in the costs of the estimate alone.
    [Theory]
    [InlineData("repeating", 1.15)]
    [InlineData("drift", 1.15)]
    [InlineData("walk", 1.15)]
    [InlineData("step", 1.3)]
    [InlineData("outliers", 1.15)]
    [InlineData("noise", 1.05)]
    public void The_squared_errors_are_near_those_of_a_filter_that_knows(string kind, double most)
    {
        var (cost, known) = (0.0, 0.0);
        foreach (var lot in SimulatedLot.Many(kind, Lots))
        {
            cost += lot.Cost(Corrections(lot));
            known += lot.Cost(kind == "noise" ? new double[SimulatedLot.Pieces] : lot.ExpectedByTruth());
        }

        output.WriteLine($"{kind}: {cost / known:0.000} times the squares of the filter that knows");
        Assert.InRange(cost / known, 0.9, most + Luck);
    }

    // What the program corrects at each piece, in micrometers.
    private static double[] Corrections(SimulatedLot lot)
    {
        var (corrected, now, program, previous) = (new double[SimulatedLot.Pieces], 0.0, Programs.ToolAbove, (PreviousMatch?)null);
        for (var k = 0; k < corrected.Length; k++)
        {
            corrected[k] = -now;

            // The machine scatters from piece to piece, and so all points alike.
            var outcome = Matcher.Match(Case(Line((lot.Shown[k] + now) / 1000), program).Input with { Previous = previous });
            Assert.True(outcome.Result is not null, string.Join('\n', outcome.Refusals));
            var match = outcome.Result;
            previous = new("report.json", "", match.Lot!.Pieces);
            program = Encoding.Latin1.GetString(match.Program.Span);
            var line = match.After.Motions[match.Maps[0].Passes[0].Feet[2].Motion];
            now = 1000 * (((line.Start.Y + line.End.Y) / 2) - 3);
        }

        return corrected;
    }

    private static string Line(double y) => string.Join("; ", _x.Select((x, i) => FormattableString.Invariant($"{i + 1} {x} {y:R}")));

    private static MatchCase Case(string counterpart, string program) => new(program)
    {
        Theoretical = Line(0),
        Part = Line(0),
        Counterpart = counterpart,
        Features = [MatchCase.Feature("line", "L1", "N50", """["1", "2", "3", "4", "5"]""")],
        Compensation = """{ "from": "counterpart", "limitMm": 1 }""",
        Gauge = FormattableString.Invariant($""" "uncertaintyMm": {SimulatedLot.U / 1000} """),
    };
}
