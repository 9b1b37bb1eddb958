using System.Text.Json;
using ErrorMatching.Mating;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

public sealed class MatingRunTests
{
    private static readonly string Job = Repository.PathTo("samples", "complex-mating", "job.json");

    [Fact]
    public void Bytes_give_what_their_file_gives()
    {
        var file = Repository.PathTo("samples", "complex-mating", "counterpart-after.csv");
        var program = Repository.PathTo("samples", "complex-mating", "counterpart.nc");
        var byFile = Matched(new() { Part = new(file), Program = new(program) });
        var byBytes = Matched(new() { Part = new(file, File.ReadAllBytes(file)), Program = new(program, File.ReadAllBytes(program)) });
        Assert.Equal(byFile.Program.ToArray(), byBytes.Program.ToArray());
        Assert.Equal(byFile.ReportJson(), byBytes.ReportJson());
        Assert.Equal(byFile.ReportHtml(), byBytes.ReportHtml());
    }

    [Fact]
    public void What_is_given_as_bytes_is_no_file_to_be_spared()
    {
        var files = new JobFiles(Job);
        Assert.NotNull(
            MatingRun.Run(
                files,
                new() { Part = new("part.csv", File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "part.csv"))) },
                TestContext.Current.CancellationToken).Result);
        Assert.Equal(["job.json", "theoretical.csv", "counterpart.nc"], files.Opened.Select(Path.GetFileName));
    }

    // The part's file of the sample as Q-DAS writes it: what it is in part.dfd, what was measured in part.dfx.
    [Fact]
    public void A_measurement_in_two_files_gives_what_one_gives_and_neither_is_written_to()
    {
        using var folder = new TemporaryFolder();
        var rows = File.ReadLines(Repository.PathTo("samples", "complex-mating", "part.csv")).Skip(1).Select(l => l.Split(',')).ToArray();
        var values = rows.SelectMany(r => new[] { (Name: r[0] + ".X", Value: r[1]), (Name: r[0] + ".Y", Value: r[2]) }).ToArray();
        File.WriteAllText(
            folder["part.dfd"],
            FormattableString.Invariant($"K0100 {values.Length}\n")
                + string.Concat(values.Select((v, i) => FormattableString.Invariant($"K2002/{i + 1} {v.Name}\nK2142/{i + 1} mm\n"))));
        File.WriteAllText(folder["part.dfx"], string.Join('\u000f', values.Select(v => v.Value + "\u00140")));
        var files = new JobFiles(Job);
        var matched = MatingRun.Run(files, new() { Part = new(folder["part.dfx"]) }, TestContext.Current.CancellationToken).Result!;
        Assert.Equal(
            ["job.json", "theoretical.csv", "part.dfx", "part.dfd", "counterpart.nc"], files.Opened.Select(f => Path.GetFileName(f)));

        // The marker names the measurement, which has another hash.
        static string[] Blocks(MatchedProgram p) =>
            [.. System.Text.Encoding.Latin1.GetString(p.Program.Span).Split('\n').Where(l => l.StartsWith('N'))];
        Assert.Equal(Blocks(Matched(new())), Blocks(matched));
    }

    [Fact]
    public void A_gain_takes_the_place_of_the_job_s_and_the_report_says_so()
    {
        var (whole, half) = (Matched(new()), Matched(new() { Gain = 0.5 }));
        Assert.All(whole.Report.KeyPoints.Zip(half.Report.KeyPoints), p => Assert.Equal(p.First.Correction * 0.5, p.Second.Correction));
        Assert.Equal(0.5, half.Report.Compensation.Gain);
        Assert.Contains("A gain of 0.5 took the place of the job's, which is 1.", half.Report.Notes);
        Assert.Equal(whole.Report.Notes, Matched(new() { Gain = 1 }).Report.Notes);
        foreach (var none in new[] { 0, -1, 2.1, double.NaN })
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => Matched(new() { Gain = none }));
        }
    }

    [Fact]
    public void A_report_that_nobody_timed_says_no_time()
    {
        using var untimed = JsonDocument.Parse(Matched(new()).ReportJson());
        Assert.Equal(JsonValueKind.Null, untimed.RootElement.GetProperty("time").GetProperty("calculatingS").ValueKind);
        using var timed = JsonDocument.Parse(Matched(new() { ElapsedS = () => 0.25 }).ReportJson());
        Assert.Equal(0.25, timed.RootElement.GetProperty("time").GetProperty("calculatingS").GetDouble());
    }

    [Fact]
    public void A_measured_counterpart_that_is_not_there_is_warned_of_and_feedback_says_where_the_job_names_it()
    {
        const string Warning = "The measured counterpart \"nope.csv\" is not there; expected the file of the one that was cut without "
            + "compensation, or no key counterpart.measured: as it is, no counterpart can be compared in a cell.";
        using var folder = new TemporaryFolder();
        foreach (var file in new[] { "theoretical.csv", "part.csv", "counterpart.nc", "counterpart.csv" })
        {
            File.Copy(Repository.PathTo("samples", "complex-mating", file), folder[file]);
        }

        var text = File.ReadAllText(Job).Replace(
            "\"measured\": \"counterpart.csv\"", "\"measured\": \"nope.csv\"", StringComparison.Ordinal);
        var (there, gone) = (Run(Job, new()), Run(folder.File("job.json", text), new()));
        Assert.Equal([.. there.Report.Warnings.Select(w => w.Message), Warning], gone.Report.Warnings.Select(w => w.Message));
        Assert.Equal(there.Program.ToArray(), gone.Program.ToArray());
        Assert.Equal(("measured-not-there", "nope.csv"), (gone.Report.Warnings[^1].Code, Assert.Single(gone.Report.Warnings[^1].Values)));
        Assert.Equal(
            there.Report.Warnings.Count,
            Run(folder["job.json"], new() { Counterpart = new(folder["counterpart.csv"]) }).Report.Warnings.Count);

        // In feedback it is needed: what is wrong stands in line 20 of the job, from column 17 on.
        var feedback = folder.File(
            "feedback.json", text.Replace("\"from\": \"part\"", "\"from\": \"counterpart\"", StringComparison.Ordinal));
        var item = Assert.Single(Assert.Throws<InputException>(() => Run(feedback, new())).Refusals);
        Assert.Equal(
            ("file-unreadable", feedback, 20, 17, "$.counterpart.measured"),
            (item.Code, item.Place.File, item.Place.Line, item.Place.Column, item.Place.Path));
        Assert.StartsWith(folder["nope.csv"] + ": ", item.Message, StringComparison.Ordinal);
        Assert.NotNull(Run(feedback, new() { Counterpart = new(folder["counterpart.csv"]) }));

        static MatchedProgram Run(string job, MatingRequest request) =>
            MatingRun.Run(new(job), request, TestContext.Current.CancellationToken).Result!;
    }

    [Fact]
    public void The_report_names_the_program_where_it_will_stand()
    {
        Assert.Equal("counterpart.nc", Matched(new()).Report.Program.File);
        var matched = Matched(new() { Folder = "out" });
        Assert.Equal((Path.Combine("out", "counterpart.nc"), "counterpart.nc"), (matched.Report.Program.File, matched.Name));
    }

    [Fact]
    public void A_refusal_has_a_code_and_the_block()
    {
        using var folder = new TemporaryFolder();
        var matched = Matched(new() { Folder = folder.Path });
        var again = MatingRun.Run(
            new(Job), new() { Program = new("counterpart.nc", matched.Program) }, TestContext.Current.CancellationToken);
        Assert.Null(again.Result);
        var refusal = Assert.Single(again.Refusals);
        Assert.Equal(("already-compensated", "counterpart.nc"), (refusal.Code, refusal.Place.File));
        Assert.NotNull(refusal.Place.Block);
    }

    [Fact]
    public void Points_that_determine_nothing_name_their_file()
    {
        // A datum of two points that lie on one another has no direction.
        var text = File.ReadAllText(Job).Replace(
            "\"kind\": \"none\"", "\"kind\": \"datum\", \"origin\": \"1\", \"direction\": \"2\"", StringComparison.Ordinal);
        var job = MatingJob.Parse(System.Text.Encoding.UTF8.GetBytes(text), Job);
        var points = "point,x_mm,y_mm\n" + string.Concat(job.NeededPoints.Select(p => p + ",-36,40\n"));
        var e = Assert.Throws<InputException>(() => MatingRun.Run(
            new(job), new() { Part = new("part.csv", System.Text.Encoding.UTF8.GetBytes(points)) }, TestContext.Current.CancellationToken));
        Assert.Equal("part.csv", e.File);
        Assert.StartsWith("part.csv: ", e.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_cancelled_run_computes_nothing() =>
        Assert.Throws<OperationCanceledException>(() => MatingRun.Run(new(Job), new(), new CancellationToken(canceled: true)));

    private static MatchedProgram Matched(MatingRequest request) =>
        MatingRun.Run(new(Job), request, TestContext.Current.CancellationToken).Result!;
}
