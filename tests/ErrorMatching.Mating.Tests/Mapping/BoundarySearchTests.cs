using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Mating.Tests;

/// <summary>Blocks are found by the key points that they lead past:
/// those that the paper names, and in programs whose blocks are known by how they were written.</summary>
public sealed class BoundarySearchTests
{
    private const string Depths = "N10 G21 G90 G17\nN20 G0 X0. Y20.\nN30 Z-2.\nN40 G1 X0. Y3. F300\nN50 X50.\nN60 Y20.\nN70 G0 X0.\nN80 "
        + "Z-4.\nN90 G1 Y3.\nN100 X50.\nN110 Y20.\nN120 M30\n";

    private const string Pieces =
        "N10 G21 G90 G17\nN20 G0 X0. Y20.\nN30 G1 X0. Y3. F300\nN40 X10.\nN50 X20.\nN60 X30.\nN70 X40.\nN80 X80.\nN90 Y20.\nN100 M30\n";

    private const string Laps =
        "N10 G21 G90 G17\nN20 G0 X0. Y3.\nN30 G1 X50. F300\nN40 Y30.\nN50 X0.\nN60 Y3.\nN70 X50.\nN80 Y30.\nN90 M30\n";

    [Theory]
    [InlineData("complex-mating", null)]
    [InlineData("complex-mating", 6.0)]
    [InlineData("curve-mating", null)]
    [InlineData("curve-mating", 6.0)]
    public void The_samples_blocks_are_those_of_their_jobs(string sample, double? tool)
    {
        var job = Samples.Job(sample);
        var path = Interpreted(File.ReadAllText(Repository.PathTo("samples", sample, "counterpart.nc")));
        var points = Samples.Points(sample, "theoretical.csv");
        var found = BoundarySearch.Find(
            path,
            [.. job.Features.Select(f => new SoughtBoundary(f.Name, CoordinatePlane.XY, [.. f.Points.Select(p => (p, points[p]))]))],
            tool,
            JobCounterpart.DefaultMapMm);
        Assert.Equal(job.Features.Select(f => Assert.Single(f.Blocks)), found.Select(f => Named(path, Assert.Single(f.Passes))));
        Assert.All(found, f => Assert.Null(f.Refusal));
    }

    [Theory]
    [InlineData(Programs.ToolBelow)]
    [InlineData(Programs.ToolAbove)]
    [InlineData(Programs.CompensatedLeft)]
    [InlineData(Programs.CompensatedRight)]
    public void A_line_is_found_on_either_side_and_under_compensation(string program)
    {
        Assert.Equal(["N50"], Found(program, 6, new(5, 0), new(45, 0)));
        Assert.Equal(["N50"], Found(program, null, new(5, 0), new(45, 0)));

        // Points against the way of cutting.
        Assert.Equal(["N50"], Found(program, 6, new(45, 0), new(5, 0)));
    }

    [Theory]
    [InlineData(Programs.ToolBelow)]
    [InlineData(Programs.CompensatedLeft)]
    public void Points_at_its_corners_do_not_take_the_blocks_beside_it(string program) =>
        Assert.Equal(["N50"], Found(program, 6, new(0, 0), new(50, 0)));

    [Fact]
    public void A_notch_is_found_from_flank_to_flank_with_its_fillet()
    {
        Assert.Equal(["N50..N60"], Found(Programs.Notch, 6, new(3, -4), new(12, -16), new(18, -16), new(27, -4)));
        Assert.Equal(["N50..N60"], Found(Programs.Notch, 6, new(27, -4), new(18, -16), new(12, -16), new(3, -4)));
        Assert.Equal(["N50..N60"], Found(Programs.FilletedNotch, 6, new(3, -4), new(9, -12), new(21, -12), new(27, -4)));
        Assert.Equal(["N50"], Found(Programs.Hill, 6, new(12, 6), new(20, 10), new(28, 6)));
    }

    [Fact]
    public void Each_depth_is_a_pass_of_its_own_and_what_was_roughed_is_none()
    {
        Assert.Equal(["N50", "N100"], Found(Depths, 6, new(5, 0), new(45, 0)));
        var roughed = Depths.Replace("N40 G1 X0. Y3.", "N40 G1 X0. Y3.2", StringComparison.Ordinal);
        Assert.Equal(["N100"], Found(roughed, 6, new(5, 0), new(45, 0)));
        Assert.Equal(["N100"], Found(roughed, null, new(5, 0), new(45, 0)));
    }

