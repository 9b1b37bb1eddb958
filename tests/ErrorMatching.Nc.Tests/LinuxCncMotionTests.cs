using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>
/// Motions of LinuxCNC programs: origins that turn, tool lengths, stored places, cycles, and what this control does otherwise than one
/// would think. The expected values are worked out by hand, and rs274 of LinuxCNC 2.9 prints the same.
/// </summary>
public sealed class LinuxCncMotionTests
{
    private const string Head = "G21 G90 G49 G92.1\nG10 L2 P1 X0 Y0 Z0 R0\nG10 L2 P2 X0 Y0 Z0 R0\nG54 G0 X0 Y0 Z10 F100\n";

    [Theory]
    [InlineData("G10 L2 P1 X5 Y5 Z5\nG91 G1 X1 Y1 Z1", "-4 -4 6")]
    [InlineData("G10 L2 P2 X1 Y2 Z3 R30\nG55\nG91 G1 X1 Y1 Z1", "-0.866 -0.2321 8")]
    [InlineData("G10 L2 P2 X1 Y2 R90\nG55\nG91 G0 X0", "-2 1 10")]
    [InlineData("G10 L2 P1 R90\nG0 X3\nG54\nG91 G0 X1\nG10 L2 P1 R0\nX1", "3 0 10|4 0 10|1 4 10")]
    [InlineData("G10 L2 P1 R90\nG10 L20 P1 X3 Y3\nG91 G0 X1\nG55 X0", "4 3 10|0 1 10")]
    [InlineData("G10 L2 P2 R90\nG10 L20 P2 X3 Y4\nG55\nG91 G0 X1", "4 4 10")]
    public void Work_offsets_that_the_program_has_written_are_known_with_their_rotation(string text, string ends) => Ends(ends, text);

    [Theory]
    [InlineData("G43.1 Z5\nG91 G1 Z1\nG49\nZ1", "0 0 6|0 0 12")]
    [InlineData("G43.1 X1 Z5\nG91 G0 X0\nG43.1 Z6\nX0\nG49\nX0", "-1 0 5|-1 0 4|0 0 10")]
    [InlineData("G10 L2 P1 R90\nG43.1 X1 Y2 Z5\nG91 G0 X0\nG90 G53 G0 X1 Y1 Z1", "-2 1 5|-1 0 -4")]
    [InlineData("G43 H1\nG0 Z7\nG49\nG91 Z1", "0 0 7|0 0 ?")]
    [InlineData("G43.1 Z5\nG20\nG49\nG91 G0 X0", "0 0 ?")]
    [InlineData("G43 H1\nG43.1 Z5\nG91 G0 X0", "0 0 ?")]
    [InlineData("G43 H1\nG53 G0 X1 Z0", "1 0 ?")]
    public void A_tool_length_that_the_program_states_moves_its_tip(string text, string ends) => Ends(ends, text);

    [Theory]
    [InlineData("G10 L2 P1 X5\nG53 G0 Z0\nG53 G1 X1", "-5 0 0|-4 0 0")]
    [InlineData("G92 X7\nG53 G0 X1", "8 0 10")]
    [InlineData("G10 L2 P1 R90\nG53 G0 X1", "0 -1 10")]
    [InlineData("G28.1\nG0 X5\nG28", "5 0 10|5 0 10|0 0 10")]
    [InlineData("G28.1\nG0 X5 Y5\nG91 G28 X1", "5 5 10|6 5 10|0 5 10")]
    [InlineData("G30.1\nG55\nG92 X4\nG0 X5\nG30", "5 0 10|5 0 10|4 0 10")]
    [InlineData("G28.1\nG10 L2 P1 R90\nG0 X5 Y6\nG28 X9", "5 6 10|9 6 10|0 6 10")]
    [InlineData("G28\nX1", "0 0 10|? ? ?|1 ? ?")]
    [InlineData("G28.1\n#5161=3\nG0 X0 Y0 Z0\nG28", "0 0 0|0 0 0|? ? ?")]
    public void Places_of_the_machine_are_known_as_far_as_the_program_has_set_them(string text, string ends) => Ends(ends, text);

