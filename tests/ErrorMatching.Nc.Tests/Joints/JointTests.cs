using System.Text;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Nc.Tests;

/// <summary>
/// Which motions share a joint with the named ones: those that are connected in the cut, and positioning.
/// Expected words are worked out by hand.
/// </summary>
public sealed class JointTests
{
    [Theory]
    [InlineData("other-tool", "G0 X0.1 Y30.", "N4 Y20.1")]
    [InlineData("z-step-at-corner", "N2 X9.9 F100.", "N3 Y9.9")]
    public void Elements_take_only_what_is_connected_along(string program, params string[] changed)
    {
        string[] named = program == "other-tool" ? ["N4", "N5"] : ["N3", "N5"];
        Assert.Equal(changed, ChangedLines(Program(program), p => DisplacementWish.Normal(p, Bench.Blocks(p, named), 0.1)));
    }

    [Theory]
    [InlineData("g53-home")]
    [InlineData("g28-home")]
    public void Way_to_a_place_of_the_machine_begins_where_the_retract_now_ends(string program) =>
        Assert.Equal(["N2 X10.1 Y10.2"], ChangedLines(Program(program), SecondEnd));

    [Theory]
    [InlineData("G53 Y0.\nG0 Y5. Z2.", "G0 X10. Y5. Z2.")]
    [InlineData("G53 Y0.\nG0 X5. Y5.")]
    [InlineData("G53 X0. Y0.\nG0 X5. Y5.")]
    [InlineData("G91 G28 Y0.\nG0 X5.\nG90", "G0 X4.9")]
    [InlineData("G91 G28 X0. Y0.\nG90 G0 X0. Y0.")]
    [InlineData("G28 Y20.\nG0 Y5.", "G0 X10. Y5.")]
    [InlineData("G28 X20. Y20.\nG0 X5. Y5.")]
    [InlineData("G30 Y20.\nG0 Y5.", "G0 X10. Y5.")]
    public void First_motion_behind_the_way_home_ends_where_it_did(string home, params string[] changed)
    {
        var text = $"G21 G90 G54\nG0 X0. Y0. Z5.\nG1 Z-1. F50.\nN1 X10. F100.\nN2 Y10.\nG0 Z5.\n{home}\nM30\n";
        Assert.Equal(["N2 X10.1 Y10.2", .. changed], ChangedLines(text, SecondEnd));
    }

    [Theory]
    [InlineData("G0 Z5.\nG0 X10. Y0.\nG1 Z-1.", "N3", "G0 X10. Y0.1", "N3 G1 X20. Y10.05")]
    [InlineData("G0 Z5.\nG0 X10. Y0.\nG1 Z-1.", "N2", "G0 X0. Y0.1 Z5.", "N2 X10. Y0.1")]
    [InlineData("G0 Z5.\nG91 G28 Z0.\nG90 T2 M6\nG0 X10. Y0.\nG43 H2 Z5.\nG1 Z-1.", "N3", "G0 X10. Y0.1", "N3 G1 X20. Y10.05")]
    [InlineData("T2 M6\nG0 X10. Y0.\nG43 H2 Z5.\nG1 Z-1.", "N3", "G0 X10. Y0.1", "N3 G1 X20. Y10.05")]
    [InlineData("G0 Z5.\nG0 X10. Y0. Z2.\nG0 Z1.\nG1 Z-1.", "N3", "G0 X10. Y0.1 Z2.", "N3 G1 X20. Y10.05")]
    [InlineData("G0 Z5.\nG0 X10.\nG0 Y0.\nG1 Z-1.", "N3", "G0 Y0.1", "N3 G1 X20. Y10.05")]
    [InlineData("G1 Z-2.", "N3", "N2 X10. Y0.1", "N3 G1 X20. Y10.05")]
    public void Rapid_with_coordinates_of_its_own_leads_across(string between, string named, params string[] changed) =>
        Assert.Equal(changed, ChangedLines(TwoCuts(between), p => Moved(p, named)));

