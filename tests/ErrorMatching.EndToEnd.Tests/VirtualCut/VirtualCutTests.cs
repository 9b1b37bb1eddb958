namespace ErrorMatching.EndToEnd.Tests;

public sealed class VirtualCutTests
{
    [Fact]
    public void Straight_slot_has_two_walls_and_round_ends()
    {
        var cut = Cut("G0 X0 Y0\nG1 X100");

        Assert.Equal(0, cut.Probe(new(50, 3), new(0, -1)), 8);
        Assert.Equal(0, cut.Probe(new(50, -3), new(0, 1)), 8);
        Assert.Equal(0, cut.Probe(new(103, 0), new(-1, 0)), 8);
        Assert.Equal(0, cut.Probe(Flat.Toward(Math.PI * 0.75) * 3, new(1, -1)), 8);
        Assert.Equal(2, cut.Clearance(new(50, 5)), 12);
        Assert.Equal(-3, cut.Clearance(new(50, 0)), 12);
    }

    // The normal points from the material to the tool: a key point that lies in the air says too little material, and the other way round.
    [Fact]
    public void Material_that_stands_beyond_the_key_point_counts_positive()
    {
        var cut = Cut("G0 X0 Y0\nG1 X100");

        Assert.Equal(0.1, cut.Probe(new(50, 3.1), new(0, -1)), 8);
        Assert.Equal(-0.1, cut.Probe(new(50, 2.9), new(0, -1)), 8);
    }

    [Fact]
    public void Oblique_normal_meets_the_wall_further_away()
    {
        var cut = Cut("G0 X0 Y0\nG1 X100");

        Assert.Equal(0.1 / Math.Cos(Math.PI / 6), cut.Probe(new(50, 3.1), Flat.Toward((-90 + 30) * Math.PI / 180)), 8);
    }

    [Theory]
    [InlineData("G3 I-20")]
    [InlineData("G2 I-20")]
    public void Circle_leaves_a_plug_and_a_hole(string circle)
    {
        var cut = Cut("G0 X20 Y0\n" + circle);
        for (var degrees = 5; degrees < 360; degrees += 10)
        {
            var outward = Flat.Toward(degrees * Math.PI / 180);
            Assert.Equal(0, cut.Probe(outward * 17, outward), 8);
            Assert.Equal(0, cut.Probe(outward * 23, -outward), 8);
        }
    }

    [Fact]
    public void Arc_ends_where_its_sweep_ends()
    {
        var cut = Cut("G0 X20 Y0\nG3 X0 Y20 I-20 J0");

        Assert.Equal(0, cut.Probe(Flat.Toward(1) * 17, Flat.Toward(1)), 8);
        // Below the start only the tool's own circle was cut.
        Assert.Equal(0, cut.Probe(new(20, -3), new(0, 1)), 8);
        Assert.Throws<RefereeException>(() => cut.Probe(Flat.Toward(-1) * 17, Flat.Toward(-1)));
    }

    // The tool turns toward the material: the walls meet in a sharp edge, r / sin(half the angle) from the path's vertex.
    [Fact]
    public void Outer_corner_is_sharp()
    {
        var cut = Cut("G0 X-50 Y0\nG1 X0\nY50");

        Assert.Equal(0, cut.Probe(new(-3, 3), new(1, -1)), 8);
        Assert.Equal(0, cut.Probe(new(-3, 10), new(1, 0)), 8);
        Assert.Equal(0, cut.Probe(new(-10, 3), new(0, -1)), 8);
    }

    // The tool turns away from the material: it leaves its own radius about the path's vertex.
    [Fact]
    public void Inner_corner_keeps_the_radius_of_the_tool()
    {
        var cut = Cut("G0 X-50 Y0\nG1 X0\nY50");
        foreach (var degrees in new[] { 0, -20, -45, -70, -90 })
        {
            var outward = Flat.Toward(degrees * Math.PI / 180);
            Assert.Equal(0, cut.Probe(outward * 3, -outward), 8);
        }
    }

