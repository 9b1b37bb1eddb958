using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Geometry.Tests;

public sealed class SplineSurfaceChangesTests
{
    private const double Rounding = 1e-10;
    private const int Few = 200;

    private static readonly Gen<(SplineSurface Surface, double A, double B)> Cases =
        DrawSpline.Surface.Zip(Gen.Choose(-999, 999).Two()).Select(p => (p.Item1, p.Item2.Item1 / 1000.0, p.Item2.Item2 / 1000.0));

    [Fact]
    public void Inserted_knots_do_not_move_the_surface() => Draw.Law(
        Cases,
        c => Apart(
            c.Surface,
            c.Surface.InsertKnotU(DrawSpline.Inside(c.Surface.KnotsU, c.A)).InsertKnotV(DrawSpline.Inside(c.Surface.KnotsV, c.B)))
            < Rounding,
        Few);

    [Fact]
    public void Higher_degrees_do_not_move_the_surface() => Draw.Law(
        Cases,
        c =>
        {
            var raised = c.Surface.ElevateTo(c.Surface.KnotsU.Degree + 1, c.Surface.KnotsV.Degree + 2);
            return (raised.KnotsU.Degree, raised.KnotsV.Degree) == (c.Surface.KnotsU.Degree + 1, c.Surface.KnotsV.Degree + 2)
                && Apart(c.Surface, raised) < Rounding;
        },
        Few);

    [Fact]
    public void Parts_lie_on_the_whole() => Draw.Law(
        Cases,
        c =>
        {
            var (u, v) = (DrawSpline.Inside(c.Surface.KnotsU, c.A), DrawSpline.Inside(c.Surface.KnotsV, c.B));
            var (before, after) = c.Surface.SplitU(u);
            var (left, right) = after.SplitV(v);
            return new[] { before, after, left, right }.All(s => Apart(s, c.Surface) < Rounding)
                && (right.KnotsU.Start, right.KnotsV.Start) == (u, v);
        },
        Few);

    [Fact]
    public void Pieces_are_Bezier_surfaces_on_the_whole() => Draw.Law(
        Cases,
        c =>
        {
            var pieces = c.Surface.Pieces();
            return pieces.Count == (c.Surface.KnotsU.Breaks.Count - 1) * (c.Surface.KnotsV.Breaks.Count - 1)
                && pieces.All(p => p.Poles.Length == (p.KnotsU.Degree + 1) * (p.KnotsV.Degree + 1) && Apart(p, c.Surface) < Rounding);
        },
        Few);

    [Fact]
    public void Curves_at_a_parameter_lie_on_the_surface() => Draw.Law(
        Cases,
        c =>
        {
            var (u, v) = (DrawSpline.Inside(c.Surface.KnotsU, c.A), DrawSpline.Inside(c.Surface.KnotsV, c.B));
            var at = c.Surface.PointAt(u, v);
            return (c.Surface.CurveAtU(u).PointAt(v) - at).Length < Rounding && (c.Surface.CurveAtV(v).PointAt(u) - at).Length < Rounding;
        },
        Few);

    [Fact]
    public void Exchange_of_u_and_v_turns_the_normal_over() => Draw.Law(
        Cases,
        c =>
        {
            var (u, v) = (DrawSpline.Inside(c.Surface.KnotsU, c.A), DrawSpline.Inside(c.Surface.KnotsV, c.B));
            var (here, there) = (c.Surface.At(u, v), c.Surface.Swap().At(v, u));
            return (here.Position - there.Position).Length < Rounding && (here.Normal + there.Normal).Length < 1e-6;
        },
        Few);

    [Fact]
    public void Backwards_along_a_direction_is_the_same_surface_from_its_end() => Draw.Law(
        Cases,
        c =>
        {
            var (u, v) = (DrawSpline.Inside(c.Surface.KnotsU, c.A), DrawSpline.Inside(c.Surface.KnotsV, c.B));
            var at = c.Surface.PointAt(u, v);
            return (c.Surface.ReverseU().PointAt(DrawSpline.Inside(c.Surface.KnotsU, -c.A), v) - at).Length < Rounding
                && (c.Surface.ReverseV().PointAt(u, DrawSpline.Inside(c.Surface.KnotsV, -c.B)) - at).Length < Rounding;
        },
        Few);

    [Fact]
    public void Compatible_surfaces_add_pole_by_pole() => Draw.Law(
        DrawSpline.Surface.Where(s => !s.IsRational).Two(),
        c =>
        {
            var (a, b) = (
                c.Item1, c.Item2.Reparametrize(c.Item1.KnotsU.Start, c.Item1.KnotsU.End, c.Item1.KnotsV.Start, c.Item1.KnotsV.End));
            var both = SplineSurface.Compatible([a, b]);
            var poles = new Point3[both[0].Poles.Length];
            for (var i = 0; i < poles.Length; i++)
            {
                poles[i] = both[0].Poles[i] + (both[1].Poles[i] - default(Point3));
            }

            var sum = new SplineSurface(both[0].KnotsU, both[0].KnotsV, poles);
            var (u, v) = (DrawSpline.Inside(a.KnotsU, 0.37), DrawSpline.Inside(a.KnotsV, -0.21));
            return (
                sum.PointAt(u, v) - default(Point3) - (a.PointAt(u, v) - default(Point3)) - (b.PointAt(u, v) - default(Point3)))
                .Length < 1e-7;
        },
        Few);

    [Fact]
    public void The_box_of_the_poles_holds_the_surface() => Draw.Law(
        Cases,
        c => c.Surface.Box().DistanceTo(c.Surface.PointAt(
            DrawSpline.Inside(c.Surface.KnotsU, c.A), DrawSpline.Inside(c.Surface.KnotsV, c.B))) < Rounding,
        Few);

    private static double Apart(SplineSurface a, SplineSurface b)
    {
        var worst = 0.0;
        for (var i = 0; i < 10; i++)
        {
            for (var j = 0; j < 10; j++)
            {
                var (u, v) = (DrawSpline.Inside(a.KnotsU, ((i + 0.31) / 5.1) - 1), DrawSpline.Inside(a.KnotsV, ((j + 0.31) / 5.1) - 1));
                worst = Math.Max(worst, (a.PointAt(u, v) - b.PointAt(u, v)).Length);
            }
        }

        return worst;
    }
}
