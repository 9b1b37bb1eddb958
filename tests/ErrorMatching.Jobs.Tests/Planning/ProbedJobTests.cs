using System.Text;
using System.Text.RegularExpressions;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

/// <summary>The program that touches a part, followed on a virtual machine, and what comes of its log.</summary>
public sealed partial class ProbedJobTests
{
    private const double Ball = 3;
    private const double TopZ = 1;

    // A program's words have 0.001 mm, which moves a touch along the boundary and hardly across it.
    private const double RoundedMm = 0.0005;

    private static readonly ProbeWish Stated = new() { StylusDiameterMm = Ball, TouchZ = -5, ClearanceZ = 25, ToolNumber = 9 };

    [Theory]
    [InlineData("fanuc")]
    [InlineData("siemens-840d")]
    [InlineData("linuxcnc")]
    [InlineData("haas")]
    [InlineData("grbl")]
    public void The_log_says_where_the_part_is_and_nothing_but_measuring_moves_touch_it(string dialect)
    {
        using var folder = Copied();
        var probed = Probed(folder, Stated with { Dialect = dialect });
        var part = new VirtualPart(DovetailGroove.Polygon(), Ball);
        part.Run(Path(probed), TopZ);
        Assert.Empty(part.Collisions);
        Assert.Equal(28, part.Touches.Count);
        Assert.Empty(probed.Program.Moves.Assumed);

        WithBall(folder);
        File.WriteAllText(folder["probe.log"], part.Log(probed.Program.Moves.Plan));
        var report = Matched(folder, "job.json", "probe.log").Report;
        Assert.All(report.KeyPoints, p => Assert.Equal(DovetailGroove.DisplacedMm[p.Feature], DovetailGroove.OffMm(p), RoundedMm));
    }

    [Fact]
    public void Contacts_and_centers_of_one_log_are_told_apart_whatever_the_job_says()
    {
        using var folder = Copied();
        var probed = Probed(folder, Stated);
        var part = new VirtualPart(DovetailGroove.Polygon(), Ball);
        part.Run(Path(probed), TopZ);
        var lines = part.Log(probed.Program.Moves.Plan).Split('\n');

        // The first touch as the contact that a probing cycle would give: the ball came from below the shoulder's tool side.
        var contact = part.Touches[0].Y + (Ball / 2);
        lines[1] = FormattableString.Invariant($"P1 S X{part.Touches[0].X:0.000000} Y{contact:0.000000} Z-5");
        WithBall(folder);
        File.WriteAllText(folder["probe.log"], string.Join('\n', lines));
        var report = Matched(folder, "job.json", "probe.log").Report;
        Assert.All(report.KeyPoints, p => Assert.Equal(DovetailGroove.DisplacedMm[p.Feature], DovetailGroove.OffMm(p), RoundedMm));
    }

    [Fact]
    public void Centers_without_a_ball_are_refused_and_so_is_the_log_of_other_points()
    {
        using var folder = Copied();
        var probed = Probed(folder, Stated);
        var part = new VirtualPart(DovetailGroove.Polygon(), Ball);
        part.Run(Path(probed), TopZ);
        File.WriteAllText(folder["probe.log"], part.Log(probed.Program.Moves.Plan));
        var error = Assert.Throws<InputException>(() => Matched(folder, "job.json", "probe.log"));
        Assert.Equal(("stylus-missing", 2), (error.Code, error.Place.Line));

        WithBall(folder);
        var theoretical = File.ReadAllText(folder["theoretical.csv"]);
        File.WriteAllText(folder["theoretical.csv"], theoretical.Replace("1,-76.8660", "1,-76.8650", StringComparison.Ordinal));
        Assert.Equal("other-plan", Assert.Throws<InputException>(() => Matched(folder, "job.json", "probe.log")).Code);
    }

    [Fact]
    public void What_nobody_stated_stands_in_the_program_before_a_stop_and_before_the_first_move()
    {
        using var folder = Copied();
        var probed = Probed(folder, new());
        Assert.Equal(["ball 6", "touch at Z -5", "travel at Z 25"], probed.Program.Moves.Assumed);
        var text = Encoding.ASCII.GetString(probed.Program.Bytes.Span);
        Assert.Contains("(NOBODY STATED BALL 6, TOUCH AT Z -5, TRAVEL AT Z 25)", text, StringComparison.Ordinal);
        var lines = text.Split('\n').ToList();
        Assert.InRange(lines.IndexOf("M0"), 1, lines.FindIndex(l => FirstMove().IsMatch(l)) - 1);
        Assert.Contains(probed.Notes, n => n.Contains("stylusDiameterMm", StringComparison.Ordinal));
    }

