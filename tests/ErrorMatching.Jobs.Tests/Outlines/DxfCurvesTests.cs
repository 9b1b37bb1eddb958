using ErrorMatching.Geometry;

namespace ErrorMatching.Jobs.Tests;

/// <summary>Curves of DXF entities against closed forms.</summary>
public sealed class DxfCurvesTests
{
    private const double Accuracy = 1e-9;

    [Fact]
    public void Lines_arcs_and_circles_are_as_written()
    {
        var drawing = DxfSample.Of(
        [
            .. DxfSample.Entity("LINE", "A", 10, 1, 20, 2, 11, 3, 21, 4),
            .. DxfSample.Entity("ARC", "A", 10, 10, 20, 0, 40, 5, 50, 270, 51, 90),
            .. DxfSample.Entity("CIRCLE", "B", 10, -1, 20, -2, 40, 7),
        ]).Read();
        Assert.Equal(new DrawnLine("A", "LINE at line 5", new(1, 2), new(3, 4)), drawing.Curves[0]);
        var arc = Assert.IsType<DrawnArc>(drawing.Curves[1]);
        Near(new(10, -5), arc.From);
        Near(new(10, 5), arc.To);
        Near(new(15, 0), arc.At(0.5));
        var circle = Assert.IsType<DrawnArc>(drawing.Curves[2]);
        Assert.True(circle.IsCircle);
        Assert.Equal((new Point2(-1, -2), 7.0), (circle.Center, circle.Radius));
        Assert.Equal(["A", "B"], drawing.Layers);
        Assert.Empty(drawing.Notes);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(-1)]
    [InlineData(0.3)]
    [InlineData(-2.5)]
    [InlineData(1e-4)]
    public void A_bulge_is_the_tangent_of_a_quarter_of_the_sweep(double bulge)
    {
        // The height of the arc over its chord is bulge times half the chord, to the right of it if positive.
        var (from, to) = (new Point2(1, 2), new Point2(5, 5));
        var drawing = DxfSample.Of(DxfSample.Entity("LWPOLYLINE", "0", 90, 2, 70, 0, 10, 1, 20, 2, 42, bulge, 10, 5, 20, 5)).Read();
        var arc = Assert.IsType<DrawnArc>(Assert.Single(drawing.Curves));
        Near(from, arc.From);
        Near(to, arc.To);
        Near(new Point2(3, 3.5) - (new Vector2(-0.6, 0.8) * (bulge * 2.5)), arc.At(0.5));
        Assert.Equal(4 * Elementary.Atan(bulge), arc.Sweep, Accuracy);
    }

    [Fact]
    public void A_closed_polyline_returns_with_the_last_bulge()
    {
        // A slot: two straights, two half circles.
        double[] vertices = [10, 0, 20, 0, 10, 10, 20, 0, 42, 1, 10, 10, 20, 4, 10, 0, 20, 4, 42, 1];
        var light = DxfSample.Of(DxfSample.Entity("LWPOLYLINE", "0", [90, 4, 70, 1, .. vertices])).Read();
        var old = DxfSample.Of(
        [
            .. DxfSample.Entity("POLYLINE", "0", 66, 1, 70, 1),
            .. DxfSample.Entity("VERTEX", "0", 10, 0, 20, 0),
            .. DxfSample.Entity("VERTEX", "0", 10, 10, 20, 0, 42, 1),
            .. DxfSample.Entity("VERTEX", "0", 10, 10, 20, 4),
            .. DxfSample.Entity("VERTEX", "0", 10, 0, 20, 4, 42, 1),
            .. DxfSample.Entity("SEQEND", "0"),
        ]).Read();
        Assert.Equal(4, light.Curves.Count);
        Near(new(12, 2), Assert.IsType<DrawnArc>(light.Curves[1]).At(0.5));
        Near(new(-2, 2), Assert.IsType<DrawnArc>(light.Curves[3]).At(0.5));
        for (var i = 0; i < 4; i++)
        {
            Near(light.Curves[i].To, light.Curves[(i + 1) % 4].From);
            Near(light.Curves[i].From, old.Curves[i].From);
            Near(light.Curves[i].To, old.Curves[i].To);
        }
    }

