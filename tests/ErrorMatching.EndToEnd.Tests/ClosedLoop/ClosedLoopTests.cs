using System.Globalization;
using System.Text;
using ErrorMatching.Mating;
using ErrorMatching.Nc;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// The sign of a correction is what hurts people. Here the rewritten program is cut by a referee that shares nothing with the rewriter,
/// the piece is probed at its key points along their normals, and what is left of the mating error must be the rounding of the program.
/// </summary>
public sealed class ClosedLoopTests
{
    private const double Rounding = 0.0015;

    private static readonly int Parts = Depth.Of(120, 400);

    /// <summary>
    /// Parts that may be refused, with the code. Of most, two features run into each other tangentially and deviate by different
    /// amounts, so the part has a step that no contour of the same blocks can follow. Of part 215 in feedback, the straight block behind
    /// a wave cuts its last chords off: 1.4 um are left of the last one before an inside corner of 49 degrees, where a tool with a radius
    /// of 10 um needs 4.6 um. rs274 refuses the program that would have been written, too.
    /// </summary>
    private static readonly Dictionary<int, string> Refused = new()
    {
        [47] = NcRefusalCodes.NoIntersection,
        [108] = NcRefusalCodes.NoIntersection,
        [177] = NcRefusalCodes.NoIntersection,
        [215] = NcRefusalCodes.CompensationGouge,
    };

    [Fact]
    public void Feed_forward_makes_the_counterpart_follow_the_part() =>
        NothingLeft(RandomMatch.FeedForward, point => point.Deviation);

    // A machine that came out off by -0.4 of the deviation will do so again: the program must go 1.4 of it.
    [Fact]
    public void Feedback_takes_the_error_of_the_first_counterpart_out_of_the_next() =>
        NothingLeft(part => RandomMatch.Feedback(part, -0.4), point => 1.4 * point.Deviation);

    // What no feature can represent is left over, but no more and no less than the report says.
    [Fact]
    public void Rough_parts_leave_the_error_that_was_predicted()
    {
        var (matched, failures) = (0, new List<string>());
        for (var seed = 0; seed < Parts; seed++)
        {
            var part = RandomParts.Generate(seed);
            if (Matcher.Match(RandomMatch.Rough(part, 0.06)).Result is not { } result)
            {
                continue;
            }

            matched++;
            var predicted = MatchReporter.Report(result, "counterpart.nc", 0).KeyPoints.ToDictionary(p => p.Point, StringComparer.Ordinal);
            var cut = new VirtualCut(RefereeInterpreter.Run(Encoding.ASCII.GetString(result.Program.Span)), part.ToolRadius);
            failures.AddRange(
                from point in part.KeyPoints
                let report = predicted[point.Label]
                let actual = part.Frame.ToProgram(new(report.Actual.X, report.Actual.Y))
                let left = part.Flavor.Compensated ? cut.Probe(point.Place, point.Normal) - report.NormalMm : cut.Clearance(actual)
                where !(Math.Abs(left - report.PredictedMm) <= Rounding)
                select string.Create(
                    CultureInfo.InvariantCulture,
                    $"part {seed}, {part.Flavor}, point {point.Label}: {left:0.0000} mm left, predicted {report.PredictedMm:0.0000}"));
        }

        Assert.InRange(matched, Parts * 3 / 4, Parts);
        Assert.True(failures.Count == 0, string.Join('\n', failures));
    }

    private static void NothingLeft(Func<RandomPart, MatchInput> input, Func<RandomKeyPoint, double> wanted)
    {
        var failures = Failures(input, wanted);
        Assert.True(failures.Count == 0, string.Join('\n', failures));
    }

    private static List<string> Failures(Func<RandomPart, MatchInput> input, Func<RandomKeyPoint, double> wanted)
    {
        var failures = new List<string>();
        for (var seed = 0; seed < Parts; seed++)
        {
            var part = RandomParts.Generate(seed);
            var outcome = Matcher.Match(input(part));
            if (outcome.Result is not { } result)
            {
                var refusal = Assert.Single(outcome.Refusals);
                if (Refused.GetValueOrDefault(seed) != refusal.Code)
                {
                    failures.Add($"part {seed}, {part.Flavor}: {refusal.Message}");
                }

                continue;
            }

            var cut = new VirtualCut(RefereeInterpreter.Run(Encoding.ASCII.GetString(result.Program.Span)), part.ToolRadius);
            failures.AddRange(
                from feature in part.Features
                from point in feature.KeyPoints
                let error = cut.Probe(point.Place, point.Normal) - wanted(point)
                where !(Math.Abs(error) <= Rounding)
                select string.Create(
                    CultureInfo.InvariantCulture,
                    $"part {seed}, {part.Flavor}, {feature.Kind} {feature.Shape}, point {point.Label} (deviation "
                        + $"{point.Deviation:0.0000}): {error:0.0000} mm left"));
        }

        return failures;
    }
}
