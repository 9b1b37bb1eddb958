using System.Security.Cryptography;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>Folders with called programs: searched behind the program's own, and part of what a result is bound to.</summary>
public sealed class LibraryTests
{
    private const string Calls = "G90 G17 G40 G0 X0. Y0. Z5.\nM98 P1002\nN10 G1 X10. F100.\nN20 Y10.\nG0 Z5.\nM30\n";

    [Fact]
    public void A_called_program_is_found_in_the_library()
    {
        using var folder = new TemporaryFolder();
        var program = folder.File("p.nc", Calls);
        Assert.Equal("missing-program", Shell.Json(2, "errormatch/nc-check/1", Check(program)).GetProperty("errors")[0].Text("code"));
        Library(folder, "lib", "X3.");
        Assert.Equal(3, EndOfCall(program, "--library", folder["lib"]));
    }

    [Fact]
    public void The_program_s_own_folder_comes_first_and_then_the_libraries_in_order()
    {
        using var folder = new TemporaryFolder();
        var program = folder.File("p.nc", Calls);
        Library(folder, "a", "X3.");
        Library(folder, "b", "X4.");
        Assert.Equal(4, EndOfCall(program, "--library", folder["b"], "--library", folder["a"]));
        folder.File("1002.nc", "O1002\nX5.\nM99\n");
        Assert.Equal(5, EndOfCall(program, "--library", folder["a"]));
    }

    [Theory]
    [InlineData("M98 <../SECRET>")]
    [InlineData("M98 P1002")]
    public void Nothing_outside_the_folder_and_no_link_is_opened(string call)
    {
        using var folder = new TemporaryFolder();
        var program = folder.File("p.nc", Calls.Replace("M98 P1002", call, StringComparison.Ordinal));
        folder.File("SECRET.txt", "X3.\nM99\n");
        Directory.CreateDirectory(folder["lib"]);
        File.CreateSymbolicLink(folder["lib/1002.nc"], folder["SECRET.txt"]);
        Assert.Equal(2, Shell.Run([.. Check(program), "--library", folder["lib"]]).Exit);
    }

    [Fact]
    public void A_library_that_is_not_there_is_named()
    {
        using var folder = new TemporaryFolder();
        var error = Shell.Error(1, [.. Check(folder.File("p.nc", Calls)), "--library", folder["none"]]);
        Assert.Equal(("file-unreadable", folder["none"]), (error.Text("code"), error.Text("file")));
    }

    [Fact]
    public void A_wish_is_about_the_called_programs_too()
    {
        using var folder = new TemporaryFolder();
        var (program, wish) = (folder.File("p.nc", Calls), folder["wish.json"]);
        Library(folder, "lib", "X3.");
        string[] with = ["--dialect", "fanuc", "--library", folder["lib"]];
        string[] displace = ["nc", "displace", program, "--blocks", "N20", "--normal", "0.1", "--out", folder["o.nc"], "--wish", wish];
        Assert.Equal(0, Shell.Run([.. displace, .. with]).Exit);
        string[] prove = ["nc", "prove", program, folder["o.nc"], "--wish", wish, "--library", folder["lib"]];
        Assert.Equal(0, Shell.Run(prove).Exit);
        Library(folder, "lib", "X3. (CHANGED)");
        Assert.Equal("wish-of-other-program", Shell.Error(1, prove).Text("code"));
    }

    [Fact]
    public void A_match_names_the_called_programs_and_binds_its_marker_to_them()
    {
        using var folder = new TemporaryFolder();
        foreach (var file in Directory.EnumerateFiles(Repository.PathTo("samples", "complex-mating")))
        {
            File.Copy(file, folder[Path.GetFileName(file)]);
        }

        var (job, program) = (folder["job.json"], folder["counterpart.nc"]);
        File.WriteAllText(program, File.ReadAllText(program).Replace("N50 S6000 M3", "N50 S6000 M3\nM98 P1002", StringComparison.Ordinal));
        Assert.Equal(2, Shell.Run("match", job, "--out", folder["out"]).Exit);
        File.WriteAllText(job, File.ReadAllText(job).Replace("\"mapMm\": 0.5,", "\"mapMm\": 0.5, \"libraries\": [\"lib\"],",
            StringComparison.Ordinal));
        Library(folder, "lib", "M8");
        var first = Matched();
        Library(folder, "lib", "M8 (CHANGED)");
        Assert.NotEqual(first, Matched());
        Assert.NotEqual(Sha256(program), first, StringComparer.OrdinalIgnoreCase);

        string Matched()
        {
            var report = Shell.Json(0, "errormatch/match/1", "match", job, "--out", folder["out"]);
            var called = Assert.Single(report.GetProperty("inputs").EnumerateArray(), i => i.Text("role") == "called");
            Assert.Equal(("O1002", Sha256(folder["lib/1002.nc"])), (called.Text("file"), called.Text("sha256")));
            var text = File.ReadAllText(folder["out/counterpart.nc"]);
            return text[(text.IndexOf("BASE=", StringComparison.Ordinal) + 5)..][..64];
        }
    }

    private static string[] Check(string program) => ["nc", "check", program, "--dialect", "fanuc"];

    // Where the called program ends, along X.
    private static double EndOfCall(string program, params string[] more)
    {
        var motions = Shell.Json(0, "errormatch/nc-motion/1", ["nc", "motion", program, "--dialect", "fanuc", .. more]);
        return motions.GetProperty("motions")[1].GetProperty("x").GetDouble();
    }

    private static void Library(TemporaryFolder folder, string name, string words)
    {
        Directory.CreateDirectory(folder[name]);
        folder.File(name + "/1002.nc", $"O1002\n{words}\nM99\n");
    }

    private static string Sha256(string file) => Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(file)));
}