    [Theory]
    [InlineData(0, Math.Tau)]
    [InlineData(0.5, 4)]
    [InlineData(5, 1)]
    public void An_ellipse_is_within_the_chord_error_of_its_closed_form(double start, double end)
    {
        var drawing = DxfSample.Of(
            DxfSample.Entity("ELLIPSE", "0", 10, 3, 20, 4, 11, 24, 21, 18, 40, 0.4, 41, start, 42, end)).Read();
        var course = Assert.IsType<DrawnCourse>(Assert.Single(drawing.Curves));
        var sweep = end > start ? end - start : end - start + Math.Tau;
        AlongWithin(course, share =>
        {
            var (sin, cos) = Elementary.SinCos(start + (share * sweep));
            return new(3 + (24 * cos) - (0.4 * 18 * sin), 4 + (18 * cos) + (0.4 * 24 * sin));
        });
        Assert.Equal(sweep >= Math.Tau - 1e-9, course.From == course.To);
    }

    [Fact]
    public void An_ellipse_with_equal_axes_is_a_circle()
    {
        var drawing = DxfSample.Of(DxfSample.Entity("ELLIPSE", "0", 10, 3, 20, 4, 11, 0, 21, 5, 40, 1, 41, 0, 42, Math.PI)).Read();
        var arc = Assert.IsType<DrawnArc>(Assert.Single(drawing.Curves));
        Assert.Equal(5, arc.Radius, Accuracy);
        Near(new(3, 9), arc.From);
        Near(new(-2, 4), arc.At(0.5));
    }