    // A regular polygon inscribed in a circle: each chord lies R (1 - cos(pi/n)) inside it.
    [Theory]
    [InlineData(12)]
    [InlineData(60)]
    [InlineData(360)]
    public void Polylined_circle_shows_its_sagitta(int sides)
    {
        const double Radius = 20;
        var program = "G0 X20 Y0\n" + string.Concat(Enumerable.Range(1, sides).Select(k => FormattableString.Invariant(
            $"G1 X{Radius * Math.Cos(2 * Math.PI * k / sides):F9} Y{Radius * Math.Sin(2 * Math.PI * k / sides):F9}\n")));
        var cut = Cut(program);
        var atChord = Flat.Toward(Math.PI / sides);
        var atVertex = Flat.Toward(2 * Math.PI / sides);
        var cosine = Math.Cos(Math.PI / sides);

        Assert.Equal(-Radius * (1 - cosine), cut.Probe(atChord * 17, atChord), 7);
        Assert.Equal(3 * (1 - (1 / cosine)), cut.Probe(atVertex * 17, atVertex), 7);
        Assert.Equal(Radius * (1 - cosine), cut.Probe(atChord * 23, -atChord), 7);
        Assert.Equal(0, cut.Probe(atVertex * 23, -atVertex), 7);
    }

    [Fact]
    public void Units_and_modes_do_not_change_the_piece()
    {
        var cuts = new[]
        {
            Cut("G0 X0 Y0\nG1 X30.48\nG3 X30.48 Y20.32 I0 J10.16\nG1 X0"),
            Cut("G0 X0 Y0\nG91 G1 X30.48\nG3 X0 Y20.32 I0 J10.16\nG1 X-30.48"),
            Cut("G20 G0 X0 Y0\nG1 X1.2\nG3 X1.2 Y.8 I0 J.4\nG1 X0"),
            Cut("G0 X0 Y0\nG1 X30.48\nG3 Y20.32 R10.16\nG1 X0"),
        };
        foreach (var cut in cuts)
        {
            Assert.Equal(0, cut.Probe(new(15, 3), new(0, -1)), 7);
            Assert.Equal(0, cut.Probe(new(30.48 + 7.16, 10.16), new(1, 0)), 7);
            Assert.Equal(0, cut.Probe(new(30.48 + 13.16, 10.16), new(-1, 0)), 7);
        }
    }

    [Theory]
    [InlineData("G18 G0 Z20 X0\nG3 K-20", WorkPlane.ZX)]
    [InlineData("G19 G0 Y20 Z0\nG3 J-20", WorkPlane.YZ)]
    internal void Other_planes_are_cut_the_same(string program, WorkPlane plane)
    {
        var cut = new VirtualCut(RefereeInterpreter.Run(program), 3, plane);

        Assert.Equal(0, cut.Probe(Flat.Toward(1) * 17, Flat.Toward(1)), 8);
        Assert.Throws<RefereeException>(() => new VirtualCut(RefereeInterpreter.Run(program), 3));
    }

    [Fact]
    public void Compensated_path_is_the_boundary_itself()
    {
        // Counter-clockwise around a boss with the tool outside, that is right of the travel.
        var cut = Cut("G0 X-20 Y-20\nG42 D1 G1 X-10 Y-10\nX10\nG3 X10 Y10 J10\nG1 X-10\nY-10\nG40 X-20 Y-20");

        Assert.Equal(0, cut.Probe(new(0, -10), new(0, -1)), 8);
        Assert.Equal(0.1, cut.Probe(new(0, -9.9), new(0, -1)), 8);
        Assert.Equal(0, cut.Probe(new(20, 0), new(1, 0)), 8);
        Assert.Equal(-0.07, cut.Probe(new Flat(10, 0) + (Flat.Toward(0.3) * 10.07), Flat.Toward(0.3)), 8);
    }

    [Theory]
    [InlineData("G41", 1)]
    [InlineData("G42", -1)]
    public void Tool_on_the_side_of_the_material_is_called_out(string side, double normal)
    {
        var cut = Cut($"G0 X0 Y0\n{side} D1 G1 X100");

        Assert.Equal(0, cut.Probe(new(50, 0), new(0, normal)), 8);
        Assert.Throws<RefereeException>(() => cut.Probe(new(50, 0), new(0, -normal)));
    }

    [Fact]
    public void Rapids_cut_nothing()
    {
        var cut = Cut("G0 X0 Y0\nG1 X100\nG0 X100 Y50\nX0");

        Assert.Equal(47, cut.Clearance(new(50, 50)), 12);
        Assert.Throws<RefereeException>(() => cut.Probe(new(50, 53), new(0, -1)));
    }

    private static VirtualCut Cut(string program) => new(RefereeInterpreter.Run(program), 3);
}
