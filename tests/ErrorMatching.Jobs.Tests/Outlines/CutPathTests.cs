using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Jobs.Tests;

/// <summary>The nearest place of what a program cuts, against a look at every motion.</summary>
public sealed class CutPathTests
{
    // Small arcs bulge out of the squares in which they are kept; large ones out of the box of their ends.
    [Fact]
    public void The_nearest_place_is_that_of_all_motions()
    {
        var random = new Random(3);
        var text = new StringBuilder("G21 G17 G90 G54\nG0 X0 Y0\nG1 Z-1 F100\n");
        for (var k = 0; k < 60; k++)
        {
            var (x, y, r) = (Between(0, 60), Between(0, 40), random.Next(2) == 0 ? 0.3 : Between(1, 12));
            text.Append(FormattableString.Invariant($"G1 X{x:0.000} Y{y:0.000}\n"));
            text.Append(FormattableString.Invariant($"G{random.Next(2, 4)} Y{y + (2 * r):0.000} I0 J{r:0.000}\n"));
        }

        var path = NcInterpreter.Run(NcProgram.FromText(text.ToString()), NcDialects.Named("fanuc"));
        var (cuts, found) = (new CutPath(path), 0);
        for (var k = 0; k < 4000; k++)
        {
            var (at, within) = (new Point2(Between(-40, 100), Between(-40, 80)), Between(0.1, 30));
            var nearest = Enumerable.Range(0, path.Motions.Length).Where(m => path.Motions[m] is { IsCut: true, MovesInPlane: true })
                .Min(m => path.Motions[m].IsArc ? path.Motions[m].Arc.DistanceTo(at) : path.Motions[m].Segment.DistanceTo(at));
            var foot = cuts.FootOf(at, within);
            Assert.Equal(nearest <= within, foot is not null);
            Assert.Equal(nearest, foot?.DistanceMm ?? nearest, 1e-9);
            found += foot is null ? 0 : 1;
        }

        Assert.InRange(found, 1000, 3900);

        double Between(double from, double to) => from + ((to - from) * random.NextDouble());
    }

    [Fact]
    public void A_program_that_cuts_nothing_has_no_nearest_place() => Assert.Null(
        new CutPath(NcInterpreter.Run(NcProgram.FromText("G90 G54\nG0 X1 Y1\n"), NcDialects.Named("fanuc"))).FootOf(new(0, 0), 10));
}
