using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

public sealed class SurfaceSideTests
{
    [Theory]
    [InlineData(true, true)]
    [InlineData(true, false)]
    [InlineData(false, true)]
    [InlineData(false, false)]
    public void The_outside_is_where_the_job_says_whichever_way_the_parameters_run(bool swapped, bool up)
    {
        var spline = swapped ? PaperDesign.Three.Spline.Swap() : PaperDesign.Three.Spline;
        var read = SurfaceReader.Read(IgesWriter.Write(PaperDesign.Three with { Spline = spline }), "a.igs", null, up);
        Assert.Equal(up ? 1 : -1, Math.Sign(read.NormalAt(0.3, 0.6).Z));
    }

    [Fact]
    public void A_surface_that_turns_over_is_refused_with_both_places()
    {
        // A half tube lying on its side: up on top, down below.
        Point3[] poles = [
            new(0, 0, 0), new(0, 50, 0), new(40, 0, 0), new(40, 50, 0), new(40, 0, 40), new(40, 50, 40), new(0, 0, 40), new(0, 50, 40)];
        var surface = new PartSurface(
            "TUBE", new(KnotVector.Clamped(3, [0, 1]), KnotVector.Clamped(1, [0, 1]), poles), SurfaceRegion.Whole, 1);
        var error = Assert.Throws<InputException>(() => SurfaceReader.Read(IgesWriter.Write(surface), "a.igs", null, outsideIsUp: true));
        Assert.Equal("folded-surface", error.Code);
        Assert.Matches(@"up at \(.*, .*, .*\) and down at \(.*\)", error.Problem);
    }

    [Fact]
    public void A_surface_whose_turned_part_is_cut_away_is_read()
    {
        Point3[] poles = [
            new(0, 0, 0), new(0, 50, 0), new(40, 0, 0), new(40, 50, 0), new(40, 0, 40), new(40, 50, 40), new(0, 0, 40), new(0, 50, 40)];
        SurfaceRegion lower = new([[new(0, 0), new(0.45, 0), new(0.45, 1), new(0, 1)]]);
        var surface = new PartSurface("TUBE", new(KnotVector.Clamped(3, [0, 1]), KnotVector.Clamped(1, [0, 1]), poles), lower, 1);
        Assert.Equal(1, SurfaceReader.Read(IgesWriter.Write(surface), "a.igs", null, outsideIsUp: true).Outside);
    }

    [Fact]
    public void An_upright_surface_is_refused()
    {
        Point3[] poles = [new(0, 0, 0), new(0, 0, 10), new(40, 0, 0), new(40, 0, 10)];
        var knots = KnotVector.Clamped(1, [0, 1]);
        var surface = new PartSurface("WALL", new(knots, knots, poles), SurfaceRegion.Whole, 1);
        Assert.Equal(
            "upright-surface",
            Assert.Throws<InputException>(() => SurfaceReader.Read(StepWriter.Write(surface), "a.stp", null, outsideIsUp: true)).Code);
    }

    [Fact]
    public void A_surface_larger_than_any_machine_is_refused()
    {
        Point3[] poles = [new(0, 0, 0), new(0, 2e6, 0), new(40, 0, 0), new(40, 2e6, 0)];
        var knots = KnotVector.Clamped(1, [0, 1]);
        var surface = new PartSurface("MOON", new(knots, knots, poles), SurfaceRegion.Whole, 1);
        Assert.Equal(
            "implausible",
            Assert.Throws<InputException>(() => SurfaceReader.Read(StepWriter.Write(surface), "a.stp", null, outsideIsUp: true)).Code);
    }
}