    [Theory]
    [InlineData("G0 Z5.\nG1 Z-1.")]
    [InlineData("G0 X10. Y0. Z5.\nG1 Z-1.")]
    [InlineData("G0 Z5.\nG0 Z2.\nG1 Z-1.")]
    [InlineData("G0 Z5.\nG91 G28 Z0.\nG90 T2 M6\nG43 H2 G0 Z5.\nG1 Z-1.")]
    [InlineData("T2 M6")]
    [InlineData("T2 M6\nG1 Z-2.")]
    public void Without_such_a_rapid_nothing_is_moved(string between)
    {
        foreach (var named in (string[])["N2", "N3"])
        {
            var path = Bench.Read(TwoCuts(between), NcDialects.Named("fanuc"));
            var refusal = Bench.Refused(Rewriter.Apply(path, Bench.Usable(Moved(path, named))));
            Assert.Equal(NcRefusalCodes.NoPositioning, refusal.Code);
        }
    }

    [Theory]
    [InlineData("other-tool", "N3 X0. Y30.", "N3 X0.1 Y30.")]
    [InlineData("other-tool", "G0 X0.1 Y30.", "G0 X0. Y30.")]
    [InlineData("other-tool", "G0 Z50.", "G0 X0.1 Z50.")]
    [InlineData("other-tool", "G43 H2 Z5.", "G43 H2 X0. Z5.")]
    [InlineData("z-step-at-corner", "N4 Z-2.", "N4 Y10. Z-2.")]
    [InlineData("z-step-at-corner", "N3 Y9.9", "N3 Y10.")]
    [InlineData("g53-home", "G53 Y0.", "G53 X10. Y0.")]
    [InlineData("g28-home", "G28 Y0.", "G28 X-0.1 Y0.")]
    public void Proof_finds_a_joint_that_went_along_or_stayed_behind(string program, string line, string tampered)
    {
        var path = Bench.Read(Program(program), NcDialects.Named("fanuc"));
        var wish = Bench.Usable(program switch
        {
            "other-tool" => DisplacementWish.Normal(path, Bench.Blocks(path, "N4", "N5"), 0.1),
            "z-step-at-corner" => DisplacementWish.Normal(path, Bench.Blocks(path, "N3", "N5"), 0.1),
            _ => SecondEnd(path),
        });
        var good = Bench.Text(Bench.Rewritten(path, wish).Program);
        var bad = good.Replace(line + "\n", tampered + "\n", StringComparison.Ordinal);
        Assert.NotEqual(good, bad);
        Assert.False(Prover.Check(path, NcProgram.Read(Encoding.ASCII.GetBytes(bad)), wish, 0.001).Holds);
    }

    private static Outcome<DisplacementWish> SecondEnd(NcPath path) =>
        DisplacementWish.EndsBy(path, Bench.Blocks(path, "N2"), new(0.1, 0.2, 0));

    private static string Program(string name) =>
        File.ReadAllText(Repository.PathTo("tests", "ErrorMatching.Nc.Tests", "Joints", name + ".nc"));

    // N3 begins where N2 ends, behind whatever is between.
    private static string TwoCuts(string between) =>
        $"G21 G90 G17 G54\nT1 M6\nG0 X0. Y0. Z5.\nG1 Z-1. F100\nN2 X10. Y0.\n{between}\nN3 G1 X20. Y10.\nG0 Z50.\nM30\n";

    // The line of N2 by 0.1 to the left, or that of N3 by as much at its start and half of it at its end.
    private static Outcome<DisplacementWish> Moved(NcPath path, string named)
    {
        var motion = path.MotionOf(Bench.Blocks(path, named)[0]);
        var end = named == "N2" ? 0.1 : 0.05;
        return DisplacementWish.OfElements([new(motion, new(0, 0.1), new(0, (0.1 + end) / 2), new(0, end))]);
    }

    private static IEnumerable<string> ChangedLines(string text, Func<NcPath, Outcome<DisplacementWish>> wished)
    {
        var (was, now) = (text.Split('\n'), Bench.Displaced(Bench.Read(text, NcDialects.Named("fanuc")), wished).Split('\n'));
        Assert.Equal(was.Length, now.Length);
        return now.Where((line, i) => line != was[i]);
    }
}
