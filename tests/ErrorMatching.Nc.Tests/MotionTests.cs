using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc.Tests;

/// <summary>What programs do; expected motions are worked out by hand.</summary>
public sealed class MotionTests
{
    [Fact]
    public void Modal_words_carry_on_from_block_to_block()
    {
        var path = Bench.Read("G90 G21 G17\nG0 X1 Y2 Z3\nG1 Z-1 F200\nX5\nM8\nY7\nG0 Z10\n");
        Assert.Equal([new(1, 2, 3), new(1, 2, -1), new(5, 2, -1), new(5, 7, -1), new Point3(5, 7, 10)], Ends(path));
        Assert.Equal([MotionKind.Rapid, MotionKind.Line, MotionKind.Line, MotionKind.Line, MotionKind.Rapid], Kinds(path));
        Assert.Equal([1, 2, 3, 5, 6], path.Motions.ToArray().Select(m => m.Block));
        Assert.Equal([0, 200, 200, 200, 200], path.Motions.ToArray().Select(m => m.Feed));
    }

    [Fact]
    public void Increments_add_up_without_drift()
    {
        var path = Bench.Read("G90 G0 X0 Y0 Z0\nG91\n" + string.Concat(Enumerable.Repeat("G1 X0.1 Y-0.3\n", 10_000)));
        Assert.Equal(new Point3(1000, -3000, 0), path.Motions[^1].End);
    }

    [Theory]
    [InlineData("G17", "G2 X10 Y10 I10 J0", "X0 Y0", 10, 0, -90)]
    [InlineData("G17", "G3 X10 Y10 I0 J10", "X0 Y0", 0, 10, 90)]
    [InlineData("G17", "G3 X10 Y10 R10", "X0 Y0", 0, 10, 90)]
    [InlineData("G17", "G2 X10 Y10 R10", "X0 Y0", 10, 0, -90)]
    [InlineData("G17", "G2 X10 Y10 R-10", "X0 Y0", 0, 10, -270)]
    [InlineData("G17", "G3 X10 Y10 R-10", "X0 Y0", 10, 0, 270)]
    [InlineData("G17", "G3 I5", "X0 Y0", 5, 0, 360)]
    [InlineData("G17", "G2 X0 Y0 I5 J0", "X0 Y0", 5, 0, -360)]
    [InlineData("G18", "G3 Z10 X10 K0 I10", "X0 Z0", 0, 10, 90)]
    [InlineData("G18", "G2 Z10 X10 R10", "X0 Z0", 10, 0, -90)]
    [InlineData("G19", "G3 Y10 Z10 J0 K10", "Y0 Z0", 0, 10, 90)]
    [InlineData("G19", "G2 Y10 Z10 R10", "Y0 Z0", 10, 0, -90)]
    public void Arcs_have_their_center_and_sweep_in_each_plane(string plane, string arc, string start, double cx, double cy, double degrees)
    {
        var rest = new[] { "X0", "Y0", "Z0" }.Aggregate(start, (s, zero) => s.Replace(zero, "", StringComparison.Ordinal));
        var path = Bench.Read($"G90 G21 {plane}\nG0 X0 Y0 Z0 {rest}\n{arc} F100\n");
        Assert.Empty(path.Problems);
        var motion = path.Motions[^1];
        Assert.Equal(0, motion.Center.DistanceTo(new(cx, cy)), 1e-12);
        Assert.Equal(degrees, motion.Arc.Sweep.Degrees, 1e-9);
    }

    [Fact]
    public void Helix_moves_along_its_axis_and_turns_as_often_as_it_says()
    {
        var path = Bench.Read("G90 G21 G17\nG0 X10 Y0 Z0\nG3 X10 Y0 Z-3 I-10 J0 P3 F100\n", NcDialects.LinuxCnc);
        var helix = path.Motions[^1];
        Assert.Equal((2, -3.0), (helix.Turns, helix.End.Z));
        Assert.Equal(1080, helix.Arc.Sweep.Degrees, 1e-9);
    }

    [Fact]
    public void Full_circle_behind_increments_is_full()
    {
        // 0.1 + 0.2 is not 0.3 in binary; the circle must not become an arc of 1e-17 mm.
        var path = Bench.Read("G90 G17 G0 X0 Y0\nG91 X0.1\nX0.2\nG90 G3 X0.3 Y0 I5 F100\n");
        Assert.Equal(360, path.Motions[^1].Arc.Sweep.Degrees, 1e-9);
    }

