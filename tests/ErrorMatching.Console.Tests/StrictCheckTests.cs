using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

public sealed class StrictCheckTests
{
    private const string Understood = "G90 G17 G40 G0 X0. Y0. Z0.\nN10 G1 X10. F100\nM30\n";

    [Theory]
    [InlineData("fanuc", "", 0, "Everything is understood.")]
    [InlineData("fanuc", "G0 G53 Z0.\n", 0, "Everything is understood. Where 1 of 3 motions end, only the machine knows.")]
    [InlineData("fanuc", "G187 P1\n", 2, "1 of 4 blocks is not understood.")]
    [InlineData("fanuc", "G187 P1\nG999\n", 2, "2 of 5 blocks are not understood.")]
    [InlineData("fanuc", "G7.1 C20.\n", 2, "1 of 4 blocks is not understood.")]
    [InlineData("haas", "G12 I5. D1 Z-1.\n", 2, "1 of 4 blocks is not understood. Where 1 of 3 motions end, only the machine knows.")]
    public void Strict_asks_for_a_program_that_is_understood_as_a_whole(string dialect, string block, int exit, string last)
    {
        using var folder = new TemporaryFolder();
        var program = folder.File("p.nc", block.StartsWith("G0", StringComparison.Ordinal) ? Understood.Replace("M30", block + "M30",
            StringComparison.Ordinal) : block + Understood);
        foreach (var strict in new[] { false, true })
        {
            string[] arguments = ["nc", "check", program, "--dialect", dialect, .. strict ? ["--strict"] : Array.Empty<string>()];
            var (code, text, error) = Shell.Run(arguments);
            Assert.Equal((strict ? exit : 0, last), (code, text.TrimEnd().Split('\n')[^1]));
            Assert.Equal(code == 0, error.Length == 0);
        }

        if (exit == 2)
        {
            var document = Shell.Json(2, "errormatch/nc-check/1", "nc", "check", program, "--dialect", dialect, "--strict");
            var first = document.GetProperty("errors")[0];
            Assert.Equal(("not-understood", 1), (first.Text("code"), first.GetProperty("line").GetInt32()));
            Assert.Equal(last, document.GetProperty("understanding").Text("sentence"));
        }
    }

    // The arcs that lead to a contour and away from it are not followed; the straight ways are.
    [Theory]
    [InlineData("APPR CT X+0 Y+0 CCA90 R+5", "DEP LCT X-30 Y-30 R+5", 2, "2 of 7 blocks are not understood.")]
    [InlineData("APPR LT X+0 Y+0 LEN15", "DEP LT LEN5 X-30 Y-30", 0, "Everything is understood.")]
    public void Ways_that_are_not_followed_are_not_understood(string approach, string departure, int exit, string sentence)
    {
        using var folder = new TemporaryFolder();
        var program = folder.File(
            "p.h",
            $"0 BEGIN PGM A MM\n1 L X-30 Y-30 Z-5 R0 FMAX\n2 {approach} RL F100\n3 L Y+20\n4 L X+20\n5 {departure}\n6 END PGM A MM\n");
        string[] arguments = ["nc", "check", program, "--dialect", "heidenhain-klartext", "--tool-radius", "3", "--strict"];
        var (code, text, _) = Shell.Run(arguments);
        Assert.Equal((exit, exit == 2), (code, text.Contains("that are not followed, this says nothing", StringComparison.Ordinal)));
        Assert.StartsWith(sentence, text.TrimEnd().Split('\n')[^1], StringComparison.Ordinal);
    }

    [Fact]
    public void Block_skip_is_counted()
    {
        using var folder = new TemporaryFolder();
        var program = folder.File("p.nc", "G90 G17 G40 G0 X0. Y0. Z0.\n/X5.\n/X6.\nX7.\n");
        var (_, text, _) = Shell.Run("nc", "check", program, "--dialect", "fanuc", "--block-skip", "on");
        Assert.EndsWith("Everything is understood. Block skip passes over 2.\n", text, StringComparison.Ordinal);
    }
}
