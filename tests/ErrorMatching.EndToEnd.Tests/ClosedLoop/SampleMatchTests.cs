using System.Globalization;
using System.Text;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>The samples through the pure core, judged by the referee:
/// the counterpart follows the part as far as the report predicts.</summary>
public sealed class SampleMatchTests
{
    private const double ToolRadius = 3;

    [Theory]
    [InlineData("curve-mating", 0.003)]
    [InlineData("complex-mating", 0.01)]
    [InlineData("circle-mating", 0.02)]
    [InlineData("slot-mating", 0.02)]
    public void Cut_from_the_new_program_the_counterpart_leaves_the_predicted_error(string sample, double most)
    {
        var result = Match(sample);
        var report = MatchReporter.Report(result, "counterpart.nc", 0);
        var cut = new VirtualCut(RefereeInterpreter.Run(Encoding.ASCII.GetString(result.Program.Span)), ToolRadius);

        Assert.True(report.Proof.Holds);
        foreach (var point in report.KeyPoints)
        {
            // Of the finished piece: what the program before does differently from the theoretical points is part of it.
            var left = cut.Clearance(new(point.Actual.X, point.Actual.Y));
            Assert.Equal(left, point.PredictedMm, 0.0005);
            Assert.InRange(Math.Abs(left), 0, most);
        }

        Assert.Empty(report.Outside.Points);
    }

    /// <summary>
    /// By hand: of all circles through three of the eight points that hold no other one, with their center among the three, that through
    /// points 1, 4 and 7 is the largest.
    /// </summary>
    [Fact]
    public void The_boss_gets_the_largest_circle_inside_the_bore()
    {
        var result = Match("circle-mating");
        var quantities = MatchReporter.Report(result, "counterpart.nc", 0).Features[0].Quantities.ToDictionary(
            q => q.Quantity.Name, q => q.Quantity.Actual, StringComparer.Ordinal);
        Assert.Equal(
            (0.02102, -0.03420, 40.04462),
            (Math.Round(quantities["centerXMm"], 5), Math.Round(quantities["centerYMm"], 5), Math.Round(quantities["diameterMm"], 5)));
        var arcs = RefereeInterpreter.Run(Encoding.ASCII.GetString(result.Program.Span)).Where(m => m.Block is "N120" or "N130").ToList();
        Assert.Equal(2, arcs.Count);
        Assert.All(arcs, arc => Assert.InRange((arc.Center - new Flat(0.02102, -0.03420)).Length, 0, 0.0008));
        Assert.All(arcs, arc => Assert.InRange(arc.Radius, 23.02231 - 0.0008, 23.02231 + 0.0008));
    }

    /// <summary>The slot was made with these numbers; its points are rounded to a tenth of a micrometer.</summary>
    [Fact]
    public void The_key_gets_the_width_length_place_and_direction_of_the_slot()
    {
        var result = Match("slot-mating");
        var quantities = MatchReporter.Report(result, "counterpart.nc", 0).Features[0].Quantities.ToDictionary(
            q => q.Quantity.Name, q => q.Quantity, StringComparer.Ordinal);
        Assert.Equal(20.046, quantities["widthMm"].Actual, 2e-4);
        Assert.Equal(60.074, quantities["lengthMm"].Actual, 2e-4);
        Assert.Equal(0.012, quantities["centerXMm"].Actual, 2e-4);
        Assert.Equal(-0.021, quantities["centerYMm"].Actual, 2e-4);
        Assert.Equal(0.03, -quantities["directionDeg"].Deviation, 5e-4);
        var arcs = RefereeInterpreter.Run(Encoding.ASCII.GetString(result.Program.Span)).Where(m => m.Block is "N130" or "N150").ToList();
        Assert.All(arcs, arc => Assert.InRange(arc.Radius, 13.0222, 13.0238));
        Assert.Equal(40.028, (arcs[0].Center - arcs[1].Center).Length, 0.0015);
    }

    /// <summary>A gauge delivers parts that are all a little different;
    /// none of them may be refused because of the rounding of a program's words.</summary>
    [Theory]
    [InlineData("complex-mating", 0.003, Explicit = true)]
    [InlineData("complex-mating", 0.01, Explicit = true)]
    [InlineData("complex-mating", 0.04)]
    [InlineData("curve-mating", 0.01)]
    public void Parts_near_the_sample_are_all_matched(string sample, double spread)
    {
        var refused = new List<string>();
        for (var seed = 0; seed < 100; seed++)
        {
            var random = new Random(seed);
            var outcome = Outcome(sample, measurement => Shifted(measurement, () => spread * ((2 * random.NextDouble()) - 1)));
            refused.AddRange(outcome.Refusals.Select(r => FormattableString.Invariant($"{seed}: {r.Message}")));
        }

        Assert.True(refused.Count == 0, string.Join('\n', refused));
    }

    private static byte[] Shifted(byte[] csv, Func<double> shift)
    {
        var lines = Encoding.ASCII.GetString(csv).TrimEnd().Split('\n');
        var rows = lines.Skip(1).Select(l => l.TrimEnd('\r').Split(','));
        var shifted = rows.Select(r => string.Join(
            ',',
            [
                r[0],
                .. r[1..].Select(
                    v => (double.Parse(v, CultureInfo.InvariantCulture) + shift()).ToString("F4", CultureInfo.InvariantCulture))]));
        return Encoding.ASCII.GetBytes(string.Join('\n', [lines[0], .. shifted]));
    }

    private static MatchResult Match(string sample)
    {
        var outcome = Outcome(sample, m => m);
        Assert.True(outcome.Result is not null, string.Join('\n', outcome.Refusals.Select(r => r.Message)));
        return outcome.Result;
    }

    private static Outcome<MatchResult> Outcome(string sample, Func<byte[], byte[]> part)
    {
        var job = MatingJob.Read(Repository.PathTo("samples", sample, "job.json"));
        var program = job.PathOf(job.Counterpart.Program);
        return Matcher.Match(new(
            job,
            MeasurementReader.Read(job.PathOf(job.Part.Theoretical), MeasurementFormat.Points),
            MeasurementReader.Read(part(File.ReadAllBytes(job.PathOf(job.Part.Measured))), "part.csv", job.Gauge.Format),
            null,
            program,
            File.ReadAllBytes(program)));
    }
}
