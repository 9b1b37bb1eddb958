using System.Globalization;
using System.Text;
using ErrorMatching.Mating;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// Random parts that deviate as a larger tool, a shift, or a shift and a turn would make them, or in no such way: the job gets the
/// smallest kind of correction that suffices. The referee cuts the program with the offset and probes the piece.
/// </summary>
public sealed class OffsetLoopTests
{
    private static readonly int Parts = Depth.Of(60, 200);

    // The micrometer that an offset may be off, the increment of an offset (0.05 um in each axis), and the words of the program.
    private const double Within = 0.001 + 0.0001 + 0.0015;

    [Fact]
    public void Every_part_gets_the_smallest_kind_that_suffices()
    {
        var (failures, kinds, done) = (new List<string>(), new Dictionary<(string, string), int>(), 0);
        for (var seed = 0; done < Parts; seed++)
        {
            var part = RandomParts.Generate(seed);
            part = OffsetWay.WithTool(part);
            var way = new OffsetWay(part, seed);
            var outcome = Matcher.Match(RandomMatch.Offsets(part, way.Deviation, OffsetWay.Job));
            if (outcome.Result is not { } result)
            {
                // Cutter compensation with this tool, or a step that no contour of the same blocks can follow.
                Assert.True(seed < 2 * Parts, $"{done} of {seed} parts: {string.Join(' ', outcome.Refusals.Select(r => r.Message))}");
                continue;
            }

            done++;
            var kind = result.Correction!.Kind?.ToString() ?? "none";
            kinds[(way.Name, kind)] = kinds.GetValueOrDefault((way.Name, kind)) + 1;
            if (Problem(part, way, result, kind) is { } problem)
            {
                failures.Add($"{seed}, {part.Flavor}, {way.Name}: {problem}");
            }
        }

        TestContext.Current.TestOutputHelper?.WriteLine(string.Join('\n', kinds.OrderBy(k => k.Key).Select(k => $"{k.Key}: {k.Value}")));
        Assert.True(failures.Count == 0, $"{failures.Count}:\n{string.Join('\n', failures.Take(20))}");
        foreach (var expected in new[] { ("growth", "ToolWear"), ("shift", "WorkOffset"), ("turn", "WorkOffset"), ("shape", "Blocks") })
        {
            Assert.True(kinds.GetValueOrDefault(expected) >= Parts / 20, $"{expected}: {kinds.GetValueOrDefault(expected)}");
        }
    }

    // What blocks would follow besides the offset is the gauge's noise. Where only blocks can follow, an offset must not be taken for it.
    [Theory]
    [InlineData(0)]
    [InlineData(0.001, Explicit = true)]
    [InlineData(0.003)]
    public void With_a_noisy_gauge_an_offset_is_nearer_to_the_part_than_blocks(double u)
    {
        var (byOffset, byBlocks, offsets, jobs) = (0.0, 0.0, 0, 0);
        var (others, byChoice, byBlocksAlone) = (0, 0.0, 0.0);
        for (var seed = 0; jobs < 40; seed++)
        {
            var part = OffsetWay.WithTool(RandomParts.Generate(seed));
            var way = new OffsetWay(part, seed);
            var random = new Random(seed);
            var noise = part.KeyPoints.ToDictionary(
                p => p.Label,
                _ => u * Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble()),
                StringComparer.Ordinal);
            double Measured(RandomKeyPoint p) => way.Deviation(p) + noise[p.Label];
            var (with, without) = (
                Matcher.Match(RandomMatch.Offsets(part, Measured, OffsetWay.Job, u)),
                Matcher.Match(RandomMatch.Offsets(part, Measured, null, u)));
            if (with.Result is not { Correction: { } correction } one || without.Result is not { } other)
            {
                continue;
            }

            var (left, leftByBlocks) = (Errors(part, way, one).Average(e => e * e), Errors(part, way, other).Average(e => e * e));
            Assert.True(
                !correction.IsOffset || Math.Sqrt(left) <= Math.Sqrt(leftByBlocks) + 0.002,
                $"{seed}, {way.Name}: {Math.Sqrt(left)} instead of {Math.Sqrt(leftByBlocks)}");
            if (way.Smallest(part) is not { } smallest)
            {
                (others, byChoice, byBlocksAlone) = (others + 1, byChoice + Math.Sqrt(left), byBlocksAlone + Math.Sqrt(leftByBlocks));
                continue;
            }

            jobs++;
            if (correction.Kind.ToString() == smallest)
            {
                offsets++;
                byOffset += left;
                byBlocks += leftByBlocks;
            }
        }

        TestContext.Current.TestOutputHelper?.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{offsets} of {jobs} by the smallest offset, which leaves {1000 * Math.Sqrt(byOffset / offsets):0.00} µm rms, and blocks "
                + $"{1000 * Math.Sqrt(byBlocks / offsets):0.00}; {others} others: {1000 * byChoice / others:0.00} and "
                + $"{1000 * byBlocksAlone / others:0.00}"));
        Assert.True(offsets >= 0.9 * jobs, $"{offsets} of {jobs}");
        Assert.True(byChoice <= byBlocksAlone + (0.001 * others), $"{byChoice} and {byBlocksAlone} of {others}");
        Assert.True(u < 0.003 || byOffset < 0.4 * byBlocks, $"{byOffset} and {byBlocks}");
    }

    private static string? Problem(RandomPart part, OffsetWay way, MatchResult result, string kind)
    {
        if (way.Smallest(part) is { } smallest && kind != smallest)
        {
            return $"{kind} instead of {smallest}: {string.Join("; ", result.Correction!.Refused.Select(r => r.Reason))}";
        }

        return part.KeyPoints.Zip(Errors(part, way, result)).Where(p => !(Math.Abs(p.Second) <= Within)).Select(p => string.Create(
            CultureInfo.InvariantCulture,
            $"{kind} leaves {p.Second:0.0000} mm at {p.First.Label} (deviation {way.Deviation(p.First):0.0000})")).FirstOrDefault();
    }

    private static IEnumerable<double> Errors(RandomPart part, OffsetWay way, MatchResult result)
    {
        var cut = new VirtualCut(RefereeInterpreter.Run(Encoding.ASCII.GetString(result.Program.Span)), part.ToolRadius);
        var nominal = new VirtualCut(RefereeInterpreter.Run(part.Program), part.ToolRadius);
        var (radius, work) = (result.Correction?.Radius?.TotalMm ?? 0, result.Correction?.Work?.Total ?? default);
        var (sin, cos) = Math.SinCos((double)work.RotationDegrees * Math.PI / 180);
        var shift = new Flat((double)work.XMm, (double)work.YMm);
        foreach (var point in part.KeyPoints)
        {
            // The machine cuts what the program has at p turned about the origin, and shifted: p is found from the place backward.
            var (place, normal) = (Back(point.Place - shift), Back(point.Normal));
            yield return cut.Probe(place, normal) + (double)radius - nominal.Probe(point.Place, point.Normal) - way.Deviation(point);
        }

        Flat Back(Flat v) => new((cos * v.U) + (sin * v.V), (cos * v.V) - (sin * v.U));
    }
}