    [Theory]
    [InlineData("G92 X1 Y1\nG92.2\nG91 G0 X0\nG92.3\nX0", "0 0 10|1 1 10")]
    [InlineData("G92 X1 Y1\nG92.1\nG92.3\nG91 G0 X0", "0 0 10")]
    [InlineData("G92 X1 Y1\nG92.2\nG92 X7\nG92.2\nG92.3\nG91 G0 X0", "7 0 10")]
    [InlineData("G52 X3\nG92.2\nG92.3\nG91 G0 X0", "-3 0 10")]
    public void A_shift_that_is_suspended_comes_back_and_one_that_is_cleared_does_not(string text, string ends) => Ends(ends, text);

    [Fact]
    public void A_shift_that_an_earlier_program_left_is_not_known() =>
        Assert.Equal("? ? ?", Shown(Bench.Read("G21 G90 G0 X0 Y0 Z0\nG92.3\nG91 G0 X0\n", NcDialects.LinuxCnc), 1));

    [Theory]
    [InlineData("G0 X0 Y0 Z10\nG10 L2 P1 X5\nG91 G0 X0 Z1", "? ? 11")]
    [InlineData("G10 L2 P1 X5 Z5\nG0 X0 Y0 Z10\nG10 L2 P1 X6 Z7\nG91 G0 X0", "? ? 8")]
    [InlineData("G10 L2 P1 X5 Z5\nG0 X0 Y0 Z10\nG10 L2 P1 X5 Z7\nG91 G0 X0", "0 0 8")]
    [InlineData("G10 L2 P1 X0 Y0 Z0 R0\nG10 L2 P2 X1 Y1 Z1\nG54 G0 X0 Y0 Z10\nG55\nG91 G0 X0", "? ? 9")]
    public void A_rotation_that_only_the_machine_knows_leaves_no_difference_in_the_plane(string text, string ends)
    {
        var path = Bench.Read("G21 G90\n" + text + "\n", NcDialects.LinuxCnc);
        Assert.Equal(ends, Shown(path, path.Motions.Length - 1));
    }

    [Fact]
    public void A_frame_names_its_rotation()
    {
        var frames = Run("G10 L2 P1 R30\nG55\nG56").Frames;
        Assert.Equal([0, 30, 0, null], frames.TakeLast(4).Select(f => f.Rotation));
    }

    [Theory]
    [InlineData("G98 G81 X1 Y1 Z-1 R2 L2", "1 1 10|1 1 2|1 1 -1|1 1 10|1 1 10|1 1 2|1 1 -1|1 1 10")]
    [InlineData("G99 G81 X1 Z-1 R2\nX2 R5\nG98 X3", "1 0 10|1 0 2|1 0 -1|1 0 2|2 0 5|2 0 -1|2 0 5|3 0 10|3 0 5|3 0 -1|3 0 10")]
    [InlineData("G0 Z0\nG98 G81 X1 Z-1 R2\nX3\nR1 X4", "0 0 0|0 0 2|1 0 2|1 0 -1|1 0 2|1 0 2|3 0 2|3 0 -1|3 0 2|3 0 1|4 0 1|4 0 -1|4 0 1")]
    [InlineData("G81 X1 Z-1 R2", "1 0 10|1 0 2|1 0 -1|1 0 2")]
    [InlineData("G98 G85 X1 Z-1 R2\nG99 G89 X2 P0", "1 0 10|1 0 2|1 0 -1|1 0 2|1 0 10|2 0 10|2 0 2|2 0 -1|2 0 2")]
    [InlineData("G98 G84 X1 Z-1 R2", "1 0 10|1 0 2|1 0 -1|1 0 10")]
    [InlineData("G91 G99 G81 X1 Z-3 R-2 L2", "1 0 10|1 0 8|1 0 5|1 0 8|2 0 8|2 0 5|2 0 8")]
    public void Cycles_have_a_motion_for_each_step_even_where_it_leads_nowhere(string text, string ends) => Ends(ends, text);

    [Fact]
    public void Tapping_outside_the_plane_XY_is_not_followed()
    {
        var path = Run("G19 G98 G84 Y3 Z-2 X-15 R2");
        Assert.Equal((MotionKind.Cycle, AxisSet.All), (path.Motions[1].Kind, path.Motions[1].UnknownEnd));
        Assert.Contains(path.Problems, p => p.Code == "tap-plane");
    }

