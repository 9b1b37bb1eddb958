using System.Globalization;
using System.Text;
using System.Text.RegularExpressions;
using ErrorMatching.Geometry;
using ErrorMatching.Mating;
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

    public static TheoryData<string, string> Cycles { get; } = new()
    {
        { "heidenhain-klartext", "heidenhain-klartext" },
        { "siemens-840d", "siemens-cycle978" },
        { "fanuc", "fanuc-p98xx" },
        { "haas", "haas-p98xx" },
    };

    // Turned, moves along X in both directions and along Y in both are among them.
    public static TheoryData<string, string, double> TurnedCycles { get; } = new(
        from cycle in Cycles from degrees in new[] { 0.0, 90.0, 180.0, 270.0 } select (cycle.Data.Item1, cycle.Data.Item2, degrees));

    public static TheoryData<string, string, double> WrongAnswers { get; } = new(
        from cycle in new[]
        {
            ("heidenhain-klartext", "heidenhain-klartext"), ("siemens-840d", "siemens-cycle978"), ("fanuc", "fanuc-p98xx"),
        }
        from radii in new[] { -2.0, -1.0, 1.0 }
        select (cycle.Item1, cycle.Item2, radii));

    [Theory]
    [InlineData("fanuc", false)]
    [InlineData("siemens-840d", false)]
    [InlineData("linuxcnc", false)]
    [InlineData("haas", false)]
    [InlineData("grbl", false)]
    [InlineData("fanuc", true)]
    public void The_log_says_where_the_part_is_and_nothing_but_measuring_moves_touch_it(string dialect, bool isMirrored)
    {
        using var folder = Copied();
        if (isMirrored)
        {
            Mirror(folder);
        }

        var probed = Probed(folder, Stated with { Dialect = dialect });
        var material = DovetailGroove.Polygon();
        var part = new VirtualPart(isMirrored ? [.. material.Select(p => new Point2(-p.X, p.Y))] : material, Ball);
        part.Run(Path(probed), TopZ);
        Assert.Empty(part.Collisions);
        Assert.Equal(28, part.Touches.Count);
        Assert.Empty(probed.Program.Moves.Assumed);

        WithBall(folder);
        File.WriteAllText(folder["probe.log"], part.Log(probed.Program.Moves.Plan));
        var report = Matched(folder, "job.json", "probe.log").Report;
        Assert.All(report.KeyPoints, p => Assert.Equal(DovetailGroove.DisplacedMm[p.Feature], DovetailGroove.OffMm(p), RoundedMm));
    }

    // The control executes the text of the program. Its answers have the digits of the log.
    [Theory]
    [MemberData(nameof(TurnedCycles))]
    public void A_cycle_of_the_control_finds_the_part_and_nothing_else_touches_it(string dialect, string template, double degrees)
    {
        using var folder = Copied();
        var frame = Turn(folder, degrees);
        var probed = Probed(folder, Stated with { Dialect = dialect, Template = template });
        var (control, part, log) = Executed(probed, frame, 0);
        Assert.Empty(part.Collisions);
        Assert.Equal(28, control.Touches.ByCycle + control.Touches.BySkip);
        Assert.Equal(template == "siemens-cycle978" ? 10 : 28, control.Touches.ByCycle);
        WithBall(folder);
        File.WriteAllText(folder["probe.log"], log);
        var report = Matched(folder, "job.json", "probe.log").Report;
        Assert.All(report.KeyPoints, p => Assert.Equal(DovetailGroove.DisplacedMm[p.Feature], DovetailGroove.OffMm(p), 0.001));
    }

    // What breaks pieces: a cycle that answers with the center where the contact is expected, the other way round, or on the other side.
    [Theory]
    [MemberData(nameof(WrongAnswers))]
    public void A_cycle_that_answers_something_else_than_the_template_assumes_is_refused(string dialect, string template, double radii)
    {
        using var folder = Copied();
        var probed = Probed(folder, Stated with { Dialect = dialect, Template = template });
        WithBall(folder);
        File.WriteAllText(folder["probe.log"], Executed(probed, RigidTransform2.Identity, radii).Log);
        var run = MatingRun.Run(
            new JobFiles(folder["job.json"]), new() { Part = new(folder["probe.log"]) }, TestContext.Current.CancellationToken);
        Assert.False(run.IsUsable);
    }

    [Theory]
    [MemberData(nameof(Cycles))]
    public void What_a_template_takes_for_granted_stops_its_program_before_it_moves(string dialect, string template)
    {
        using var folder = Copied();
        var probed = Probed(folder, Stated with { Dialect = dialect, Template = template });
        Assert.Equal(probed.Program.Template.Assumes, probed.Program.Moves.Assumed);
        var lines = Encoding.ASCII.GetString(probed.Program.Bytes.Span).Split('\n').ToList();
        Assert.InRange(
            lines.FindIndex(l => l is "M0" or "STOP"),
            1,
            lines.FindIndex(l => FirstMove().IsMatch(l)) - 1);
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

    // The key is probed as it was cut, turned and moved against the drawing of the part.
    [Fact]
    public void The_counterpart_is_touched_from_the_other_side_and_verified_against_the_part()
    {
        using var folder = Copied();
        WithBall(folder);
        var frame = new RigidTransform2(Geometry.Mirror.X, Angle.FromDegrees(30), new(5, -3));
        File.WriteAllText(
            folder["job.json"],
            File.ReadAllText(folder["job.json"]).Replace(
                "\"mirror\": \"none\", \"rotateDeg\": 0, \"translateMm\": [0, 0]",
                "\"mirror\": \"x\", \"rotateDeg\": 30, \"translateMm\": [5, -3]",
                StringComparison.Ordinal));
        var lines = File.ReadAllLines(folder["theoretical.csv"]);
        var turned = lines.Select((l, i) => i == 0 ? l : Turned(l.Split(',')));
        File.WriteAllLines(folder["theoretical.csv"], turned);
        File.WriteAllText(folder["part.csv"], File.ReadAllText(folder["theoretical.csv"]) + "\n");
        var probed = Probed(folder, Stated with { OfCounterpart = true });
        var key = new VirtualPart(DovetailGroove.Polygon(ofKey: true), Ball);
        key.Run(Path(probed), TopZ);
        Assert.Empty(key.Collisions);
        File.WriteAllText(folder["probe.log"], key.Log(probed.Program.Moves.Plan));

        var files = new JobFiles(folder["job.json"]);
        var (theoretical, part) = (files.Theoretical(), files.Part(null));
        var after = files.Counterpart(new(folder["probe.log"]), part);
        var (program, bytes) = files.Program(null);
        var report = VerifyRun.Report(new(files.Job, theoretical, part, null, after, program, bytes), out var refusals);
        Assert.Empty(refusals);
        Assert.Equal(28, report!.Result.Points.Count);
        var features = files.Job.Features.SelectMany(f => f.Points.Select(p => (p, f.Name))).ToDictionary(StringComparer.Ordinal);
        Assert.All(
            report.Result.Points, p => Assert.Equal(DovetailGroove.DisplacedMm[features[p.Label]], p.AfterError.NormalMm, RoundedMm));

        // Of the part it is no measurement, and a ball thicker than the tool has no room.
        Assert.Equal("wrong-piece", Assert.Throws<InputException>(() => files.Part(new(folder["probe.log"]))).Code);
        // Deeper than the program cut, less the ball, nothing was cleared: the program cuts to Z-10.
        foreach (var wish in new[] { Stated with { TouchZ = -9 }, Stated with { StylusDiameterMm = 9 } })
        {
            File.WriteAllText(
                folder["job.json"],
                File.ReadAllText(folder["job.json"]).Replace(
                    "\"stylusDiameterMm\": 3",
                    FormattableString.Invariant($"\"stylusDiameterMm\": {wish.StylusDiameterMm}"),
                    StringComparison.Ordinal));
            var refused = ProbedJob.Make(
                folder["job.json"], wish with { OfCounterpart = true }, TestContext.Current.CancellationToken).Refusals;
            Assert.NotEmpty(refused);
            Assert.All(refused, r => Assert.Equal("out-of-reach", r.Code));
        }

        string Turned(string[] cells)
        {
            var at = frame.Inverse().Apply(new Point2(
                double.Parse(cells[1], CultureInfo.InvariantCulture), double.Parse(cells[2], CultureInfo.InvariantCulture)));
            return string.Create(CultureInfo.InvariantCulture, $"{cells[0]},{at.X:0.000000},{at.Y:0.000000}");
        }
    }

    // The log has centers, and the match makes contacts of them by the job's ball.
    [Fact]
    public void Another_ball_than_the_job_s_is_refused_and_one_that_the_job_lacks_is_asked_for()
    {
        using var folder = Copied();
        Assert.Contains(Probed(folder, Stated).Notes, n => n.Contains("stylusDiameterMm", StringComparison.Ordinal));
        WithBall(folder);
        Assert.Empty(Probed(folder, Stated).Notes);
        var refusal = ProbedJob.Make(
            folder["job.json"], Stated with { StylusDiameterMm = 4 }, TestContext.Current.CancellationToken).Refusal!;
        Assert.Equal("stylus-differs", refusal.Code);
        Assert.Contains(" 0.5 mm ", refusal.Message, StringComparison.Ordinal);
    }

    // In G54 the probe would go down beside a counterpart that was cut in G55, or shifted.
    [Theory]
    [InlineData("N20 G54", "N20 G55")]
    [InlineData("N20 G54", "N20 G54\nG52 X10.")]
    public void A_counterpart_in_another_work_offset_takes_a_template_that_selects_it(string selected, string other)
    {
        using var folder = Copied();
        File.WriteAllText(
            folder["counterpart.nc"], File.ReadAllText(folder["counterpart.nc"]).Replace(selected, other, StringComparison.Ordinal));
        var wish = Stated with { OfCounterpart = true };
        var refusal = ProbedJob.Make(folder["job.json"], wish, TestContext.Current.CancellationToken).Refusal!;
        Assert.Equal("other-work-offset", refusal.Code);
        wish = wish with { Template = "fanuc-p98xx" };
        refusal = ProbedJob.Make(folder["job.json"], wish, TestContext.Current.CancellationToken).Refusal!;
        Assert.Equal("other-work-offset", refusal.Code);
        wish = wish with { ToolNumber = null, Template = OwnTemplate(folder, "G55") };
        Assert.Equal(28, Probed(folder, wish).Points.Count);
        Assert.Equal(28, Probed(folder, Stated).Points.Count);
    }

    // The counterpart has a pocket of 3 mm depth beside its shoulder, at X-66 Y-36, or a hole: what of the part stands in it is met by a
    // ball that goes down there, also on its way below.
    [Theory]
    [InlineData("N41 G0 X-85. Y-36.\nN42 G1 Z-3. F250.\nN43 X-50.\nN44 G0 Z25.\n", true)]
    [InlineData("N41 G0 X-76. Y-35.\nN42 G1 Z-12. F250.\nN44 G0 Z25.\n", true)]
    [InlineData("N41 G81 X-76. Y-35. Z-12. R2. F100.\nN44 G80\n", true)]
    [InlineData("N41 G0 X-85. Y-50.\nN42 G1 Z-3. F250.\nN43 X-50.\nN44 G0 Z25.\n", false)]
    [InlineData("N41 G0 X-85. Y-30.\nN42 G1 Z-0.5 F250.\nN43 X-50.\nN431 Y-36.\nN432 X-85.\nN44 G0 Z25.\n", false)]
    public void Where_something_else_is_cleared_nothing_is_touched_unless_the_key_points_are_faced_with_it(string cleared, bool isRefused)
    {
        using var folder = Copied();
        Clear(folder, cleared);
        var outcome = ProbedJob.Make(folder["job.json"], Stated, TestContext.Current.CancellationToken);
        Assert.Equal(isRefused, !outcome.IsUsable);
        Assert.All(outcome.Refusals, r => Assert.Equal(("out-of-reach", "L1"), (r.Code, r.Place.Feature)));
    }

    // With Z0 at the bottom of the piece all cuts are above it, and stand in the ball's way all the same.
    [Fact]
    public void Where_Z0_is_at_the_bottom_the_part_is_as_much_in_the_way()
    {
        using var folder = Copied();
        File.WriteAllText(
            folder["counterpart.nc"],
            ZWord().Replace(
                File.ReadAllText(folder["counterpart.nc"]),
                z => FormattableString.Invariant($"Z{double.Parse(z.Groups["z"].Value, CultureInfo.InvariantCulture) + 30:0.0##}")));
        var wish = Stated with { TouchZ = 25, ClearanceZ = 60 };
        Assert.Equal(28, Probed(folder, wish).Points.Count);
        Assert.All(
            ProbedJob.Make(folder["job.json"], wish with { StylusDiameterMm = 60 }, TestContext.Current.CancellationToken).Refusals,
            r => Assert.Equal("out-of-reach", r.Code));
        Assert.False(
            ProbedJob.Make(folder["job.json"], wish with { StylusDiameterMm = 60 }, TestContext.Current.CancellationToken).IsUsable);

        // How deep to touch below what, nobody says.
        Assert.Equal("height-missing", ProbedJob.Make(
            folder["job.json"], wish with { TouchZ = null }, TestContext.Current.CancellationToken).Refusal!.Code);
    }

    // Where an arc of another plane clears something, nobody looked; nor how wide another tool cuts, nor where another piece lies.
    [Theory]
    [InlineData("N41 G0 X-85. Y-60.\nN42 G1 Z-3. F250.\nN43 G18 G3 X-75. I5. K0.\nN44 G17 G0 Z25.\n", "N43")]
    [InlineData("N41 T7 M6\nN42 G0 X-85. Y-60.\nN43 G1 Z-3. F250.\nN44 X-75.\nN45 G0 Z25.\nN46 T4 M6\n", "N43 N44")]
    [InlineData("N41 G55\nN42 G0 X-85. Y-60.\nN43 G1 Z-3. F250.\nN44 X-75.\nN45 G0 Z25.\nN46 G54\n", "N43 N44")]
    [InlineData("N41 G55\nN42 G0 X-85. Y-60.\nN43 G1 Z0.5 F250.\nN44 X-75.\nN45 G0 Z25.\nN46 G54\n", "N43 N44")]
    [InlineData("N42 G0 X-85. Y-60.\nN43 G1 Z-3. F250.\nN44 X-75.\nN45 G0 Z25.\n", null)]
    public void What_is_cleared_at_a_place_or_a_width_that_is_not_known_stops_the_program_with_its_blocks(string cleared, string? named)
    {
        using var folder = Copied();
        Clear(folder, cleared);
        Assert.Equal(named is null ? [] : [$"what is cleared by {named}"], Probed(folder, Stated).Program.Moves.Assumed);
    }

    // The ball goes down beside the counterpart only where the features' own tool cleared the room, in their work offset. Beside the left
    // shoulder another tool may have cut narrow grooves, and what is cut in another work offset is another piece.
    [Theory]
    [InlineData("", "", true)]
    [InlineData("T7 M6", "T4 M6", false)]
    [InlineData("G55", "G54", false)]
    public void Room_beside_the_counterpart_is_what_the_features_own_tool_cleared(string before, string after, bool hasRoom)
    {
        using var folder = Copied();
        var wide = Stated with { OfCounterpart = true, ApproachMm = 14, ToolNumber = null, Template = OwnTemplate(folder) };
        var near = AtShoulder();
        Clear(folder, $"{before}\nG0 X-95. Y-21.\nG1 Z-10. F250.\nX-65.\nY-16.\nX-95.\nY-11.\nX-65.\nG0 Z25.\n{after}\n");
        var far = AtShoulder();
        Assert.True(hasRoom ? far > near + 5 : far == near, $"{near} without, {far} with it");

        double AtShoulder() => Probed(folder, wide).Points.Single(p => p.Label == "1").ApproachMm;
    }

    // A slot of the part, 8 mm wide: a ball of 6 mm has 2 mm to go. 2 mm from one wall it would go down on the other.
    [Theory]
    [InlineData(8, 1)]
    [InlineData(8.5, 1.5)]
    [InlineData(20, 2)]
    public void In_a_narrow_slot_the_ball_goes_down_where_both_walls_are_farthest(double width, double approach)
    {
        using var folder = new TemporaryFolder();
        var y = FormattableString.Invariant($"{width / 2}");
        File.WriteAllText(
            folder["p.nc"],
            "%\nO1\nN10 G21 G17 G40 G90 G54\nN20 G0 X-30. Y-" + At(4) + "\nN30 G1 Z-10. F200.\nN40 X80.\nN50 G0 Z5.\nN60 X-30. Y"
                + At(4) + "\nN70 G1 Z-10.\nN80 X80.\nN90 G0 Z50.\nN95 M30\n%\n");
        File.WriteAllText(folder["theoretical.csv"], $"point,x_mm,y_mm\n1,0,-{y}\n2,50,-{y}\n3,0,{y}\n4,50,{y}\n");
        File.WriteAllText(folder["job.json"], """
            { "kind": "mating", "name": "Slot", "part": { "theoretical": "theoretical.csv", "measured": "part.csv" },
              "gauge": { "format": "points", "uncertaintyMm": 0.002, "stylusDiameterMm": 6 },
              "features": [
                { "name": "A", "kind": "line", "points": ["1", "2"], "blocks": ["N40"], "toleranceMm": [-0.02, 0.02] },
                { "name": "B", "kind": "line", "points": ["3", "4"], "blocks": ["N80"], "toleranceMm": [-0.02, 0.02] }],
              "counterpart": { "program": "p.nc", "dialect": "fanuc", "toolDiameterMm": 8 } }
            """);
        var probed = Probed(folder, new() { TouchZ = -5, ClearanceZ = 25, ToolNumber = 9 });
        Assert.All(probed.Points, p => Assert.Equal(approach, p.ApproachMm));

        string At(double off) => FormattableString.Invariant($"{(width / 2) + off:0.0##}");
    }

    [Fact]
    public void What_nobody_stated_stands_in_the_program_before_a_stop_and_before_the_first_move()
    {
        using var folder = Copied();
        var probed = Probed(folder, new());
        Assert.Equal(["ball 6", "touch at Z -5", "travel at Z 28"], probed.Program.Moves.Assumed);
        var text = Encoding.ASCII.GetString(probed.Program.Bytes.Span);
        Assert.Contains("(NOBODY STATED BALL 6, TOUCH AT Z -5, TRAVEL AT Z 28)", text, StringComparison.Ordinal);
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
        Assert.Equal("delta-nc300", probed.Program.Dialect.Name);
    }

    // A control that does not print by DPRNT cannot run what Fanuc does.
    [Theory]
    [InlineData("okuma-osp")]
    [InlineData("generic")]
    public void A_control_that_runs_no_template_is_refused_with_the_option_that_names_one(string dialect)
    {
        using var folder = Copied();
        var error = Assert.Throws<InputException>(() => Probed(folder, Stated with { Dialect = dialect }));
        Assert.Equal(("unknown-template", dialect), (error.Code, error.File));
        Assert.Contains("--template", error.Message, StringComparison.Ordinal);
        Assert.Throws<InputException>(() => Probed(folder, Stated with { Dialect = "heidenhain-klartext", Template = "fanuc" }));
    }

    [Fact]
    public void A_Klartext_job_gets_Klartext_and_the_mask_of_its_log()
    {
        using var folder = new TemporaryFolder();
        foreach (var file in Directory.GetFiles(Repository.PathTo("samples", "klartext-mating")))
        {
            File.Copy(file, folder[System.IO.Path.GetFileName(file)]);
        }

        var wish = Stated with { ClearanceZ = 60 };
        var probed = Probed(folder, wish);
        Assert.Equal(("heidenhain-klartext", "probe.h"), (probed.Program.Template.File, probed.FileName));
        Assert.Equal("EMPROBE.A", probed.Program.Beside!.Value.Name);
        Assert.Equal(8, Path(probed).Motions.Count(m => m.Kind == MotionKind.Probe));
        Assert.Equal(8, Probed(folder, wish with { OfCounterpart = true, TouchZ = -3 }).Points.Count);
        Assert.Null(Probed(folder, wish with { Dialect = "fanuc" }).Program.Beside);

        // After the touch the ball goes back to where it came from, and no farther: behind it may be another wall.
        string[] lines = Encoding.UTF8.GetString(probed.Program.Bytes.Span).Split('\n');
        var approach = lines.Single(l => l.StartsWith("; approach ", StringComparison.Ordinal)).Split(' ')[2];
        Assert.Equal(
            8,
            lines.Count(l => l.StartsWith("TCH PROBE 3.3 DIST +", StringComparison.Ordinal)
                && l.Split(' ').Contains("MB" + approach, StringComparer.Ordinal)));
    }

    [Fact]
    public void A_ball_that_does_not_fit_is_refused_with_the_point()
    {
        using var folder = Copied();

        // In the notch's edge of 1 mm and beside the tooth a ball of 30 mm meets both flanks of the part's tooth.
        var refusals = ProbedJob.Make(
            folder["job.json"], Stated with { StylusDiameterMm = 60 }, TestContext.Current.CancellationToken).Refusals;
        Assert.NotEmpty(refusals);
        Assert.All(refusals, r => Assert.Equal("out-of-reach", r.Code));
    }

    [Theory]
    [InlineData(-6, "clearance-too-low")]
    [InlineData(-5, "clearance-too-low")]
    [InlineData(-4, "clearance-too-low")]
    [InlineData(1.5, "clearance-too-low")]
    public void A_travel_below_the_touch_is_refused(double clearance, string code)
    {
        using var folder = Copied();
        Assert.Equal(code, ProbedJob.Make(
            folder["job.json"], Stated with { ClearanceZ = clearance }, TestContext.Current.CancellationToken).Refusal!.Code);
    }

    [Fact]
    public void A_template_of_the_shop_that_keeps_silent_about_assumptions_is_refused()
    {
        using var folder = Copied();
        var own = OwnTemplate(folder);
        var error = Assert.Throws<InputException>(() => Probed(folder, new() { Template = own }));
        Assert.Equal("bad-template", error.Code);
        Assert.Contains("touch at Z -5", error.Message, StringComparison.Ordinal);
        Assert.Equal(28, Probed(folder, Stated with { ToolNumber = null, Template = own }).Points.Count);
    }

    // The features are cut to Z-10. Deeper than that nobody knows what is there.
    [Fact]
    public void A_ball_that_reaches_below_the_features_stops_the_program()
    {
        using var folder = Copied();
        Assert.Equal(["a floor below Z -10.5"], Probed(folder, Stated with { TouchZ = -9 }).Program.Moves.Assumed);
        Assert.Empty(Probed(folder, Stated with { TouchZ = -8.5 }).Program.Moves.Assumed);

        // Another pocket, however deep, is no feature.
        File.WriteAllText(
            folder["counterpart.nc"],
            File.ReadAllText(folder["counterpart.nc"]).Replace(
                "N50 G0 X-92. Y-10.", "N41 G0 X-85. Y-60.\nN42 G1 Z-30. F250.\nN43 X-70.\nN44 G0 Z25.\nN50 G0 X-92. Y-10.",
                StringComparison.Ordinal));
        Assert.Equal(-5, Probed(folder, Stated with { TouchZ = null }).TouchZ);
    }

    // Something that is cleared before the features.
    private static void Clear(TemporaryFolder folder, string blocks) => File.WriteAllText(
        folder["counterpart.nc"],
        File.ReadAllText(folder["counterpart.nc"]).Replace("N50 G0 X-92. Y-10.", blocks + "N50 G0 X-92. Y-10.", StringComparison.Ordinal));

    private static (VirtualControl Control, VirtualPart Part, string Log) Executed(
        ProbedJob probed, RigidTransform2 frame, double offByRadii)
    {
        var part = new VirtualPart([.. DovetailGroove.Polygon().Select(p => frame.Inverse().Apply(p))], Ball);
        var control = new VirtualControl(part, Ball, TopZ)
        {
            OffByRadii = offByRadii,
            FirstAnswer = probed.Program.Dialect.Name == "haas" ? 185 : 135,
        };
        var mask = probed.Program.Beside is { } beside ? Encoding.ASCII.GetString(beside.Bytes.Span) : null;
        return (control, part, control.Run(Encoding.ASCII.GetString(probed.Program.Bytes.Span), mask));
    }

    private static string OwnTemplate(TemporaryFolder folder, string offset = "G54")
    {
        File.WriteAllText(
            folder["own.txt"],
            $"@body\nG17 G21 G90 G94 {offset}\n@each point\nG0 X{{approach.x}}\nG31 X{{overtravel.x}} F{{feed.measuring}}\n@next\nM30\n");
        return folder["own.txt"];
    }

    private static NcPath Path(ProbedJob probed) => NcInterpreter.Run(
        NcProgram.Read(probed.Program.Bytes, probed.Program.Dialect.Syntax), probed.Program.Dialect);

    private static ProbedJob Probed(TemporaryFolder folder, ProbeWish wish)
    {
        var outcome = ProbedJob.Make(folder["job.json"], wish, TestContext.Current.CancellationToken);
        Assert.True(outcome.IsUsable, outcome.Refusal?.ToString());
        return outcome.Result!;
    }

    private static MatchedProgram Matched(TemporaryFolder folder, string job, string log)
    {
        var run = MatingRun.Run(
            new JobFiles(folder[job]), new() { Part = new(folder[log]) }, TestContext.Current.CancellationToken);
        Assert.True(run.IsUsable, run.Refusal?.ToString());
        return run.Result;
    }

    // The part as its own drawing has it, where the program has its mirror image.
    private static void Mirror(TemporaryFolder folder)
    {
        File.WriteAllText(
            folder["job.json"],
            File.ReadAllText(folder["job.json"]).Replace("\"mirror\": \"none\"", "\"mirror\": \"x\"", StringComparison.Ordinal));
        var lines = File.ReadAllLines(folder["theoretical.csv"]);
        File.WriteAllLines(folder["theoretical.csv"], lines.Select((l, i) => i == 0 ? l : Mirrored(l.Split(','))));

        static string Mirrored(string[] cells) =>
            $"{cells[0]},{(cells[1].StartsWith('-') ? cells[1][1..] : "-" + cells[1])},{cells[2]}";
    }

    // The part as its own drawing has it, turned against the program.
    private static RigidTransform2 Turn(TemporaryFolder folder, double degrees)
    {
        var frame = new RigidTransform2(Geometry.Mirror.None, Angle.FromDegrees(degrees), Vector2.Zero);
        File.WriteAllText(
            folder["job.json"],
            File.ReadAllText(folder["job.json"]).Replace(
                "\"rotateDeg\": 0", FormattableString.Invariant($"\"rotateDeg\": {degrees}"), StringComparison.Ordinal));
        var lines = File.ReadAllLines(folder["theoretical.csv"]);
        File.WriteAllLines(folder["theoretical.csv"], lines.Select((l, i) => i == 0 ? l : Turned(l.Split(','))));
        return frame;

        string Turned(string[] cells)
        {
            var at = frame.Inverse().Apply(new Point2(
                double.Parse(cells[1], CultureInfo.InvariantCulture), double.Parse(cells[2], CultureInfo.InvariantCulture)));
            return string.Create(CultureInfo.InvariantCulture, $"{cells[0]},{at.X:0.000000},{at.Y:0.000000}");
        }
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

    [GeneratedRegex("Z(?<z>-?[0-9.]+)", RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex ZWord();

    [GeneratedRegex("^(G[0-9]+ [XYZ]|G65|G0 G43|L )", RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex FirstMove();
}
