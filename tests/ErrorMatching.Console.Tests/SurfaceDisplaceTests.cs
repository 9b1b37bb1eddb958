using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

public sealed class SurfaceDisplaceTests
{
    [Fact]
    public void The_samples_program_follows_the_compensation()
    {
        using var folder = new TemporaryFolder();
        var (job, program) = (Sample("job.json"), Sample("cam.nc"));
        var displaced = Shell.Json(
            0,
            "errormatch/surface-displace/1",
            "surface",
            "displace",
            job,
            "--measured",
            Sample("measured.csv"),
            "--program",
            program,
            "--out",
            folder.Path);
        Assert.Equal(folder["cam.nc"], displaced.Text("file"));
        Assert.True(displaced.GetProperty("proof").GetProperty("holds").GetBoolean());
        Assert.True(displaced.GetProperty("onSurface").GetInt32() > 3000);

        // Nothing goes further than the largest measured error of 25.3 um and what a smooth field adds between points.
        Assert.InRange(displaced.Number("largestMoveMm"), 0.02, 0.03);
        Assert.Equal(File.ReadAllLines(program).Length + 1, File.ReadAllLines(folder["cam.nc"]).Length);
        Assert.Equal(
            0,
            Shell.Json(0, "errormatch/nc-check/1", "nc", "check", folder["cam.nc"], "--dialect", "siemens-840d")
                .GetProperty("problems")
                .GetArrayLength());
    }

    [Fact]
    public void A_program_of_another_tool_is_refused_and_nothing_is_written()
    {
        using var folder = new TemporaryFolder();
        var job = folder.File(
            "job.json", File.ReadAllText(Sample("job.json")).Replace("\"diameterMm\": 6", "\"diameterMm\": 8", StringComparison.Ordinal));
        File.Copy(Sample("surface.igs"), folder["surface.igs"]);
        var error = Shell.Error(
            2, "surface", "displace", job, "--measured", Sample("measured.csv"), "--program", Sample("cam.nc"), "--out", folder["out"]);
        Assert.Equal("program-in-surface", error.Text("code"));
        Assert.False(Directory.Exists(folder["out"]));
    }

    [Fact]
    public void A_program_that_exists_follows_the_error_whatever_the_job_fits()
    {
        using var folder = new TemporaryFolder();
        var job = folder.File(
            "job.json", File.ReadAllText(Sample("job.json")).Replace("\"of\": \"error\"", "\"of\": \"points\"", StringComparison.Ordinal));
        File.Copy(Sample("surface.igs"), folder["surface.igs"]);
        var displaced = Shell.Json(
            0,
            "errormatch/surface-displace/1",
            ["surface", "displace", job, "--measured", Sample("measured.csv"), "--program", Sample("cam.nc"), "--out", folder["out"]]);
        Assert.Contains("fit-follows-error", displaced.GetRawText(), StringComparison.Ordinal);
    }

    [Fact]
    public void The_line_of_a_program_that_was_displaced_already_is_said_once()
    {
        using var folder = new TemporaryFolder();
        string[] Again(string program) =>
            ["surface", "displace", Sample("job.json"), "--measured", Sample("measured.csv"), "--program", program, "--out", folder["out"]];
        Assert.Equal(0, Shell.Run(Again(Sample("cam.nc"))).Exit);
        var displaced = folder["out/cam.nc"];
        Assert.StartsWith($"{displaced}:1: the program carries a marker", Shell.Run(Again(displaced)).Error, StringComparison.Ordinal);
    }

    private static string Sample(string file) => Repository.PathTo("samples", "surface-one", file);
}