    [Fact]
    public void A_boundary_goes_on_behind_its_outermost_point_as_far_as_it_does_not_bend()
    {
        Assert.Equal(["N40..N70"], Found(Pieces, 6, new(12, 0), new(28, 0)));

        // What another boundary needs is left to it.
        var path = Interpreted(Pieces);
        var both = BoundarySearch.Find(path, [Sought("A", new(2, 0), new(18, 0)), Sought("B", new(32, 0), new(78, 0))], 6, 0.5);
        Assert.Equal(["N40..N60", "N70..N80"], both.Select(b => Named(path, Assert.Single(b.Passes))));
    }

    [Fact]
    public void What_does_not_lie_along_a_cut_is_not_found()
    {
        // At another distance, on both sides, aslant, in another plane, a single point, none.
        Assert.Empty(Found(Programs.ToolBelow, 6, new(5, 0.7), new(45, 0.7)));
        Assert.Empty(Found(Programs.ToolBelow, 6, new(5, 0), new(45, -6)));
        Assert.Empty(Found(Programs.ToolBelow, null, new(5, 0), new(45, 2)));
        Assert.Empty(Found(Programs.ToolBelow, 6, new Point2(5, 0)));
        Assert.Empty(Found(Programs.ToolBelow, 6));
        var path = Interpreted(Programs.ToolBelow);
        Assert.Empty(
            Assert.Single(BoundarySearch.Find(
                path, [Sought("A", new(5, 0), new(45, 0)) with { Plane = CoordinatePlane.ZX }], 6, 0.5)).Passes);

        // One boundary twice: nobody can tell whose the block is.
        Assert.All(
            BoundarySearch.Find(path, [Sought("A", new(5, 0), new(45, 0)), Sought("B", new(10, 0), new(40, 0))], 6, 0.5),
            f => Assert.Empty(f.Passes));

        // A cut that passes them twice without a break: there and back, and lap by lap.
        Assert.Empty(Found("N10 G21 G90 G17\nN20 G0 X0. Y3.\nN30 G1 X50. F300\nN40 X0.\nN50 M30\n", 6, new(5, 0), new(45, 0)));
        Assert.Empty(Found(Laps, 6, new(5, 0), new(45, 0)));
        Assert.Equal(["N50"], Found(Laps, 6, new(5, 33), new(45, 33)));
    }

