using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs.Tests;

/// <summary>Flat faces of STEP files as drawings, against closed forms.</summary>
public sealed class StepDrawingTests
{
    private const double Accuracy = 1e-9;

    // A quarter of a disk: an arc from (5, 0) to (0, 5) about the origin, and two lines. However the arc is written, it is the short one.
    [Theory]
    [InlineData(false, true, false)]
    [InlineData(false, true, true)]
    [InlineData(false, false, false)]
    [InlineData(false, false, true)]
    [InlineData(true, true, false)]
    [InlineData(true, true, true)]
    [InlineData(true, false, false)]
    [InlineData(true, false, true)]
    public void An_arc_is_the_same_in_all_senses(bool isDown, bool sameSense, bool isClockwise)
    {
        var sample = new StepSample();
        Point3 a = new(5, 0, 2), b = new(0, 5, 2), center = new(0, 0, 2);
        var (va, vb, vc) = (sample.Vertex(a), sample.Vertex(b), sample.Vertex(center));
        var circle = sample.Circle(center, 5, isDown ? -1 : 1);

        // A circle about -z turns from b to a. An edge of the other sense runs against its circle.
        var startsAtA = isDown != sameSense;
        var arc = sample.Edge(startsAtA ? va : vb, startsAtA ? vb : va, circle, sameSense, forward: startsAtA != isClockwise);
        var (out1, in1) = (sample.Line(center, a), sample.Line(b, center));
        string[] loop = isClockwise
            ? [arc, sample.Edge(vc, va, out1, forward: false), sample.Edge(vb, vc, in1, forward: false)]
            : [arc, sample.Edge(vb, vc, in1), sample.Edge(vc, va, out1)];
        sample.Face(sample.Plane(center, new(0, 0, 1)), loop);
        var drawing = sample.Read();
        Assert.Equal(3, drawing.Curves.Count);
        var drawn = Assert.IsType<DrawnArc>(drawing.Curves[0]);
        Assert.Equal($"{circle} CIRCLE", drawn.Entity);
        Near(new(5 / Math.Sqrt(2), 5 / Math.Sqrt(2)), drawn.At(0.5));
        Near(isClockwise ? new(0, 5) : new(5, 0), drawn.From);
        Assert.Equal(isClockwise ? -Math.PI / 2 : Math.PI / 2, drawn.Sweep, Accuracy);
        Assert.True(Assert.Single(OutlineChain.Join(drawing.Curves)).IsClosed);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_circle_is_a_circle_also_where_it_is_written_as_two_halves(bool isHalved)
    {
        var sample = new StepSample();
        var circle = sample.Circle(new(3, 4, 0), 2.5);
        var (right, left) = (sample.Vertex(new(5.5, 4, 0)), sample.Vertex(new(0.5, 4, 0)));
        string[] loop = isHalved
            ? [sample.Edge(right, left, circle), sample.Edge(left, right, sample.Circle(new(3, 4, 0), 2.5))]
            : [sample.Edge(right, right, circle)];
        sample.Face(sample.Plane(new(0, 0, 0), new(0, 0, -1)), loop);
        var drawn = Assert.IsType<DrawnArc>(Assert.Single(sample.Read().Curves));
        Assert.True(drawn.IsCircle);
        Assert.Equal((new Point2(3, 4), 2.5), (drawn.Center, drawn.Radius));
        Near(new(5.5, 4), drawn.From);
    }

    [Fact]
    public void Arcs_of_one_circle_are_one_where_the_loop_begins_within_them_but_not_around_a_corner()
    {
        // A half disk, its arc in three parts, the loop begins at the second one.
        var sample = new StepSample();
        Point3[] at = [.. new[] { 0, 1, 2, Math.PI }.Select(t => new Point3(8 * Math.Cos(t), 8 * Math.Sin(t), 0))];
        string[] v = [.. at.Select(sample.Vertex)];
        var circle = sample.Circle(new(0, 0, 0), 8);
        sample.Face(
            sample.Plane(new(0, 0, 0), new(0, 0, 1)),
            [
                sample.Edge(v[1], v[2], circle), sample.Edge(v[2], v[3], circle), sample.Edge(v[3], v[0], sample.Line(at[3], at[0])),
                sample.Edge(v[0], v[1], circle),
            ]);
        var curves = sample.Read().Curves;
        Assert.Equal(2, curves.Count);
        var arc = Assert.Single(curves.OfType<DrawnArc>());
        Assert.Equal(Math.PI, arc.Sweep, Accuracy);
        Near(new(8, 0), arc.From);
        Near(new(0, 8), arc.At(0.5));
        Near(new(-8, 0), arc.To);
    }

    [Fact]
    public void Top_and_bottom_of_a_plate_with_holes_count_once()
    {
        var drawing = new StepSample().Plate([Stadium, [new DrawnArc("", "", new(10, 3), 2, 0, Math.Tau)]], 1.5, 9).Read();
        Assert.Single(drawing.Layers);
        Assert.Equal(5, drawing.Curves.Count);
        Assert.Equal(" at Z 9, 1.5 mm", drawing.Places[drawing.Layers[0]]);
        Assert.Contains(
            drawing.Notes,
            n => n.StartsWith("Counted once, because they have the outline of another face: 1 flat face", StringComparison.Ordinal));
        Assert.Contains(
            drawing.Notes,
            n => n.StartsWith("Passed over, because they are not perpendicular to Z: 2 flat faces (first: #", StringComparison.Ordinal));
        Assert.Contains("Passed over, because they are not flat: 3 faces (3 CYLINDRICAL_SURFACE).", drawing.Notes);
        Assert.Equal(new DrawingUnit(1, true), drawing.Unit);
        var arc = drawing.Curves.OfType<DrawnArc>().Single(a => a.Center.DistanceTo(new(20, 5)) < 1e-9);
        Near(new(25, 5), arc.At(0.5));
    }

    // Faces that differ by more than what two drawings of one free curve may are two.
    [Theory]
    [InlineData(0, 1)]
    [InlineData(0.001, 1)]
    [InlineData(0.003, 2)]
    public void Outlines_that_differ_are_two_layers(double longer, int layers)
    {
        var sample = new StepSample();
        sample.Face("LOW", sample.Plane(new(0, 0, 0), new(0, 0, 1)), [Rectangle(sample, 20, 10, 0)]);
        sample.Face("HIGH", sample.Plane(new(0, 0, 4), new(0, 0, 1)), [Rectangle(sample, 20 + longer, 10, 4)]);
        var drawing = sample.Read();
        Assert.Equal(layers, drawing.Layers.Count);
        Assert.Equal(layers == 1 ? " at Z 0, 4 mm, \"LOW\"" : " at Z 0 mm, \"LOW\"", drawing.Places[drawing.Layers[0]]);
    }

    [Theory]
    [InlineData("X")]
    [InlineData("Y")]
    public void Without_a_face_seen_from_above_those_seen_from_the_side_are_taken(string axis)
    {
        // A right triangle with its right angle at the origin: 7 along the first axis of the drawing, 4 along the second.
        var (first, second, normal) = axis == "X"
            ? (new Vector3(0, 1, 0), new Vector3(0, 0, 1), new Vector3(1, 0, 0))
            : (new Vector3(0, 0, 1), new Vector3(1, 0, 0), new Vector3(0, 1, 0));
        var sample = new StepSample();
        var corner = default(Point3) + (normal * 5);
        sample.Face(sample.Plane(corner, normal), [sample.Polygon(corner, corner + (first * 7), corner + (second * 4))]);
        var drawing = sample.Read();
        Assert.Equal([new(0, 0), new(7, 0), new Point2(0, 4)], drawing.Curves.Select(c => c.From));
        Assert.Equal($" at {axis} 5 mm", Assert.Single(drawing.Places).Value);
        Assert.StartsWith(
            axis == "X" ? "No flat face is perpendicular to Z. Read instead: those perpendicular to X, with Y and Z of the model as X and Y"
                : "No flat face is perpendicular to Z. Read instead: those perpendicular to Y, with Z and X of the model as X and Y",
            Assert.Single(drawing.Notes),
            StringComparison.Ordinal);
    }

    [Fact]
    public void A_part_that_is_tilted_is_refused()
    {
        var sample = new StepSample();
        Point3 a = new(0, 0, 0), b = new(10, 0, 0), c = new(0, 10, 10);
        sample.Face(sample.Plane(a, new(0, -1, 1)), [sample.Polygon(a, b, c)]);
        var refused = sample.Refused();
        Assert.Equal("tilted-faces", refused.Code);
        Assert.Contains("1 flat face; the normal of ", refused.Problem, StringComparison.Ordinal);
        Assert.Contains("is 0, -0.70711, 0.70711", refused.Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void A_part_without_a_flat_face_is_refused()
    {
        var sample = new StepSample();
        sample.Face(sample.Add($"SPHERICAL_SURFACE('',{sample.Placement(new(0, 0, 0), new(0, 0, 1), new(1, 0, 0))},5.)"));
        var refused = sample.Refused();
        Assert.Equal("no-flat-face", refused.Code);
        Assert.Contains("1 face (1 SPHERICAL_SURFACE)", refused.Problem, StringComparison.Ordinal);
    }

    [Fact]
    public void An_ellipse_and_a_rational_spline_are_within_the_chord_error_of_their_closed_forms()
    {
        // A whole ellipse of half axes 9 and 4; a circle of radius 6 as four rational quadratics.
        var sample = new StepSample();
        var ellipse = sample.Add($"ELLIPSE('',{sample.Placement(new(1, 2, 0), new(0, 0, 1), new(1, 0, 0))},9.,4.)");
        var start = sample.Vertex(new(10, 2, 0));
        double[] x = [6, 6, 0, -6, -6, -6, 0, 6, 6], y = [0, 6, 6, 6, 0, -6, -6, -6, 0];
        var poles = string.Join(',', x.Zip(y, (a, b) => sample.Point(new(a + 30, b, 0))));
        var w = StepSample.Real(Math.Sqrt(0.5));
        var shape = $"B_SPLINE_CURVE(2,({poles}),.UNSPECIFIED.,.T.,.F.)"
            + "B_SPLINE_CURVE_WITH_KNOTS((3,2,2,2,3),(0.,1.,2.,3.,4.),.UNSPECIFIED.)CURVE()GEOMETRIC_REPRESENTATION_ITEM()";
        var spline = sample.Add(
            $"(BOUNDED_CURVE(){shape}RATIONAL_B_SPLINE_CURVE((1.,{w},1.,{w},1.,{w},1.,{w},1.))REPRESENTATION_ITEM(''))");
        var seam = sample.Vertex(new(36, 0, 0));
        sample.Face(
            sample.Plane(new(0, 0, 0), new(0, 0, 1)),
            [sample.Edge(start, start, ellipse)],
            [sample.Edge(seam, seam, sample.Add($"SURFACE_CURVE('',{spline},(),.CURVE_3D.)"), forward: false)]);
        var drawing = sample.Read();
        Assert.Equal(2, drawing.Curves.Count);
        var (one, two) = (Assert.IsType<DrawnCourse>(drawing.Curves[0]), Assert.IsType<DrawnCourse>(drawing.Curves[1]));
        Assert.All(one.Points, p => Assert.Equal(1, Math.Pow((p.X - 1) / 9, 2) + Math.Pow((p.Y - 2) / 4, 2), 1e-9));
        Assert.All(Middles(two), p => Assert.InRange(p.DistanceTo(new(30, 0)), 6 - DrawnCourse.ChordMm, 6 + 1e-9));

        // Ramanujan: pi (a + b) (1 + 3 h / (10 + sqrt(4 - 3 h))), h = ((a - b) / (a + b))^2, for a = 9 and b = 4.
        Assert.Equal(42.3656, one.LengthMm, 2e-3);
        Assert.Equal($"{spline} B_SPLINE_CURVE", two.Entity);

        // Backward: clockwise.
        Assert.True(two.Points[1].Y < 0);
    }

    [Fact]
    public void Polylines_and_loops_of_points_are_lines()
    {
        var sample = new StepSample();
        Point3[] p = [new(0, 0, 0), new(8, 0, 0), new(8, 3, 0), new(0, 3, 0)];
        var (from, to) = (sample.Vertex(p[0]), sample.Vertex(p[3]));
        var polyline = sample.Add($"POLYLINE('',({string.Join(',', p.Select(sample.Point))}))");
        sample.Face(sample.Plane(p[0], new(0, 0, 1)), [sample.Edge(from, to, polyline), sample.Edge(to, from, sample.Line(p[3], p[0]))]);
        Assert.Equal(
            [new(0, 0), new(8, 0), new(8, 3), new Point2(0, 3)], sample.Read().Curves.Select(c => Assert.IsType<DrawnLine>(c).Start));

        var other = new StepSample();
        other.FaceOf(other.Plane(p[0], new(0, 0, 1)), other.Add($"POLY_LOOP('',({string.Join(',', p.Select(other.Point))}))"));
        Assert.Equal(
            [new(0, 0), new(8, 0), new(8, 3), new Point2(0, 3)], other.Read().Curves.Select(c => Assert.IsType<DrawnLine>(c).Start));
    }

    // One edge written as a trimmed curve, one way and the other.
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Of_a_trimmed_curve_the_sense_counts(bool sense)
    {
        var sample = new StepSample();
        var circle = sample.Circle(new(0, 0, 0), 5);
        var (a, b) = (sample.Vertex(new(5, 0, 0)), sample.Vertex(new(0, 5, 0)));
        var trimmed = sample.Add(
            $"TRIMMED_CURVE('',{circle},(PARAMETER_VALUE(0.)),(PARAMETER_VALUE(1.)),{(sense ? ".T." : ".F.")},.PARAMETER.)");

        // Against the circle, from (5, 0) to (0, 5) is three quarters of it.
        sample.Face(
            sample.Plane(new(0, 0, 0), new(0, 0, 1)),
            [sample.Edge(a, b, trimmed), sample.Edge(b, a, sample.Line(new(0, 5, 0), new(5, 0, 0)))]);
        var arc = Assert.IsType<DrawnArc>(sample.Read().Curves[0]);
        Assert.Equal(sense ? Math.PI / 2 : -1.5 * Math.PI, arc.Sweep, Accuracy);
        Near(new(5, 0), arc.From);
    }

    // A ring whose two outlines are joined by a cut, along which the face goes on.
    [Fact]
    public void An_edge_with_the_face_on_both_sides_is_no_outline()
    {
        var sample = new StepSample();
        var (a, b) = (sample.Vertex(new(9, 0, 0)), sample.Vertex(new(4, 0, 0)));
        var (outer, inner) = (sample.Circle(new(0, 0, 0), 9), sample.Circle(new(0, 0, 0), 4));
        var cut = sample.Add($"EDGE_CURVE('',{a},{b},{sample.Line(new(9, 0, 0), new(4, 0, 0))},.T.)");
        sample.Face(
            sample.Plane(new(0, 0, 0), new(0, 0, 1)),
            [
                sample.Edge(a, a, outer), sample.Oriented(cut, true), sample.Edge(b, b, inner, forward: false), sample.Oriented(cut, false),
            ]);
        var drawing = sample.Read();
        Assert.Equal([9.0, 4.0], drawing.Curves.Select(c => Assert.IsType<DrawnArc>(c).Radius));
        Assert.All(drawing.Curves, c => Assert.True(((DrawnArc)c).IsCircle));
        Assert.StartsWith(
            "Passed over, because the face is on both sides of them: 2 curves", Assert.Single(drawing.Notes), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("$,.METRE.", 1000)]
    [InlineData(".CENTI.,.METRE.", 10)]
    public void The_unit_is_the_files(string unit, double mm)
    {
        var sample = new StepSample();
        sample.Face(sample.Plane(new(0, 0, 0), new(0, 0, 1)), [Rectangle(sample, 0.2, 0.1, 0)]);
        var text = sample.Bytes($"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT({unit}))");
        var drawing = StepDrawing.Read(text, "part.stp", null);
        Assert.Equal(new DrawingUnit(mm, true), drawing.Unit);
        Assert.Equal(0.2 * mm, drawing.Curves[0].LengthMm, 1e-9);
        Assert.Equal(0.2 * 25.4, StepDrawing.Read(text, "part.stp", 25.4).Curves[0].LengthMm, 1e-9);

        // Who names the unit needs none in the file.
        var none = sample.Bytes("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
        Assert.Equal("bad-unit", StepSample.Refused(none).Code);
        Assert.Equal(0.2, StepDrawing.Read(none, "part.stp", 1).Curves[0].LengthMm, 1e-9);
    }

    public static TheoryData<string, string, string, string> Broken => new()
    {
        { "CIRCLE(", "HYPERBOLA(", "not-read", "HYPERBOLA" },
        { "CIRCLE(", "COMPOSITE_CURVE(", "not-read", "COMPOSITE_CURVE" },
        { ",5.);", ",-5.);", "bad-value", "a radius of -5" },
        { ",5.);", ",5.02);", "open-loop", "a gap of 0.02 mm" },
        { ",5.);", ",5.2);", "bad-curve", "0.2 mm away from this curve" },
        { ",5.);", ",7000000.);", "bad-curve", "away from this curve" },
        { "(5.,0.,2.)", "(5.,0.,2.2)", "bad-curve", "0.2 mm away from this curve" },
        { "(5.,0.,2.)", "(5.,0.)", "bad-curve", "2 mm away from this curve" },
        { "(5.,0.,2.)", "(5.,0.,x)", "bad-instance", "where" },
        { "EDGE_LOOP('',(", "EDGE_LOOP('',(#999,", "bad-reference", "#999, which the file does not have" },
        { "EDGE_LOOP('',(", "EDGE_LOOP('',(#10,", "bad-instance", "ORIENTED_EDGE is missing" },
        { "EDGE_LOOP(", "HOLE_LOOP(", "not-read", "a loop of this kind" },
        { "FACE_BOUND(", "FACE_HOLE(", "bad-reference", "FACE_BOUND or FACE_OUTER_BOUND is expected" },
        { "EDGE_CURVE(", "SUBEDGE(", "bad-reference", "EDGE_CURVE is expected" },
        { "VECTOR(", "VERTEX(", "bad-reference", "VECTOR is expected" },
        { "(0.,0.,1.)", "(0.,0.,0.)", "bad-value", "axes of length zero" },
    };

    [Theory]
    [MemberData(nameof(Broken))]
    public void What_is_broken_is_named_with_its_instance_and_line(string was, string becomes, string code, string said)
    {
        var text = QuarterDisk().Text();
        var at = text.IndexOf(was, StringComparison.Ordinal);
        Assert.True(at > 0, was);
        var refused = StepSample.Refused(Encoding.Latin1.GetBytes(text[..at] + becomes + text[(at + was.Length)..]));
        Assert.Equal(code, refused.Code);
        Assert.Contains(said, refused.Problem, StringComparison.Ordinal);
        var instance = refused.Problem.Split(' ', ':')[0];
        Assert.StartsWith("#", instance, StringComparison.Ordinal);
        Assert.Equal(StepSample.LineOf(instance), refused.Place.Line);
        Assert.Equal("part.stp", refused.File);
    }

    [Theory]
    [InlineData(0.04, null)]
    [InlineData(0.06, "limit-off-surface")]
    public void Edges_are_in_the_plane_of_their_face(double off, string? code)
    {
        var sample = new StepSample();
        sample.Face(sample.Plane(new(0, 0, off), new(0, 0, 1)), [Rectangle(sample, 20, 10, 0)]);
        if (code is null)
        {
            Assert.Equal(4, sample.Read().Curves.Count);
            return;
        }

        var refused = sample.Refused();
        Assert.Equal(code, refused.Code);
        Assert.Matches(@"^[^(]*0\.06 mm [^(]*\(0, 0, 0\)", refused.Problem);
    }

    [Fact]
    public void An_outline_that_an_edge_leaves_open_is_refused()
    {
        var sample = new StepSample();
        var loop = Rectangle(sample, 20, 10, 0);
        var face = sample.Face(sample.Plane(new(0, 0, 0), new(0, 0, 1)), [loop[..3]]);
        var refused = sample.Refused();
        Assert.Equal("open-loop", refused.Code);
        Assert.StartsWith($"{face} ADVANCED_FACE: ", refused.Problem, StringComparison.Ordinal);
        Assert.Contains(" 10 mm", refused.Problem, StringComparison.Ordinal);
        Assert.Equal(StepSample.LineOf(face), refused.Place.Line);
    }

    // CAD systems write coordinates of four digits: what the chain takes for one place is closed.
    [Theory]
    [InlineData(0.009, true)]
    [InlineData(0.012, false)]
    public void A_gap_is_closed_up_to_what_drawings_are_rounded(double gap, bool isClosed)
    {
        var sample = new StepSample();
        var (from, to) = (sample.Vertex(new(0, 0, 0)), sample.Vertex(new(20, 0, 0)));
        var near = sample.Vertex(new(0, gap, 0));
        var corner = sample.Vertex(new(20, 9, 0));
        sample.Face(
            sample.Plane(new(0, 0, 0), new(0, 0, 1)),
            [
                sample.Edge(from, to, sample.Line(new(0, 0, 0), new(20, 0, 0))),
                sample.Edge(to, corner, sample.Line(new(20, 0, 0), new(20, 9, 0))),
                sample.Edge(corner, near, sample.Line(new(20, 9, 0), new(0, gap, 0))),
            ]);
        if (isClosed)
        {
            Assert.True(Assert.Single(OutlineChain.Join(sample.Read().Curves)).IsClosed);
        }
        else
        {
            Assert.Equal("open-loop", sample.Refused().Code);
        }
    }

    [Fact]
    public void What_is_wrong_in_a_face_that_is_not_drawn_does_not_matter()
    {
        var text = new StepSample().Plate([Stadium], 0, 5).Text();

        // The first face is a side face; its loop comes first.
        var loop = text.IndexOf("EDGE_LOOP(", StringComparison.Ordinal);
        var drawing = StepDrawing.Read(
            Encoding.Latin1.GetBytes(text[..loop] + "HOLE_LOOP(" + text[(loop + 10)..]), "part.stp", null);
        Assert.Equal(4, drawing.Curves.Count);
    }

    [Fact]
    public void A_file_that_is_cut_off_is_refused()
    {
        var bytes = QuarterDisk().Bytes();
        var text = Encoding.Latin1.GetString(bytes);
        var refused = StepSample.Refused(bytes[..(text.IndexOf("EDGE_LOOP", StringComparison.Ordinal) + 12)]);
        Assert.Equal("truncated", refused.Code);
        Assert.NotNull(refused.Place.Line);

        // Between two statements, what is missing is what others refer to.
        var between = text.IndexOf("FACE_BOUND", StringComparison.Ordinal);
        between = text.LastIndexOf(';', between) + 1;
        Assert.Equal("bad-reference", StepSample.Refused(bytes[..between]).Code);
    }

    [Fact]
    public void Too_many_faces_are_refused_soon()
    {
        var sample = new StepSample();
        var plane = sample.Plane(new(0, 0, 0), new(0, 0, 1));
        for (var i = 0; i <= StepDrawing.MaxFaces; i++)
        {
            sample.Face(plane);
        }

        Assert.Equal("too-large", sample.Refused().Code);
    }

    [Fact]
    public void A_part_far_from_its_origin_is_refused()
    {
        var sample = new StepSample();
        sample.Face(sample.Plane(new(0, 0, 0), new(0, 0, 1)), [Rectangle(sample, 2e6, 10, 0)]);
        Assert.Equal("too-large", sample.Refused().Code);
    }

    [Fact]
    public void Mutated_files_are_read_or_refused()
    {
        var random = new Random(4711);
        byte[][] originals = [
            QuarterDisk().Bytes(), new StepSample().Plate([Stadium, [new DrawnArc("", "", new(10, 3), 2, 0, Math.Tau)]], 0, 5).Bytes()];
        var (read, refused) = (0, 0);
        for (var i = 0; i < 4000; i++)
        {
            var bytes = (byte[])originals[i % 2].Clone();
            switch (random.Next(4))
            {
                case 0:
                    for (var k = random.Next(1, 4); k > 0; k--)
                    {
                        bytes[random.Next(bytes.Length)] = (byte)random.Next(32, 127);
                    }

                    break;
                case 1:
                    bytes = bytes[..random.Next(bytes.Length)];
                    break;
                case 2:
                    var (from, length) = (random.Next(bytes.Length - 30), random.Next(1, 30));
                    bytes = [.. bytes[..from], .. bytes[(from + length)..]];
                    break;
                default:
                    // A number becomes another one: references, flags of counts, coordinates.
                    var at = Enumerable.Range(0, 1000).Select(_ => random.Next(bytes.Length)).First(k => char.IsAsciiDigit((char)bytes[k]));
                    bytes[at] = (byte)random.Next('0', '9' + 1);
                    break;
            }

            try
            {
                var drawing = StepDrawing.Read(bytes, "part.stp", null);
                Assert.NotEmpty(drawing.Curves);
                Assert.All(drawing.Curves, c => Assert.True(c.From.IsFinite && c.To.IsFinite && c.LengthMm > 0));
                Assert.All(OutlineChain.Join(drawing.Curves), c => Assert.NotEmpty(c.Curves));
                read++;
            }
            catch (InputException e)
            {
                Assert.Equal("part.stp", e.File);
                Assert.NotEmpty(e.Problem);
                refused++;
            }
        }

        Assert.True(read > 300 && refused > 300, string.Create(CultureInfo.InvariantCulture, $"{read} read, {refused} refused"));
    }

    // 20 long, with round ends of radius 5.
    private static IReadOnlyList<DrawnCurve> Stadium =>
    [
        new DrawnLine("", "", new(0, 0), new(20, 0)), new DrawnArc("", "", new(20, 5), 5, -Math.PI / 2, Math.PI),
        new DrawnLine("", "", new(20, 10), new(0, 10)), new DrawnArc("", "", new(0, 5), 5, Math.PI / 2, Math.PI),
    ];

    private static StepSample QuarterDisk()
    {
        var sample = new StepSample();
        Point3 a = new(5, 0, 2), b = new(0, 5, 2), center = new(0, 0, 2);
        var (va, vb, vc) = (sample.Vertex(a), sample.Vertex(b), sample.Vertex(center));
        sample.Face(
            sample.Plane(center, new(0, 0, 1)),
            [
                sample.Edge(va, vb, sample.Circle(center, 5)), sample.Edge(vb, vc, sample.Line(b, center)),
                sample.Edge(vc, va, sample.Line(center, a)),
            ]);
        return sample;
    }

    private static string[] Rectangle(StepSample sample, double x, double y, double z) =>
        sample.Polygon(new(0, 0, z), new(x, 0, z), new(x, y, z), new(0, y, z));

    private static IEnumerable<Point2> Middles(DrawnCourse course) => course.Points.Zip(course.Points.Skip(1), (a, b) => a.Lerp(b, 0.5));

    private static void Near(Point2 expected, Point2 actual) => Assert.Equal(0, expected.DistanceTo(actual), Accuracy);
}