    [Fact]
    public void Absolute_centers_are_places()
    {
        var path = Bench.Read("G90 G17 G90.1\nG0 X10 Y0\nG3 X0 Y10 I0 J0\nG91.1\nG3 X-10 Y0 I0 J-10\n", NcDialects.LinuxCnc);
        Assert.Equal(Point2.Origin, path.Motions[1].Center);
        Assert.Equal(Point2.Origin, path.Motions[2].Center);
    }

    [Fact]
    public void Inches_become_millimetres()
    {
        var path = Bench.Read("G20 G90 G0 X1 Y0\nG3 X0 Y1 I-1 J0 F2\nG21 G1 X5\n");
        Assert.Equal([new(25.4, 0, 0), new(0, 25.4, 0), new Point3(5, 25.4, 0)], Ends(path));
        Assert.Equal(50.8, path.Motions[1].Feed, 1e-12);
        Assert.Equal(Point2.Origin, path.Motions[1].Center);
    }

    [Fact]
    public void What_was_not_stated_is_unknown_until_it_is()
    {
        var path = Bench.Read("G90 G0 X1\nY2 Z3\n");
        Assert.Equal((AxisSet.All, AxisSet.Y | AxisSet.Z), (path.Motions[0].UnknownStart, path.Motions[0].UnknownEnd));
        Assert.Equal(AxisSet.None, path.Motions[1].UnknownEnd);
    }

    [Fact]
    public void Work_offset_change_forgets_the_position_and_counts_a_frame()
    {
        var path = Bench.Read("G54 G90 G0 X1 Y2 Z3\nG54 G1 X2\nG55 X3\n");
        Assert.Equal([0, 0, 1], path.Motions.ToArray().Select(m => m.Frame));
        Assert.Equal(AxisSet.Y | AxisSet.Z, path.Motions[2].UnknownEnd);
    }

    [Fact]
    public void Setting_the_origin_renames_the_place_and_moves_nothing()
    {
        var path = Bench.Read("G90 G0 X10 Y20 Z30\nG92 X0 Y0\nG91 G1 X1 Y1 F100\n");
        Assert.Equal(2, path.Motions.Length);
        Assert.Equal((new Point3(0, 0, 30), new Point3(1, 1, 30), 1), (path.Motions[1].Start, path.Motions[1].End, path.Motions[1].Frame));
    }

    [Fact]
    public void Reference_return_and_machine_coordinates_end_at_an_unknown_place()
    {
        var path = Bench.Read("G90 G0 X1 Y2 Z3\nG91 G28 Z0\nG90 G53 G0 X0\nX5\n");
        Assert.Equal([MotionKind.Rapid, MotionKind.Reference, MotionKind.Reference, MotionKind.Rapid], Kinds(path));
        Assert.Equal([AxisSet.None, AxisSet.Z, AxisSet.X | AxisSet.Z, AxisSet.Z], path.Motions.ToArray().Select(m => m.UnknownEnd));
        Assert.Equal(new Point3(5, 2, 0), path.Motions[3].End);
    }

    [Fact]
    public void Canned_cycles_last_until_they_are_canceled()
    {
        var path = Bench.Read("G90 G0 X0 Y0 Z5\nG98 G81 X1 Y1 Z-5 R2 F100\nX2\nG80\nG0 Z6\nX3\n");
        Assert.Equal(
            [
                new(0, 0, 5), new(1, 1, 5), new(1, 1, 2), new(1, 1, -5), new(1, 1, 5), new(2, 1, 5), new(2, 1, 2), new(2, 1, -5),
                new(2, 1, 5), new(2, 1, 6), new(3, 1, 6)],
            Ends(path));
        Assert.Equal([MotionKind.Rapid, MotionKind.Rapid, MotionKind.Line, MotionKind.Rapid], Kinds(path)[1..5]);
        Assert.Equal([1, 1, 1, 1, 2, 2, 2, 2], path.Motions.Where(m => m.Has(MotionFlags.Cycle)).Select(m => m.Block));
        Assert.Equal([5, 6, 7, 8], path.MotionsOf(2).ToArray());
    }

    [Theory]
    [InlineData("G187 P1")]
    [InlineData("CYCLE800(1)")]
    public void Calls_and_unknown_codes_make_place_and_modes_unsure_until_stated_again(string block)
    {
        var path = Bench.Read($"G90 G17 G40 G0 X0 Y0 Z0\n{block}\nX1\nG90 G17 G40 G1 X2 Y2 Z2\n");
        Assert.True(path.Motions[1].Has(MotionFlags.UnsureMode));
        Assert.Equal(AxisSet.Y | AxisSet.Z, path.Motions[1].UnknownEnd);
        Assert.False(path.Motions[2].Has(MotionFlags.UnsureMode));
        Assert.Equal(AxisSet.None, path.Motions[2].UnknownEnd);
    }

