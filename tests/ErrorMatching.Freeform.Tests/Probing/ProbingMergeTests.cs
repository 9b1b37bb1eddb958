using System.Text;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

public sealed class ProbingMergeTests
{
    private static readonly string[] SemiFinishing =
    [
        "siemens-840d",
        "; semi-finishing\r\nDEF REAL _DEPTH=1\r\nG54 G17 G90 G710\r\nM3 S10000\r\nG0 X0 Y0 Z30\r\nG1 Z5 F1200\r\nX75\r\nG0 Z30\r\nM5 M9 "
            + "M30\r\n",
        "fanuc",
        "%\nO0001(SEMI)\nG54 G17 G90 G21\nM3 S10000\nG0 X0. Y0. Z30.\nG1 Z5. F1200.\nX75.\nG0 Z30.\nM98 P2\nM30\nO0002\nG0 Z40.\nM99\n%\n",
        "linuxcnc", "G54 G17 G90 G21\nM3 S10000\nG0 X0 Y0 Z30\nG1 Z5 F1200\nX75\nG0 Z30\nM2\n",
        "fanuc-p98xx", "%\nO0001(SEMI)\nG54 G17 G90 G21\nM3 S10000\nG0 X0. Y0. Z30.\nG1 Z5. F1200.\nX75.\nG0 Z30.\nM5\nM30\n%\n",
    ];

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void One_program_cuts_then_measures_then_stops(int which)
    {
        var (name, semi) = (SemiFinishing[which * 2], SemiFinishing[(which * 2) + 1]);
        var probing = Programs.Of(name);
        var merged = probing.MergeAfter(Encoding.UTF8.GetBytes(semi), "semi.nc");
        var path = Programs.Path(merged, probing.Dialect);
        var cut = Programs.Path(Encoding.UTF8.GetBytes(semi), probing.Dialect);
        Assert.Null(path.Refusal);
        Assert.Empty(path.Problems);
        Assert.Equal(cut.Motions.Select(m => (m.Kind, m.End)), path.Motions.Take(cut.Motions.Length).Select(m => (m.Kind, m.End)));
        var alone = Programs.Path(probing.Bytes, probing.Dialect).Motions.Count(m => m.Kind == MotionKind.Probe);
        Assert.InRange(alone, 1, probing.Moves.Touches.Count);
        Assert.Equal(alone, path.Motions.Skip(cut.Motions.Length).Count(m => m.Kind == MotionKind.Probe));

        // The last stop comes behind the last touch: it waits for the finishing program.
        var text = Encoding.UTF8.GetString(merged.Span);
        Assert.True(
            text.LastIndexOf("M0", StringComparison.Ordinal) > Math.Max(
                text.LastIndexOf("[P20", StringComparison.Ordinal), text.LastIndexOf("P20 C", StringComparison.Ordinal)));
    }

    [Fact]
    public void Definitions_go_before_the_first_block_that_does_something()
    {
        var text = Encoding.UTF8.GetString(
            Programs.Of("siemens-840d").MergeAfter(Encoding.UTF8.GetBytes(SemiFinishing[1]), "semi.nc").Span);
        Assert.StartsWith("; semi-finishing\r\nDEF REAL _DEPTH=1\r\nDEF INT _EM_ERR\r\nG54 ", text, StringComparison.Ordinal);
        Assert.DoesNotContain("\n", text.Replace("\r\n", "", StringComparison.Ordinal), StringComparison.Ordinal);
    }

    [Fact]
    public void Subprograms_behind_the_end_stay_behind_it()
    {
        var text = Encoding.UTF8.GetString(Programs.Of("fanuc").MergeAfter(Encoding.UTF8.GetBytes(SemiFinishing[3]), "semi.nc").Span);
        Assert.EndsWith("M30\nO0002\nG0 Z40.\nM99\n%\n", text, StringComparison.Ordinal);
        Assert.Equal(2, text.Split("M30").Length);
    }

    [Theory]
    [InlineData("G68 X0. Y0. R30.\nG0 X5. Y5.\n")]
    [InlineData("G55\nG0 X5. Y5.\n")]
    [InlineData("G52 X10.\n")]
    [InlineData("G52 X10.\nG0 X5. Y5.\n")]
    [InlineData("G41 D1\nG1 X5. Y5. F100.\n")]
    [InlineData("G51.1 X0\nG0 X5. Y5.\n")]
    public void What_is_left_behind_is_noticed_behind_the_probe_makers_calls_as_well(string mode)
    {
        var semi = "G54 G17 G90 G21\nG0 X0. Y0. Z30.\nG1 Z20. F500.\n" + mode + "M30\n";
        foreach (var template in new[] { "fanuc", "fanuc-p98xx" })
        {
            var error = Record.Exception(() => Programs.Of(template).MergeAfter(Encoding.ASCII.GetBytes(semi), "semi.nc"));
            Assert.True(error is InputException { Code: "not-mergeable" }, $"{template}: {mode} {error?.Message}");
        }
    }

    // The Siemens program selects millimeters by G710, which LinuxCNC does not know.
    [Fact]
    public void A_program_for_another_control_is_refused_by_its_block_and_both_are_named()
    {
        var error = Assert.Throws<InputException>(
            () => Programs.Of("linuxcnc").MergeAfter(
                "; semi-finishing\nG54 G17 G90\nG710\nG0 X0 Y0 Z30\nM30\n"u8.ToArray(), "semi.nc", "siemens-840d"));
        Assert.Equal(("not-mergeable", "semi.nc"), (error.Code, error.File));
        Assert.Contains("line 3", error.Message, StringComparison.Ordinal);
        Assert.Contains("G710", error.Message, StringComparison.Ordinal);
        Assert.Contains("siemens-840d", error.Message, StringComparison.Ordinal);
        Assert.Contains("linuxcnc", error.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("G0 Z30\n", "no M2 or M30")]
    [InlineData("G0 Z30\nM30\nM30\n", "2 places")]
    [InlineData("G54 G90\nG0 X0 Y0 Z30\nTRANS X10\nG0 X5\nM30\n", "leaves a rotation, a shift")]
    public void A_program_that_probing_cannot_follow_is_refused(string semi, string reason)
    {
        var error = Assert.Throws<InputException>(() => Programs.Of("siemens-840d").MergeAfter(Encoding.UTF8.GetBytes(semi), "semi.nc"));
        Assert.Equal(("not-mergeable", "semi.nc"), (error.Code, error.File));
        Assert.Contains(reason, error.Message, StringComparison.Ordinal);
    }
}