    [Fact]
    public void Why_nothing_was_found_is_said_with_the_block_that_comes_nearest_to_it()
    {
        // N50 leads along y = -3 with a tool of 6 mm: points at y = 0.7 are 3.7 mm away, points at y = -6 on its other side.
        Says(
            Refused(Programs.ToolBelow, 6, new(5, 0), new(45, 0.7)),
            "boundary-not-found",
            "N50",
            7,
            "2",
            "A, N50: of all cuts this is the nearest, and the point 2 lies 3.700 mm from the path; expected 3 mm, one tool radius "
                + "(within 0.5 mm). Check the frame, the tool diameter and the points, or name the blocks yourself.");
        Assert.Equal("3.700 mm", Refused(Programs.ToolBelow, 6, new(5, 0), new(45, 0.7)).Found);
        Says(
            Refused(Programs.ToolBelow, null, new(5, 0), new(45, 2)),
            "boundary-not-found",
            "N50",
            7,
            "1",
            "A, N50: of all cuts this is the nearest, and its points lie 3.000 to 5.000 mm from the path; expected one distance for all "
                + "(within 0.5 mm). Check the frame and the points, or name the blocks yourself.");
        Says(
            Refused(Programs.CompensatedLeft, 6, new(5, 0), new(45, 0.7)),
            "boundary-not-found",
            "N50",
            7,
            "2",
            "A, N50: of all cuts this is the nearest, and the point 2 lies 0.700 mm from the path; expected it on the path, since cutter "
                + "compensation is active (within 0.5 mm). Check the frame, the tool diameter and the points, or name the blocks "
                + "yourself.");
        Says(
            Refused(Programs.ToolBelow, 6, new(5, 0), new(45, -6)),
            "sides-differ",
            "N50",
            7,
            "2",
            "A, N50: the points 1 and 2 lie on different sides of the path, so the material cannot be told. Check the frame and the "
                + "points, or name the blocks yourself.");

        // Of two cuts, 3.2 and 3 mm away from the points, the first comes nearer to the radius of a tool of 10 mm.
        var roughed = Depths.Replace("N40 G1 X0. Y3.", "N40 G1 X0. Y3.2", StringComparison.Ordinal);
        Says(
            Refused(roughed, 10, new(5, 0), new(45, 0)),
            "boundary-not-found",
            "N50",
            5,
            "1",
            "A, N50: of all cuts this is the nearest, and the point 1 lies 3.200 mm from the path; expected 5 mm, one tool radius "
                + "(within 0.5 mm). Check the frame, the tool diameter and the points, or name the blocks yourself.");

        // Lap by lap; there and back again; and points that are named crosswise.
        Says(
            Refused(Laps, 6, new(5, 0), new(45, 0)),
            "boundary-cut-twice",
            "N30",
            3,
            "1",
            "A, N30: this cut passes the point 1 twice without a break, so it cannot be told which of its blocks are meant. Check the "
                + "point, or name the blocks yourself.");
        Says(
            Refused("N10 G21 G90 G17\nN20 G0 X0. Y3.\nN30 G1 X50. F300\nN40 X0.\nN50 M30\n", 6, new(5, 0), new(45, 0)),
            "boundary-not-found",
            "N30",
            3,
            "1",
            "A, N30: this cut does not lead past the points one behind the other, as they are named. Check the points and their order, "
                + "or name the blocks yourself.");
        Says(
            Refused(Pieces, 6, new(12, 0), new(28, 0), new(5, 0)),
            "boundary-not-found",
            "N50",
            5,
            "1",
            "A, N50: this cut does not lead past the points one behind the other, as they are named. Check the points and their order, "
                + "or name the blocks yourself.");

        Says(
            Refused(Programs.ToolBelow, 6, new Point2(5, 0)),
            "boundary-not-found",
            null,
            null,
            null,
            "A: fewer than two of its points have a place in the program. Give them their coordinates, or name the blocks yourself.");
        Says(
            Refused("N10 G21 G90 G17\nN20 M30\n", 6, new(5, 0), new(45, 0)),
            "boundary-not-found",
            null,
            null,
            null,
            "A: the program cuts nothing in the plane XY of which it says where. Check the program and the plane.");

        var shared = BoundarySearch.Find(
            Interpreted(Programs.ToolBelow), [Sought("A", new(5, 0), new(45, 0)), Sought("B", new(10, 0), new(40, 0))], 6, 0.5);
        Says(
            shared[1].Refusal!,
            "blocks-overlap",
            "N50",
            7,
            null,
            "B, N50: from here on it leads past the points of B and of A, so it cannot be told whose blocks these are. Check the points "
                + "of both, or name the blocks yourself.");

        static void Says(Refusal refusal, string code, string? block, int? line, string? point, string message)
        {
            Assert.Equal(message, refusal.Message);
            Assert.Equal((code, block, line, point), (refusal.Code, refusal.Place.Block, refusal.Place.Line, refusal.Place.Point));
            Assert.StartsWith(refusal.Place.Feature!, message, StringComparison.Ordinal);
        }
    }

    private static NcPath Interpreted(string program) =>
        NcInterpreter.Run(NcProgram.Read(Encoding.ASCII.GetBytes(program), NcDialects.DeltaNc300.Syntax), NcDialects.DeltaNc300);

    private static string[] Found(string program, double? tool, params Point2[] points)
    {
        var path = Interpreted(program);
        return [.. Assert.Single(BoundarySearch.Find(path, [Sought("A", points)], tool, 0.5)).Passes.Select(p => Named(path, p))];
    }

    private static Refusal Refused(string program, double? tool, params Point2[] points)
    {
        var found = Assert.Single(BoundarySearch.Find(Interpreted(program), [Sought("A", points)], tool, 0.5));
        Assert.Empty(found.Passes);
        return found.Refusal!;
    }

    private static SoughtBoundary Sought(string name, params Point2[] points) =>
        new(name, CoordinatePlane.XY, [.. points.Select((p, i) => ((i + 1).ToString(CultureInfo.InvariantCulture), p))]);

    private static string Named(NcPath path, FoundPass pass)
    {
        var (first, last) = (Of(pass.First), Of(pass.Last));
        return first == last ? first : $"{first}..{last}";

        string Of(int motion) => path.Program.NumberOf(path.Program[path.Motions[motion].Block]);
    }
}
