using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>What <c>errormatch job plan</c> and <c>errormatch job probe</c> print, write and refuse.</summary>
public sealed class JobPlanTests
{
    private static readonly string Dovetail = Repository.PathTo("samples", "dovetail", "job.json");

    [Fact]
    public void A_plan_is_a_table_a_job_and_a_promise_and_the_job_can_be_probed()
    {
        using var folder = new TemporaryFolder();
        var plan = Shell.Json(0, "errormatch/job-plan/1", "job", "plan", Dovetail, "--stylus-diameter", "3", "--out", folder["plan"]);
        var count = plan.GetProperty("count").GetInt32();
        Assert.InRange(count, 20, 40);
        Assert.Equal(count, plan.GetProperty("points").GetArrayLength());
        Assert.False(plan.GetProperty("stylusAssumed").GetBoolean());
        Assert.InRange(plan.GetProperty("prediction").GetProperty("bound95Mm").GetDouble(), 0.002, 0.02);
        Assert.Equal(
            ["plan.csv", "job-planned.json"], plan.GetProperty("files").EnumerateArray().Select(f => Path.GetFileName(f.GetString())));
        var table = File.ReadAllLines(folder["plan/plan.csv"]);
        Assert.Equal("point,feature,x,y,nx,ny,reason", table[0]);
        Assert.Equal(count, table.Length - 1);
        Assert.StartsWith(
            $"{folder["plan/job-planned.json"]} is a valid mating job",
            Shell.Run("job", "check", folder["plan/job-planned.json"]).Output,
            StringComparison.Ordinal);

        var probe = Shell.Json(
            0, "errormatch/job-probe/1", "job", "probe", folder["plan/job-planned.json"], "--stylus-diameter", "3", "--z", "-5",
            "--clearance", "25", "--tool", "9", "--dialect", "linuxcnc", "--out", folder["probe"]);
        Assert.Equal(count, probe.GetProperty("count").GetInt32());
        Assert.Equal(0, probe.GetProperty("assumed").GetArrayLength());
        Assert.Equal("linuxcnc", probe.Text("dialect"));
        Assert.Equal(count, File.ReadLines(folder["probe/probe.nc"]).Count(l => l.StartsWith("G38.2 ", StringComparison.Ordinal)));
        Assert.Equal((0, ""), (Shell.Run("nc", "check", folder["probe/probe.nc"], "--dialect", "linuxcnc").Exit, ""));
    }

    [Fact]
    public void The_promise_comes_first_and_what_nobody_stated_is_told()
    {
        using var folder = new TemporaryFolder();
        var (exit, output, error) = Shell.Run("job", "plan", Dovetail);
        Assert.Equal((0, ""), (exit, error));
        Assert.Matches("^With [0-9]+ points: the boundary will be known within ±0[.]00[0-9]{2} mm everywhere", output);
        Assert.Contains("Nobody stated the ball of the probe", output, StringComparison.Ordinal);
        Assert.Contains("Nothing was written.", output, StringComparison.Ordinal);

        (exit, output, error) = Shell.Run("job", "probe", Dovetail, "--out", folder["probe"]);
        Assert.Equal((0, ""), (exit, error));
        Assert.Contains(
            "Nobody stated ball 6, touch at Z -5, travel at Z 28: the program stops before its first move",
            output,
            StringComparison.Ordinal);
        Assert.Contains($"Wrote {folder["probe/probe.nc"]}. Next:", output, StringComparison.Ordinal);
    }

    [Fact]
    public void What_cannot_be_is_exit_2_and_writes_nothing()
    {
        using var folder = new TemporaryFolder();
        var failed = Shell.Json(
            2, "errormatch/error/1", "job", "probe", Dovetail, "--stylus-diameter", "60", "--out", folder["probe"]);
        Assert.All(failed.GetProperty("errors").EnumerateArray(), e => Assert.Equal("out-of-reach", e.Text("code")));
        failed = Shell.Json(2, "errormatch/error/1", "job", "plan", Dovetail, "--stylus-diameter", "60", "--out", folder["plan"]);
        Assert.Equal("out-of-reach", failed.GetProperty("errors")[0].Text("code"));
        Assert.False(Directory.Exists(folder["probe"]) || Directory.Exists(folder["plan"]));
        Assert.Equal(1, Shell.Run("job", "plan", Dovetail, "--within", "0").Exit);
        Assert.Equal(1, Shell.Run("job", "probe", Dovetail, "--tool", "0").Exit);
        Assert.Equal(1, Shell.Run("job", "probe", Dovetail, "--dialect", "okuma-osp", "--z", "-5").Exit);
    }
}
