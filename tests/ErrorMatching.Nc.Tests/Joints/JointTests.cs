using ErrorMatching.Testing;

namespace ErrorMatching.Nc.Tests;

/// <summary>Which motions share a joint with the named ones: those that are connected in the cut, and positioning. Expected words are worked out by hand.</summary>
public sealed class JointTests
{
    [Theory]
    [InlineData("other-tool", "G0 X0.1 Y30.", "N4 Y20.1")]
    [InlineData("z-step-at-corner", "N2 X9.9 F100.", "N3 Y9.9")]
    public void Elements_take_only_what_is_connected_along(string program, params string[] changed)
    {
        string[] named = program == "other-tool" ? ["N4", "N5"] : ["N3", "N5"];
        OnlyTheseChange(program, p => DisplacementWish.Normal(p, Bench.Blocks(p, named), 0.1), changed);
    }

    [Theory]
    [InlineData("g53-home")]
    [InlineData("g28-home")]
    public void Way_to_a_place_of_the_machine_begins_where_the_retract_now_ends(string program) =>
        OnlyTheseChange(program, p => DisplacementWish.EndsBy(p, Bench.Blocks(p, "N2"), new(0.1, 0.2, 0)), "N2 X10.1 Y10.2");

    // Each changed line takes the place of the one that begins with the same word and has as many, the first such.
    private static void OnlyTheseChange(string program, Func<NcPath, NcOutcome<DisplacementWish>> wished, params string[] changed)
    {
        var text = File.ReadAllText(Repository.PathTo("tests", "ErrorMatching.Nc.Tests", "Joints", program + ".nc"));
        var path = Bench.Read(text, NcDialects.Named("fanuc"));
        var (was, now) = (text.Split('\n'), Bench.Displaced(path, wished).Split('\n'));
        Assert.Equal(was.Length, now.Length);
        Assert.Equal(changed, now.Where((line, i) => line != was[i]));
    }
}