    [Fact]
    public void A_control_without_a_template_gets_what_fanuc_understands_and_that_is_assumed()
    {
        using var folder = new TemporaryFolder();
        foreach (var file in Directory.GetFiles(Repository.PathTo("samples", "complex-mating")))
        {
            File.Copy(file, folder[System.IO.Path.GetFileName(file)]);
        }

        var probed = Probed(folder, Stated);
        Assert.Equal("fanuc", probed.Program.Template.File);
        Assert.Equal(["codes of Fanuc"], probed.Program.Moves.Assumed);
        Assert.Equal("probe.nc", probed.FileName);
    }

    [Fact]
    public void A_ball_that_does_not_fit_is_refused_with_the_point()
    {
        using var folder = Copied();

        // In the notch's edge of 1 mm and beside the tooth a ball of 30 mm meets both flanks of the part's tooth.
        var refusals = ProbedJob.Of(
            folder["job.json"], Stated with { StylusDiameterMm = 60 }, TestContext.Current.CancellationToken).Refusals;
        Assert.NotEmpty(refusals);
        Assert.All(refusals, r => Assert.Equal("out-of-reach", r.Code));
    }

    [Theory]
    [InlineData(-6, "clearance-too-low")]
    [InlineData(-5, "clearance-too-low")]
    public void A_travel_below_the_touch_is_refused(double clearance, string code)
    {
        using var folder = Copied();
        Assert.Equal(code, ProbedJob.Of(
            folder["job.json"], Stated with { ClearanceZ = clearance }, TestContext.Current.CancellationToken).Refusal!.Code);
    }

    [Fact]
    public void A_template_of_the_shop_that_keeps_silent_about_assumptions_is_refused()
    {
        using var folder = Copied();
        File.WriteAllText(
            folder["own.txt"],
            "@body\nG17 G21 G90 G94 G54\n@each point\nG0 X{approach.x}\nG31 X{overtravel.x} F{feed.measuring}\n@next\nM30\n");
        var error = Assert.Throws<InputException>(() => Probed(folder, new() { Template = folder["own.txt"] }));
        Assert.Equal("bad-template", error.Code);
        Assert.Contains("touch at Z -5", error.Message, StringComparison.Ordinal);
        Assert.Equal(28, Probed(folder, Stated with { ToolNumber = null, Template = folder["own.txt"] }).Points.Count);
    }

    private static NcPath Path(ProbedJob probed) => NcInterpreter.Run(
        NcProgram.Read(probed.Program.Bytes, probed.Program.Dialect.Syntax), probed.Program.Dialect);

    private static ProbedJob Probed(TemporaryFolder folder, ProbeWish wish)
    {
        var outcome = ProbedJob.Of(folder["job.json"], wish, TestContext.Current.CancellationToken);
        Assert.True(outcome.IsUsable, outcome.Refusal?.ToString());
        return outcome.Result!;
    }

    private static MatchedProgram Matched(TemporaryFolder folder, string job, string log)
    {
        var run = MatingRun.Of(
            new JobFiles(folder[job]), new() { Part = new(folder[log]) }, TestContext.Current.CancellationToken);
        Assert.True(run.IsUsable, run.Refusal?.ToString());
        return run.Result;
    }

    private static void WithBall(TemporaryFolder folder) => File.WriteAllText(
        folder["job.json"],
        File.ReadAllText(folder["job.json"]).Replace(
            "\"uncertaintyMm\": 0.002", "\"uncertaintyMm\": 0.002, \"stylusDiameterMm\": 3", StringComparison.Ordinal));

    private static TemporaryFolder Copied()
    {
        var folder = new TemporaryFolder();
        foreach (var file in new[] { "job.json", "theoretical.csv", "part.csv", "counterpart.nc" })
        {
            File.Copy(Repository.PathTo("samples", "dovetail", file), folder[file]);
        }

        return folder;
    }

    [GeneratedRegex("^G[0-9]+ [XYZ]", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex FirstMove();
}
