using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi.Tests;

public sealed class SurfaceSolidTests
{
    private static readonly double[] Yaws = [-180, -123.4, -30, 0, 17, 90, 179], Pitches = [0, 12, 35, 60, 90];
    private static readonly Vector3[] Places = [new(1, 0, 0), new(0, 1, 0), new(0, 0, 1), new(3.1, -2.2, 0.7), new(-40, 25, 3)];

    [Fact]
    public void A_whole_turn_is_the_identity()
    {
        foreach (var turn in All())
        {
            foreach (var whole in new[] { turn.By(360, 0), turn.By(-360, 0), turn.By(100, 0).By(100, 0).By(160, 0) })
            {
                Assert.Equal(turn.PitchDegrees, whole.PitchDegrees);
                Assert.All(Places, p => Assert.InRange(turn.Project(p).At.DistanceTo(whole.Project(p).At), 0, 1e-9));
                Assert.All(Places, p => Assert.Equal(turn.Project(p).Nearness, whole.Project(p).Nearness, 1e-9));
            }
        }
    }

    [Fact]
    public void Lengths_in_the_plane_of_the_screen_are_kept()
    {
        foreach (var turn in All())
        {
            // What is not seen of a length is along the line of sight, and nothing else.
            Assert.All(
                Places,
                p => Assert.Equal(p.Length, turn.Project(p) is var (at, near) ? new Vector3(at.X, at.Y, near).Length : 0, 1e-9));
        }

        // From above, all that is horizontal has its length; from the front, all that is vertical.
        Assert.All(Yaws, y => Assert.Equal(5, new SurfaceTurn(y, 90).Project(new(3, 4, 9)).At.DistanceTo(Point2.Origin), 1e-9));
        Assert.All(Yaws, y => Assert.Equal(9, new SurfaceTurn(y, 0).Project(new(3, 4, 9)).At.Y, 1e-9));
    }

    [Fact]
    public void The_eye_stays_above_the_surface_and_a_turn_goes_where_the_finger_goes()
    {
        Assert.Equal(90, new SurfaceTurn(0, 80).By(0, 50).PitchDegrees);
        Assert.Equal(0, new SurfaceTurn(0, 10).By(0, -50).PitchDegrees);

        // What is in front, toward the eye, moves to the right.
        Assert.True(new SurfaceTurn(20, 35).Project(new(0, -1, 0)).At.X > new SurfaceTurn(0, 35).Project(new(0, -1, 0)).At.X);
        Assert.True(new SurfaceTurn(0, 35).Project(new(0, -1, 0)).Nearness > 0);
    }

    [Fact]
    public void Far_facets_are_drawn_before_near_ones_and_none_is_lost()
    {
        var solid = new SurfaceSolid(Drawing(9, 7));
        Assert.Equal(48, solid.Facets.Count);
        foreach (var turn in All())
        {
            var ordered = solid.Ordered(turn);
            Assert.Equal(solid.Facets.Count, ordered.Select(o => o.Facet).Distinct().Count());

            // The surface is flat but for its error: from the side, the farther the facet, the earlier.
            double[] near = [.. ordered.Select(o => o.Facet.Places.Average(p => turn.Project(Flat(solid, p)).Nearness))];
            var most = solid.HalfHeight * 2.1;
            Assert.All(near.Zip(near.Skip(1)), n => Assert.True(n.Second >= n.First - most, $"{n.Second} is drawn after {n.First}."));
        }

        // Without any error: exactly by their distance.
        var plane = new SurfaceSolid(Drawing(9, 7) with { ValuesMm = [.. Enumerable.Repeat(0.0, 63)] });
        foreach (var turn in All())
        {
            double[] near = [
                .. plane.Ordered(turn).Select(o => o.Facet.Places.Average(p => turn.Project(Flat(plane, p)).Nearness))];
            Assert.All(near.Zip(near.Skip(1)), n => Assert.True(n.Second >= n.First - 1e-9, $"{n.Second} is drawn after {n.First}."));
        }
    }