    [Theory]
    [InlineData("G1 X1 E5", "unknown-word")]
    [InlineData("G1 X1 $", "unknown-word")]
    [InlineData("G77 X1", "unknown-code")]
    [InlineData("G1 X1 X2", "repeated-word")]
    [InlineData("G2 X10 Y0 I3 J0", "bad-arc")]
    [InlineData("G2 X10 Y0 R3", "bad-arc")]
    [InlineData("G2 X10 Y0", "bad-arc")]
    [InlineData("G2 X0 Y0 R3", "bad-arc")]
    public void What_is_not_understood_is_reported_with_its_block(string block, string code)
    {
        var problem = Assert.Single(Bench.Read("G90 G17 G0 X0 Y0 Z0\n" + block + "\n").Problems);
        Assert.Equal((code, 1), (problem.Code, problem.Block));
    }

    [Fact]
    public void Compensation_switches_with_the_first_motion_in_the_plane()
    {
        var path = Bench.Read("G90 G17 G0 X0 Y0 Z0\nG41 D1\nG1 Z-1 F100\nX1\nX2\nG40\nG0 Z5\nX9\n");
        Assert.Equal([3, 7], path.Motions.ToArray().Where(m => m.Has(MotionFlags.CompensationSwitches)).Select(m => m.Block));
        Assert.Equal([2, 3, 4], path.Motions.ToArray().Where(m => m.Has(MotionFlags.CompensationLeft)).Select(m => m.Block));
    }

    [Fact]
    public void Skippable_blocks_are_executed_and_the_program_ends_where_it_says()
    {
        var path = Bench.Read("G90 G0 X1\n/X2\nM30\nX3\n", NcDialects.Generic.With(BlockSkip.Off));
        Assert.Equal([1, 2], path.Motions.ToArray().Select(m => (int)m.End.X));
        Assert.Equal(1, Bench.Read("G0 X1\nM02.\nX3\n").Motions.Length);
    }

    [Theory]
    [InlineData("#5221=10.", AxisSet.All, 1)]
    [InlineData("#[5220+1]=10.", AxisSet.All, 1)]
    [InlineData("#100=10.", AxisSet.None, 0)]
    public void Assigning_a_variable_of_the_control_can_change_its_offsets(string block, AxisSet unknown, int frame)
    {
        var path = Bench.Read($"G90 G0 X0 Y0 Z0\n{block}\nG91 X1\n");
        Assert.Equal((unknown, frame), (path.Motions[1].UnknownEnd, path.Motions[1].Frame));
    }

    [Theory]
    [InlineData("generic", "G68 X0 Y0 R30", "G69")]
    [InlineData("fanuc", "G51.1 X0", "G50.1")]
    [InlineData("fanuc", "G16", "G15")]
    [InlineData("fanuc", "G43.4 H1", "G49")]
    public void Rotation_scaling_and_the_like_flag_every_motion_until_they_end(string dialect, string on, string off)
    {
        var path = Bench.Read($"G90 G0 X0 Y0 Z0\n{on}\nX1\n{off}\nX2 Y2 Z2\n", NcDialects.Named(dialect));
        Assert.Equal([false, true, false], path.Motions.ToArray().Select(m => m.Has(MotionFlags.Transformed)));
    }

    [Fact]
    public void Waits_and_limits_move_nothing_although_they_have_axis_words()
    {
        Assert.Equal(1, Bench.Read("G0 X0 Y0\nG4 X2.\nG22 X100. Y100. Z100. I0. J0. K0.\n", NcDialects.FanucMill).Motions.Length);
    }

    [Fact]
    public void Unknown_dialect_is_an_error_that_lists_the_known()
    {
        var error = Assert.Throws<InputException>(() => NcDialects.Named("fanuk"));
        Assert.Equal(NcInputCodes.UnknownDialect, error.Code);
        Assert.Contains(string.Join(", ", NcDialects.Names), error.Message, StringComparison.Ordinal);
        Assert.All(NcDialects.All, d => Assert.Same(d, NcDialects.Named(d.Name)));
        Assert.All(NcDialects.All, d => Assert.All(d.Facts, f => Assert.NotEmpty(f.Source)));
    }

    private static Point3[] Ends(NcPath path) => [.. path.Motions.ToArray().Select(m => m.End)];

    private static MotionKind[] Kinds(NcPath path) => [.. path.Motions.ToArray().Select(m => m.Kind)];
}
