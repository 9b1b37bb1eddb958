using System.Globalization;
using System.Text;
using ErrorMatching.Measurement;

namespace ErrorMatching.Mating.Tests;

/// <summary>Two curves of two features that follow one another: one estimate, or two.</summary>
public sealed class JoinedCurvesTests
{
    private const double Radius = 5;

    // A deviation that rises steadily across the joint at X40, measured 3 mm before and behind it.
    [Fact]
    public void What_one_curve_says_reaches_across_a_smooth_joint()
    {
        var result = Match(x => 0.04 * Math.Sin((x - 10) / 15), bendDeg: 0);
        Assert.InRange(Math.Abs(DeviationAt(result, 1, 40) - (0.04 * Math.Sin(2))), 0, 0.001);
        Assert.InRange(Math.Abs(DeviationAt(result, 0, 40) - DeviationAt(result, 1, 40)), 0, 1e-5);
    }

    // A corner of 45 degrees is no joint: each curve is alone.
    [Theory]
    [InlineData(25, true)]
    [InlineData(45, false)]
    public void A_corner_ends_a_curve(double bendDeg, bool isJoined)
    {
        var result = Match(x => 0.04 * Math.Sin((x - 10) / 7), bendDeg);
        Assert.Equal(isJoined, Math.Abs(DeviationAt(result, 0, 40) - DeviationAt(result, 1, 40)) < 2e-4);
    }

    // Two flat curves with a step between them: the points say that they are two.
    [Fact]
    public void A_step_between_two_curves_stays_a_step()
    {
        var result = Match(x => x < 40 ? 0.05 : -0.05, bendDeg: 25);
        Assert.InRange(DeviationAt(result, 0, 39), 0.045, 0.055);
        Assert.InRange(DeviationAt(result, 1, 41), -0.055, -0.045);
    }

    private static double DeviationAt(MatchResult result, int feature, double x) =>
        result.Prediction.Features[feature].Deviation!(feature == 0 ? x : x - 40);

    // Cuts along X in blocks of 1 mm, 40 mm along X and 40 more at an angle to it; the material is on the right, below.
    private static MatchResult Match(Func<double, double> deviation, double bendDeg)
    {
        var bend = bendDeg * Math.PI / 180;
        var (program, blocks) = (new StringBuilder("G17 G90 G54\nT1 M6\nG0 Z5\nG0 X-5 Y5\nG1 Z-1 F100\nG1 X0 Y5 F500\n"), 0);
        for (var k = 1; k <= 80; k++)
        {
            var (x, y) = At(k, Radius);
            program.Append(CultureInfo.InvariantCulture, $"N{++blocks} G1 X{x:0.0000} Y{y:0.0000}\n");
        }

        program.Append("G0 Z5\nM30\n");
        double[] places = [3, 9, 15, 21, 27, 32, 37, 43, 48, 53, 59, 65, 71, 77];
        var job = """
            {"kind": "mating", "name": "two", "part": {"theoretical": "t.csv", "measured": "m.csv"},
             "alignment": {"kind": "none"}, "gauge": {"format": "points", "uncertaintyMm": 0.0005},
             "features": [
               {"name": "one", "kind": "curve", "points": ["P0", "P1", "P2", "P3", "P4", "P5", "P6"], "blocks": ["N1..N40"],
                "toleranceMm": [-0.01, 0.01]},
               {"name": "other", "kind": "curve", "points": ["P7", "P8", "P9", "P10", "P11", "P12", "P13"], "blocks": ["N41..N80"],
                "toleranceMm": [-0.01, 0.01]}],
             "counterpart": {"program": "c.nc", "dialect": "fanuc", "toolDiameterMm": 10,
              "frame": {"mirror": "none", "rotateDeg": 0, "translateMm": [0, 0]}},
             "compensation": {"from": "part", "gain": 1, "amount": "whole", "along": "normal", "limitMm": 1}}
            """;
        return Assert.IsType<MatchResult>(Matcher.Match(new(
            MatingJob.Parse(Encoding.UTF8.GetBytes(job), "job.json"),
            Points(_ => 0, "t.csv"),
            Points(deviation, "m.csv"),
            null,
            "c.nc",
            Encoding.ASCII.GetBytes(program.ToString()))).Result);

        // A place of the path, or of the boundary below it.
        (double X, double Y) At(double along, double off) => along <= 40
            ? (along, off)
            : (
                40 + ((along - 40) * Math.Cos(bend)) - ((off - Radius) * Math.Sin(bend)),
                Radius + ((along - 40) * Math.Sin(bend)) + ((off - Radius) * Math.Cos(bend)));

        MeasurementFile Points(Func<double, double> off, string file) => MeasurementReader.Read(
            Encoding.ASCII.GetBytes("point,x_mm,y_mm\n" + string.Concat(places.Select((along, i) =>
            {
                var (x, y) = At(along, off(along));
                return string.Create(CultureInfo.InvariantCulture, $"P{i},{x:0.000000},{y:0.000000}\n");
            }))),
            file,
            MeasurementFormat.Points);
    }
}
