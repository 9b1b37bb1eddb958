using System.Text;
using ErrorMatching.Mating;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>Bores and bosses as the referee cuts them from the rewritten program: what is left of the mating error is the rounding of the program.</summary>
public sealed class CircleLoopTests
{
    /// <summary>Center and radius are each rounded by up to 0.7 um, and the frame's own coordinates a little.</summary>
    private const double Rounding = 0.0018;

    private const int Parts = 300;

    [Fact]
    public void Feed_forward_makes_a_circle_follow_the_part() => NothingLeft(RandomMatch.FeedForward, 1);

    [Fact]
    public void Feedback_takes_the_error_of_the_first_circle_out_of_the_next() => NothingLeft(part => RandomMatch.Feedback(part, -0.4), 1.4);

    private static void NothingLeft(Func<RandomPart, MatchInput> input, double share)
    {
        var failures = new List<string>();
        for (var seed = 0; seed < Parts; seed++)
        {
            var part = RandomCircles.Generate(seed);
            var outcome = Matcher.Match(input(part));
            if (outcome.Result is not { } result)
            {
                failures.Add($"circle {seed}, {part.Flavor}: {string.Join(' ', outcome.Refusals.Select(r => r.Message))}");
                continue;
            }

            // What the nominal program misses its circle by, its own words being rounded, is nobody's error.
            var (cut, nominal) = (Cut(Encoding.ASCII.GetString(result.Program.Span), part), Cut(part.Program, part));
            failures.AddRange(
                from point in part.KeyPoints
                let error = cut.Probe(point.Place, point.Normal) - nominal.Probe(point.Place, point.Normal) - (share * point.Deviation)
                where !(Math.Abs(error) <= Rounding)
                select FormattableString.Invariant($"circle {seed}, {part.Flavor}, {part.Features[0].Shape}, point {point.Label} (deviation {point.Deviation:0.0000}): {error:0.0000} mm left"));
        }

        Assert.True(failures.Count == 0, $"{failures.Count}:\n{string.Join('\n', failures.Take(40))}");
    }

    private static VirtualCut Cut(string program, RandomPart part) => new(RefereeInterpreter.Run(program), part.ToolRadius);
}