    [Fact]
    public void A_rational_spline_of_degree_2_is_an_exact_circle()
    {
        var half = Math.Sqrt(0.5);
        double[] knots = [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4];
        (double X, double Y)[] poles = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)];
        List<double> groups = [70, 8, 71, 2, 72, 12, 73, 9];
        groups.AddRange(knots.SelectMany(k => new[] { 40, k }));
        groups.AddRange(poles.SelectMany((_, i) => new[] { 41, i % 2 == 0 ? 1 : half }));
        groups.AddRange(poles.SelectMany(p => new[] { 10, 40 * p.X, 20, 40 * p.Y }));
        var course = Assert.IsType<DrawnCourse>(Assert.Single(DxfSample.Of(DxfSample.Entity("SPLINE", "0", [.. groups])).Read().Curves));
        Assert.InRange(course.Points.Count, 200, 2000);
        Assert.All(course.Points, p => Assert.Equal(40, p.DistanceTo(Point2.Origin), Accuracy));
        for (var i = 1; i < course.Points.Count; i++)
        {
            var middle = course.Points[i - 1].Lerp(course.Points[i], 0.5);
            Assert.InRange(40 - middle.DistanceTo(Point2.Origin), 0, DrawnCourse.ChordMm);
        }

        Near(course.From, course.To);
    }

    [Fact]
    public void A_cubic_spline_is_within_the_chord_error_of_its_B_spline()
    {
        // Not clamped, as closed splines are written, and with knots at different distances.
        double[] knots = [-2, -1, -0.5, 0, 1, 1.5, 3, 4, 4.5, 6];
        (double X, double Y)[] poles = [(0, 0), (10, 30), (40, -20), (50, 60), (-20, 40), (5, 5)];
        List<double> groups = [70, 8, 71, 3];
        groups.AddRange(knots.SelectMany(k => new[] { 40, k }));
        groups.AddRange(poles.SelectMany(p => new[] { 10, p.X, 20, p.Y, 30, 7.0 }));
        var drawing = DxfSample.Of(DxfSample.Entity("SPLINE", "0", [.. groups])).Read();
        var curve = new SplineCurve(new KnotVector(3, knots), [.. poles.Select(p => new Point3(p.X, p.Y, 0))]);
        AlongWithin(Assert.IsType<DrawnCourse>(Assert.Single(drawing.Curves)), share =>
        {
            var p = curve.PointAt(share * 3);
            return new(p.X, p.Y);
        });
        Assert.Empty(drawing.Notes);
    }

    [Fact]
    public void A_spline_of_pieces_with_poles_of_their_own_is_one_curve()
    {
        var drawing = DxfSample.Of(DxfSample.Entity(
            "SPLINE", "0", 71, 1, 40, 0, 40, 0, 40, 1, 40, 1, 40, 2, 40, 2, 10, 0, 20, 0, 10, 1, 20, 0, 10, 1, 20, 0, 10, 5, 20, 7)).Read();
        Assert.Equal([new Point2(0, 0), new(1, 0), new(5, 7)], Assert.IsType<DrawnCourse>(drawing.Curves[0]).Points);
    }

    [Fact]
    public void A_plane_seen_from_below_turns_X_around()
    {
        var drawing = DxfSample.Of(
        [
            .. DxfSample.Entity("ARC", "0", 10, 10, 20, 5, 40, 2, 50, 0, 51, 90, 210, 0, 220, 0, 230, -1),
            .. DxfSample.Entity("LWPOLYLINE", "0", 90, 2, 70, 0, 230, -1, 10, 0, 20, 0, 42, 1, 10, 4, 20, 0),
            .. DxfSample.Entity("ELLIPSE", "0", 10, 10, 20, 5, 11, 3, 21, 0, 40, 0.5, 41, 0, 42, Math.PI / 2, 230, -1),
            .. DxfSample.Entity("LINE", "0", 10, 1, 20, 2, 11, 3, 21, 4, 230, -1),
            .. DxfSample.Entity("INSERT", "0", 10, 100, 20, 0, 50, 90, 230, -1).Append("2 B"),
        ]).Block("B", 0, 0, DxfSample.Entity("LINE", "0", 10, 0, 20, 0, 11, 1, 21, 0)).Read();
        var arc = Assert.IsType<DrawnArc>(drawing.Curves[0]);
        Near(new(-12, 5), arc.From);
        Near(new(-10, 7), arc.To);
        Near(new(-10 - Math.Sqrt(2), 5 + Math.Sqrt(2)), arc.At(0.5));
        Near(new(-2, -2), Assert.IsType<DrawnArc>(drawing.Curves[1]).At(0.5));
        Near(new(13, 5), drawing.Curves[2].From);
        Near(new(10, 3.5), drawing.Curves[2].To);
        Near(new(1, 2), drawing.Curves[3].From);
        Near(new(-100, 0), drawing.Curves[4].From);
        Near(new(-100, 1), drawing.Curves[4].To);
    }

    [Fact]
    public void Insertions_nest_with_base_scale_rotation_and_mirror()
    {
        var sample = DxfSample.Of([.. DxfSample.Entity("INSERT", "TOP", 10, 100, 20, 50, 41, 2, 42, 2, 50, 90), "2 outer"])
            .Block("OUTER", 1, 1, [.. DxfSample.Entity("INSERT", "0", 10, 11, 20, 1, 41, -1, 42, 1), "2 Inner"])
            .Block("Inner", 5, 0, [
                .. DxfSample.Entity("ARC", "0", 10, 5, 20, 0, 40, 3, 50, 0, 51, 90),
                .. DxfSample.Entity("LINE", "OWN", 10, 5, 20, 0, 11, 6, 21, 0)]);
        var drawing = sample.Read();

        // Inner to outer: (x, y) -> (11 - (x - 5), 1 + y); outer to drawing: (x, y) -> (100 - 2 (y - 1), 50 + 2 (x - 1)).
        var arc = Assert.IsType<DrawnArc>(drawing.Curves[0]);
        Near(new(100, 70), arc.Center);
        Assert.Equal(6, arc.Radius, Accuracy);
        Near(new(100, 64), arc.From);
        Near(new(94, 70), arc.To);
        Assert.Equal(-Math.PI / 2, arc.Sweep, Accuracy);
        Assert.Equal("TOP", arc.Layer);
        var line = drawing.Curves[1];
        Assert.Equal("OWN", line.Layer);
        Near(new(100, 70), line.From);
        Near(new(100, 68), line.To);
    }

    [Fact]
    public void A_circle_scaled_differently_along_X_and_Y_is_an_ellipse()
    {
        var drawing = DxfSample.Of([.. DxfSample.Entity("INSERT", "0", 10, 1, 20, 2, 41, 30, 42, 10, 50, 90), "2 C"])
            .Block("C", 0, 0, DxfSample.Entity("CIRCLE", "0", 10, 0, 20, 0, 40, 1)).Read();
        AlongWithin(Assert.IsType<DrawnCourse>(Assert.Single(drawing.Curves)), share =>
        {
            var (sin, cos) = Elementary.SinCos(share * Math.Tau);
            return new(1 - (10 * sin), 2 + (30 * cos));
        });
    }

    [Fact]
    public void A_bulge_scaled_differently_keeps_its_ends()
    {
        var drawing = DxfSample.Of([.. DxfSample.Entity("INSERT", "0", 10, 0, 20, 0, 41, 3, 42, -1), "2 P"])
            .Block("P", 0, 0, DxfSample.Entity("LWPOLYLINE", "0", 90, 2, 10, -1, 20, 0, 42, 1, 10, 1, 20, 0)).Read();
        var course = Assert.IsType<DrawnCourse>(Assert.Single(drawing.Curves));
        AlongWithin(course, share =>
        {
            var (sin, cos) = Elementary.SinCos(Math.PI + (share * Math.PI));
            return new(3 * cos, -sin);
        });
    }

    [Fact]
    public void Columns_and_rows_turn_with_their_insertion()
    {
        var drawing = DxfSample.Of(
            [.. DxfSample.Entity("INSERT", "0", 10, 5, 20, 5, 41, 2, 42, 2, 50, 90, 70, 3, 71, 2, 44, 10, 45, 20), "2 P"])
            .Block("P", 0, 0, DxfSample.Entity("CIRCLE", "0", 10, 1, 20, 0, 40, 1)).Read();
        Assert.Equal(6, drawing.Curves.Count);
        var centers = drawing.Curves.Select(c => ((DrawnArc)c).Center).ToList();
        for (var i = 0; i < 6; i++)
        {
            Near(new(5 - (20 * (i / 3)), 7 + (10 * (i % 3))), centers[i]);
        }
    }

    [Fact]
    public void Bulges_too_flat_to_see_are_lines()
    {
        var drawing = DxfSample.Of(DxfSample.Entity("LWPOLYLINE", "0", 90, 2, 10, 0, 20, 0, 42, 1e-9, 10, 10, 20, 0)).Read();
        Assert.IsType<DrawnLine>(Assert.Single(drawing.Curves));
    }

    // Each point of the polyline is on the curve, and each point of the curve near the polyline.
    private static void AlongWithin(DrawnCourse course, Func<double, Point2> curve)
    {
        Near(curve(0), course.From);
        Near(curve(1), course.To);
        const int Samples = 3000;
        var at = 0;
        for (var i = 0; i <= Samples; i++)
        {
            var p = curve((double)i / Samples);
            var least = double.PositiveInfinity;
            for (var k = at; k < Math.Min(at + 50, course.Points.Count - 1); k++)
            {
                var distance = Distance(p, course.Points[k], course.Points[k + 1]);
                if (distance < least)
                {
                    (least, at) = (distance, k);
                }
            }

            Assert.InRange(least, 0, DrawnCourse.ChordMm);
        }
    }

    private static double Distance(Point2 p, Point2 a, Point2 b)
    {
        var chord = b - a;
        var share = Math.Clamp((p - a).Dot(chord) / chord.Dot(chord), 0, 1);
        return p.DistanceTo(a.Lerp(b, share));
    }

    private static void Near(Point2 expected, Point2 actual) => Assert.InRange(actual.DistanceTo(expected), 0, Accuracy);
}
