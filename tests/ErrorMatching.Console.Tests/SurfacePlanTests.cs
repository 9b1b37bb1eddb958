using System.Globalization;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

public sealed class SurfacePlanTests
{
    [Theory]
    [InlineData("surface-one", 70)]
    [InlineData("surface-two", 49)]
    [InlineData("surface-three", 68)]
    public void The_samples_are_planned_with_the_paper_s_numbers_of_points(string sample, int points)
    {
        using var folder = new TemporaryFolder();
        var plan = Shell.Json(0, "errormatch/surface-plan/1", "surface", "plan", Job(sample), "--out", folder.Path);
        Assert.Equal((points, 7), (plan.GetProperty("count").GetInt32(), plan.GetProperty("curves").GetInt32()));
        Assert.Equal(points, plan.GetProperty("points").GetArrayLength());
        Assert.Equal(folder["plan.csv"], Assert.Single(plan.GetProperty("files").EnumerateArray()).GetString());
        var lines = File.ReadAllLines(folder["plan.csv"]);
        Assert.Equal("point,i,j,x,y,z,nx,ny,nz,reason", lines[0]);
        Assert.Equal(points + 1, lines.Length);
    }

    [Fact]
    public void Without_a_folder_nothing_is_written_and_the_answer_says_so()
    {
        var (exit, output, error) = Shell.Run("surface", "plan", Job("surface-one"));
        Assert.Equal((0, ""), (exit, error));
        Assert.Contains("Nothing was written", output, StringComparison.Ordinal);
        Assert.Contains("7 curves of 10 points; stock on the surface 0.2 mm", output, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("siemens-840d")]
    [InlineData("fanuc")]
    [InlineData("linuxcnc")]
    public void The_probing_program_passes_the_check_of_its_dialect(string dialect)
    {
        using var folder = new TemporaryFolder();
        var job = Changed(
            folder, "\"approachMm\": 2,\n    \"dialect\": \"siemens-840d\"", $"\"approachMm\": 2,\n    \"dialect\": \"{dialect}\"");
        var probe = Shell.Json(0, "errormatch/surface-probe/1", "surface", "probe", job, "--out", folder["out"]);
        Assert.Equal((dialect, dialect), (probe.Text("dialect"), probe.Text("template")));
        Assert.True(File.Exists(folder["out/plan.csv"]));
        var check = Shell.Json(0, "errormatch/nc-check/1", "nc", "check", folder["out/probe.nc"], "--dialect", dialect);
        Assert.Equal(0, check.GetProperty("problems").GetArrayLength());
        Assert.Equal(70, Shell.Run("nc", "motion", folder["out/probe.nc"], "--dialect", dialect).Output.Split(",probe,").Length - 1);
    }

    [Fact]
    public void Probing_follows_a_semi_finishing_program_in_one_program()
    {
        using var folder = new TemporaryFolder();
        var semi = folder.File("semi.nc", "G54 G17 G90\nM3 S10000\nG0 X0 Y0 Z60\nG1 Z50 F1200\nX75\nG0 Z60\nM5\nM30\n");
        var probe = Shell.Json(
            0, "errormatch/surface-probe/1", "surface", "probe", Job("surface-one"), "--after", semi, "--out", folder["out"]);
        Assert.Equal(semi, probe.Text("after"));
        Assert.Equal(
            4 + 1 + (70 * 5), Shell.Run("nc", "motion", folder["out/probe.nc"], "--dialect", "siemens-840d").Output.Split('\n').Length - 2);
    }

    [Fact]
    public void A_mistake_in_the_shop_s_template_is_named_by_its_line_and_nothing_is_written()
    {
        using var folder = new TemporaryFolder();
        folder.File("own.txt", "@body\n@each point\nG0 X{aproach.x}\n@next\n");
        var job = Changed(folder, "\"approachMm\": 2,", "\"approachMm\": 2, \"template\": \"own.txt\",");
        var error = Shell.Error(1, "surface", "probe", job, "--out", folder["out"]);
        Assert.Equal(
            ("bad-template", folder["own.txt"], 3), (error.Text("code"), error.Text("file"), error.GetProperty("line").GetInt32()));
        Assert.False(Directory.Exists(folder["out"]));
    }

    [Fact]
    public void A_surface_that_faces_down_is_planned_but_not_probed_or_cut()
    {
        using var folder = new TemporaryFolder();
        var job = Changed(folder, "\"surface\": \"surface.igs\"", "\"surface\": \"surface.igs\", \"outside\": \"-z\"");
        var (exit, output, _) = Shell.Run("surface", "plan", job, "--out", folder["out"]);
        Assert.Equal(0, exit);
        Assert.Contains("The surface faces down", output, StringComparison.Ordinal);
        var rows = File.ReadAllLines(folder["out/plan.csv"]).Skip(1).Select(l => l.Split(',')).ToArray();
        Assert.Equal(70, rows.Length);
        Assert.All(rows, r => Assert.StartsWith("-", r[8], StringComparison.Ordinal));

        (exit, output, var error) = Shell.Run("surface", "probe", job, "--out", folder["probe"]);
        Assert.Equal((2, ""), (exit, output));
        Assert.Contains("normal points down", error, StringComparison.Ordinal);
        Assert.Equal("faces-down", Shell.Error(2, "surface", "toolpath", job, "--out", folder["probe"]).Text("code"));
        Assert.False(Directory.Exists(folder["probe"]));
    }

    [Fact]
    public void A_surface_that_faces_down_is_evaluated()
    {
        using var folder = new TemporaryFolder();
        var job = Changed(folder, "\"surface\": \"surface.igs\"", "\"surface\": \"surface.igs\", \"outside\": \"-z\"");
        Shell.Json(0, "errormatch/surface-plan/1", "surface", "plan", job, "--out", folder.Path);

        // 5 um of material over the stock of 0.2 mm, everywhere.
        var measured = File.ReadAllLines(folder["plan.csv"])
            .Skip(1)
            .Select(l => l.Split(','))
            .Select(r => string.Join(',', (string[])[r[0], Moved(r, 3), Moved(r, 4), Moved(r, 5)]));
        var file = folder.File("measured.csv", "point,x,y,z\n" + string.Join('\n', measured) + "\n");
        var evaluated = Shell.Json(0, "errormatch/surface-evaluate/1", "surface", "evaluate", job, "--measured", file);
        Assert.Equal(5, evaluated.Number("meanUm"), 0.01);
        Assert.Equal(0, evaluated.Number("standardDeviationUm"), 0.01);

        static string Moved(string[] row, int column) =>
            (Read(row[column]) + (0.205 * Read(row[column + 3]))).ToString("R", CultureInfo.InvariantCulture);
        static double Read(string text) => double.Parse(text, CultureInfo.InvariantCulture);
    }

    [Fact]
    public void No_zero_has_a_minus()
    {
        foreach (var sample in new[] { "surface-one", "surface-two", "surface-three" })
        {
            Assert.DoesNotContain("-0.0000 ", Shell.Run("surface", "plan", Job(sample)).Output, StringComparison.Ordinal);
        }

        foreach (var sample in new[] { "surface-one", "surface-two", "surface-three" })
        {
            Assert.DoesNotMatch(@"[\s\[]-0(?![.0-9])", Shell.Run("surface", "plan", Job(sample), "--json").Output);
        }

        Assert.Equal(["0.0000", "0.0000", "-0.0001"], new[] { -0.0, -0.00004, -0.00006 }.Select(Show.Mm));
    }

    private static string Job(string sample) => Repository.PathTo("samples", sample, "job.json");

    // The valley of Surface two has a radius of 125 mm: a ball of 300 mm does not touch its ground.
    [Fact]
    public void A_stylus_that_does_not_reach_stops_probing()
    {
        using var folder = new TemporaryFolder();
        Assert.Equal(2, Shell.Run("surface", "plan", JobWithALargeBall(folder)).Exit);
    }

    [Fact]
    public void A_stylus_that_does_not_reach_does_not_stop_what_was_measured()
    {
        using var folder = new TemporaryFolder();
        var job = JobWithALargeBall(folder);

        // By i and j, since another stylus is led in another order.
        Assert.Equal(0, Shell.Run("surface", "plan", Job("surface-two"), "--out", folder.Path).Exit);
        var plan = File.ReadAllLines(folder["plan.csv"]).Skip(1).Select(l => l.Split(',')).ToDictionary(r => r[0], r => $"{r[1]},{r[2]}");
        var rows = File.ReadAllLines(Repository.PathTo("samples", "surface-two", "measured.csv"))
            .Skip(1)
            .Select(l => l.Split(',', 2))
            .Select(r => $"{plan[r[0]]},{r[1]}");
        var measured = folder.File("measured.csv", "i,j,x,y,z\n" + string.Join('\n', rows) + "\n");

        Assert.Equal(
            49, Shell.Json(0, "errormatch/surface-evaluate/1", "surface", "evaluate", job, "--measured", measured).Number("count"));
        Assert.Equal(0, Shell.Run("surface", "compensate", job, "--measured", measured).Exit);
    }

    private static string JobWithALargeBall(TemporaryFolder folder)
    {
        File.Copy(Repository.PathTo("samples", "surface-two", "surface.stp"), folder["surface.stp"]);
        return folder.File(
            "job.json",
            File.ReadAllText(Job("surface-two")).Replace("\"stylusDiameterMm\": 6", "\"stylusDiameterMm\": 300", StringComparison.Ordinal));
    }

    private static string Changed(TemporaryFolder folder, string old, string changed)
    {
        File.Copy(Repository.PathTo("samples", "surface-one", "surface.igs"), folder["surface.igs"]);
        var text = File.ReadAllText(Job("surface-one")).ReplaceLineEndings("\n");
        Assert.Contains(old, text, StringComparison.Ordinal);
        return folder.File("job.json", text.Replace(old, changed, StringComparison.Ordinal));
    }
}