    [Theory]
    [InlineData("G0 @2 ^90", "0 2 10")]
    [InlineData("G0 X3 Y4\n@10\n^0\nG91 ^90 Z1", "3 4 10|6 8 10|10 0 10|0 10 11")]
    [InlineData("G0 X2\nG20 G91 @1", "2 0 10|27.4 0 10")]
    [InlineData("G0 X2\n#1=45\nG91 ^[#1*2]", "2 0 10|0 2 10")]
    [InlineData("G0 X2\nG91 G99 G81 ^90 R-9 Z-1 L2", "2 0 10|0 2 10|0 2 1|0 2 0|0 2 1|-2 0 1|-2 0 0|-2 0 1")]
    public void Polar_words_are_a_distance_and_an_angle_about_the_origin(string text, string ends) => Ends(ends, text);

    [Fact]
    public void A_block_with_polar_words_is_not_displaced() =>
        Assert.Equal(
            NcRefusalCodes.ActiveTransform,
            Bench.RefusedBy(Head + "N10 G1 X5\nN20 @8 ^0\nN30 X20\n", new Vector3(0.1, 0, 0), "N20", NcDialects.LinuxCnc).Code);

    [Fact]
    public void A_thread_is_a_straight_cut_that_is_not_displaced()
    {
        const string Text = Head + "N10 G33 Z-5 K1\nN20 G0 X20\n";
        Assert.Equal(MotionKind.Line, Bench.MotionOf(Bench.Read(Text, NcDialects.LinuxCnc), "N10").Kind);
        Assert.Equal(NcRefusalCodes.NotASimpleMove, Bench.RefusedBy(Text, new Vector3(0, 0, 0.1), "N10", NcDialects.LinuxCnc).Code);
    }

    [Theory]
    [InlineData("G4 P1 G0 X5", "5 0 10")]
    [InlineData("G0 X1\nG0\nG1\nX2", "1 0 10|1 0 10|1 0 10|2 0 10")]
    [InlineData("G20 F60 G1 X1", "25.4 0 10")]
    public void Rare_blocks_move_as_the_control_moves(string text, string ends) => Ends(ends, text);

    [Fact]
    public void The_feed_of_a_block_is_taken_before_its_units() => Assert.Equal(60, Run("G20 F60 G1 X1").Motions[1].Feed);

    [Fact]
    public void A_break_out_of_a_while_loop_still_counts_at_the_next_do_loop()
    {
        var path = Run(
            "#1=0\no1 while [#1 LT 5]\n#1=[#1+1]\no2 if [#1 GT 1]\no1 break\no2 endif\no1 endwhile\n#1=0\no3 do\nG0 X#1\n#1=[#1+1]\no3 "
                + "while [#1 LT 3]\n#1=0\no4 do\nG0 Y#1\n#1=[#1+1]\no4 while [#1 LT 3]");
        Assert.Equal(["0 0 10", "0 0 10", "0 1 10", "0 2 10"], Shown(path)[1..]);
        Assert.Single(path.Notes, n => n.Code == "loop-left");
    }

    [Fact]
    public void What_runs_unseen_can_have_written_and_chosen_other_offsets()
    {
        var path = Run("G187\nG90 G0 X0 Y0 Z0\nG54\nG91 G0 X0\nG90 X0 Y0 Z0\nG53 G0 X1\nG28");
        Assert.Equal(["? ? ?", "? ? 0"], new[] { Shown(path, 2), Shown(path, 4) });
    }

    private static NcPath Run(string text) => Bench.Read(Head + text + "\n", NcDialects.LinuxCnc);

    private static void Ends(string ends, string text) => Assert.Equal(ends.Split('|'), Shown(Run(text))[1..]);

    private static string[] Shown(NcPath path) => [.. Enumerable.Range(0, path.Motions.Length).Select(i => Shown(path, i))];

    private static string Shown(NcPath path, int index)
    {
        var (end, unknown) = (path.Motions[index].End, path.Motions[index].UnknownEnd);
        return $"{One(AxisSet.X, end.X)} {One(AxisSet.Y, end.Y)} {One(AxisSet.Z, end.Z)}";

        string One(AxisSet axis, double value) =>
            (unknown & axis) != AxisSet.None ? "?" : (Math.Round(value, 4) + 0.0).ToString(CultureInfo.InvariantCulture);
    }
}
