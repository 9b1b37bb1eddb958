using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

public sealed class SurfaceAlignmentTests
{
    [Fact]
    public void Foot_of_a_point_on_a_normal_is_where_the_normal_starts()
    {
        foreach (var (u, v) in new[] { (0.1, 0.2), (0.5, 0.5), (0.9, 0.7), (0, 1) })
        {
            var (surface, at) = (PaperDesign.Three, PaperDesign.Three.Spline.At(u, v));
            var foot = NormalFoot.Find(surface.Spline, at.Position + (surface.NormalOf(at) * 0.35), u + 0.03, v - 0.03);

            Assert.True((foot!.Value.Position - at.Position).Length < 1e-9);
        }
    }

    [Fact]
    public void Error_is_the_distance_along_the_normal_less_the_stock()
    {
        var plan = PlanOf(PaperDesign.Three).ToArray();
        var errors = SurfaceErrors.Find(
            PaperDesign.Three, plan.Select((p, i) => (p, p.Position + (p.Normal * (0.2 + (i * 0.001))))), 0.2, "m.csv");

        Assert.All(errors.Select((e, i) => (e, i)), p => Assert.Equal(p.i * 0.001, p.e.ErrorMm, 9));
    }

    [Fact]
    public void A_point_that_no_normal_leads_to_is_refused_by_its_number()
    {
        var point = PlanOf(PaperDesign.Two).First();
        var e = Assert.Throws<InputException>(() => SurfaceErrors.Find(PaperDesign.Two, [(point, new(1e300, 0, 0))], 0, "m.csv"));

        Assert.Equal(("no-foot", "m.csv"), (e.Code, e.File));
        Assert.Contains($"point {point.Number} ", e.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_piece_that_was_clamped_askew_is_laid_back()
    {
        SurfaceAlignment askew = new(new(0.03, -0.02, 0.05), new(0.02, -0.01, 0.03), new(37, 31, 24));
        var surface = PaperDesign.Three;
        var points = PlanOf(surface).Select(p => (p, askew.Apply(p.Position))).ToArray();
        var back = SurfaceAlignment.BestFit(surface, points, 0, "m.csv");

        Assert.True(SurfaceErrors.Find(surface, points, 0, "m.csv").Max(e => Math.Abs(e.ErrorMm)) > 0.02);
        Assert.All(
            SurfaceErrors.Find(surface, points.Select(p => (p.p, back.Apply(p.Item2))), 0, "m.csv"), e => Assert.Equal(0, e.ErrorMm, 8));
    }

    [Fact]
    public void A_motion_that_the_surface_does_not_resist_is_not_made()
    {
        var surface = PaperDesign.One;
        var points = PlanOf(surface).Select(p => (p, p.Position + new Vector3(0, 0.5, 0.04))).ToArray();
        var back = SurfaceAlignment.BestFit(surface, points, 0, "m.csv");

        Assert.Equal(0, back.TranslateMm.Y, 6);
        Assert.All(
            SurfaceErrors.Find(surface, points.Select(p => (p.p, back.Apply(p.Item2))), 0, "m.csv"), e => Assert.Equal(0, e.ErrorMm, 8));
    }

    private static IEnumerable<PlanPoint> PlanOf(PartSurface surface)
    {
        for (var j = 0; j < 7; j++)
        {
            for (var i = 0; i < 9; i++)
            {
                var (u, v) = (i / 8.0, j / 6.0);
                yield return new((j * 9) + i + 1, i, j, u, v, surface.Spline.PointAt(u, v), surface.NormalAt(u, v), PlanReason.Slope);
            }
        }
    }
}