    [Fact]
    public void The_error_is_enlarged_along_the_normal_by_the_factor_that_is_stated()
    {
        var drawing = Drawing(9, 7) with { Points = [("1", new(20, 10), "")] };
        var (solid, flat) = (new SurfaceSolid(drawing), new SurfaceSolid(drawing with { ValuesMm = [.. Enumerable.Repeat(0.0, 63)] }));
        Assert.True(solid.Factor > 1);
        var (u, v) = NetPlaces.Under(drawing.Net, new(20, 10))!.Value;
        var raised = solid.Points[0] - flat.Points[0];
        Assert.Equal(solid.Factor * NetPlaces.ValueAt(drawing.Net, drawing.ValuesMm!, u, v), raised.Z, 1e-9);
        Assert.Equal(0, raised.X, 1e-9);
    }

    [Fact]
    public void A_fine_net_is_thinned_to_as_many_facets_as_are_drawn_in_time()
    {
        var solid = new SurfaceSolid(Drawing(200, 160));
        Assert.InRange(solid.Facets.Count, SurfaceSolid.MostFacets / 4, SurfaceSolid.MostFacets);

        // To its borders.
        Assert.Contains(solid.Facets, f => f.Places.Contains((200 * 160) - 1));
    }

    [Fact]
    public void A_place_of_a_net_is_found_under_its_point_and_none_beside_the_piece()
    {
        var net = Drawing(9, 7).Net with { Outside = [0, 7] };
        foreach (var (u, v) in new[] { (0.5, 2.25), (7.9, 5.9), (3, 4), (8, 6), (4.2, 0) })
        {
            var at = NetPlaces.PositionAt(net, u, v);
            var found = NetPlaces.Under(net, new(at.X, at.Y))!.Value;
            Assert.Equal(u, found.U, 1e-6);
            Assert.Equal(v, found.V, 1e-6);
        }

        Assert.Null(NetPlaces.Under(net, new(-50, 0)));
        var outside = NetPlaces.PositionAt(net, 0.5, 0.5);
        Assert.Null(NetPlaces.Under(net, new(outside.X, outside.Y)));
    }

    [Fact]
    public void A_section_is_interrupted_where_the_piece_is()
    {
        // A hole of two cells in the middle row.
        var drawing = Drawing(9, 7);
        drawing = drawing with { Net = drawing.Net with { Outside = [(3 * 6) + 2, (4 * 6) + 2] } };
        var at = NetPlaces.PositionAt(drawing.Net, 1.5, 2.5);
        var section = SurfaceSections.Of(drawing, new(at.X, at.Y))!.AlongU;
        Assert.Equal(1, section.Points.Count(p => !double.IsFinite(p.Mm)));
        Assert.Equal(9 - 1 + 1 + 1, section.Points.Count);
        Assert.Equal(section.AtMm, section.Points[2].Mm, 1e-6);
        Assert.Equal(section.LengthMm, section.Points[^1].Mm, 1e-9);
    }

    private static IEnumerable<SurfaceTurn> All() => Yaws.SelectMany(y => Pitches.Select(p => new SurfaceTurn(y, p)));

    // A parallelogram at one height.
    private static Vector3 Flat(SurfaceSolid solid, int place)
    {
        var (p, middle) = (solid.Drawing.Net.Places[place], solid.Drawing.Extent.Middle);
        return new(p.X - middle.X, p.Y - middle.Y, 0);
    }

    private static SurfaceDrawing Drawing(int countU, int countV) => new(
        new(
            countU,
            countV,
            [
                .. Enumerable.Range(0, countU * countV).Select(i => (U: i / countV, V: i % countV)).Select(
                    p => new Point3((9.7 * p.U) + (3.1 * p.V), (8.3 * p.V) - (2.3 * p.U), 4))],
            []),
        [.. Enumerable.Range(0, countU * countV).Select(i => 0.02 * Math.Sin(1.3 * i))],
        0.02,
        [],
        ShowsWay: false);
}
