using System.Text;
using ErrorMatching.Json;
using ErrorMatching.Nc;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell.Tests;

/// <summary>Corrections by offsets of the control on their way through a cell.</summary>
public sealed class OffsetCellTests
{
    [Fact]
    public async Task An_offset_is_sent_as_a_program_and_a_revert_sends_the_one_that_takes_it_back()
    {
        await using var cell = OffsetCell.Of();
        cell.Start();
        cell.Drop("part_S1.csv", OffsetCell.Grown(0.02));
        var sent = await cell.Until(1, CorrectionState.Verified);
        var program = OffsetCell.Sent(cell);
        Assert.Equal(ContentHash.Sha256(program), sent.ProgramSha256);

        // Positive moves the tool away from the contour, and the boss must grow with its part.
        Assert.Equal("offset-radius(1, 0.0200, 0.0200)", Stated.As(sent.Offset!.Parts[0]));
        Assert.Equal(0.02, sent.LargestMm!.Value, 6);
        Assert.Equal(sent.LargestMm, sent.SumMm);
        var text = Encoding.ASCII.GetString(program);
        Assert.Contains("G10 L1 P1 R[#502+[0.02]]", text, StringComparison.Ordinal);
        var marker = Marker.Find(NcProgram.Read(program, NcDialects.Named("linuxcnc").Syntax))[0].Marker!;
        Assert.Equal((sent.MeasurementSha256, sent.BaseSha256), (marker.MeasurementSha256, marker.BaseSha256));

        // Everything that people read says so.
        Assert.All(
            cell.Store.Corrections.StepsOf(1).Where(s => s.To is CorrectionState.Computed or CorrectionState.Proposed),
            s => Assert.Contains("offset-radius(1, 0.0200, ", Stated.As(s.Basis), StringComparison.Ordinal));
        Assert.Contains(
            cell.Store.AuditEntries(0, 99),
            e => e.What == "proposed" && Stated.As(e.Basis).StartsWith("offset-radius(1, ", StringComparison.Ordinal));
        var report = ReportReader.Document(cell.Store.Content(sent.ReportSha256!)).Object("correction").Object("program");
        Assert.Equal(sent.ProgramSha256, report.Text("sha256"));

        await cell.StopAsync();
        var reverted = await Revert(cell, 1);
        var undo = OffsetCell.Sent(cell);
        Assert.Equal(
            (CorrectionState.Reverted, ContentHash.Sha256(undo), ContentHash.Sha256(undo)),
            (reverted.State, reverted.UndoSha256, cell.Store.Slot("m1", "A").ProgramSha256));
        Assert.Contains("G10 L1 P1 R[#502+[0.0]]", Encoding.ASCII.GetString(undo), StringComparison.Ordinal);
        Assert.Equal(OffsetCell.Cutting, File.ReadAllText(cell.PathOf("job/boss.ngc")));
        Assert.Null(cell.Store.VerifyAudit());

        // The cell knows what it sent last: the next piece replaces it.
        new CorrectionDecisions(cell.Store).Release(1, "sam", null);
        cell.Start();
        cell.Drop("part_S2.csv", OffsetCell.Shifted(0.01, -0.02));
        var next = await cell.Until(2, CorrectionState.Verified);
        Assert.Equal("offset-radius(1, 0.0000, 0.0000); offset-work(1, 0.0100, -0.0200, 0.0100, -0.0200)", Stated.As(next.Offset));
        Assert.Equal(Math.Sqrt((0.01 * 0.01) + (0.02 * 0.02)), next.LargestMm!.Value, 6);
    }

    // A turn moves the places most that are far from its middle, whatever the key points show: here the beginning of N20, 26 mm before the
    // middle of the rectangle and 15 mm beside it.
    [Fact]
    public async Task A_turn_counts_by_the_place_that_it_moves_most()
    {
        await using var cell = OffsetCell.Of(allow: "\"work-offset\"");
        cell.Start();
        cell.Drop("part_S1.csv", OffsetCell.Turned(0.015));
        var sent = await cell.Until(1, CorrectionState.Verified);
        Assert.True(sent.Offset!.Parts[0].Is(RecordedOffset.WorkTurned));
        Assert.Equal(0.015, double.Parse(sent.Offset.Parts[0].Values[3].Words!, System.Globalization.CultureInfo.InvariantCulture), 0.0001);
        Assert.Equal(Math.Sqrt((26 * 26) + (15 * 15)) * 0.015 * Math.PI / 180, sent.LargestMm!.Value, 0.0001);
    }

    // What an earlier piece left in the control must go.
    [Fact]
    public async Task A_piece_that_needs_no_correction_gets_a_program_that_takes_earlier_ones_out()
    {
        await using var cell = OffsetCell.Of(allow: "\"tool-wear\"");
        cell.Start();
        cell.Drop("part_S1.csv", OffsetCell.Grown(0.02));
        await cell.Until(1, CorrectionState.Verified);
        new CorrectionDecisions(cell.Store).Release(1, "sam", null);
        cell.Drop("part_S2.csv", OffsetCell.Grown(0.001));
        var none = await cell.Until(2, CorrectionState.Verified);
        Assert.Equal((0, "offset-radius(1, 0.0000, 0.0000)"), (none.LargestMm, Stated.As(none.Offset)));
        Assert.Contains("R[#502+[0.0]]", Encoding.ASCII.GetString(OffsetCell.Sent(cell)), StringComparison.Ordinal);
    }

    [Fact]
    public async Task What_no_offset_brings_is_refused_by_name_and_nothing_is_sent()
    {
        await using var cell = OffsetCell.Of();
        cell.Start();
        cell.Drop("part_S1.csv", OffsetCell.Wider(0.02));
        Assert.Equal("offset-insufficient", (await cell.Until(1, CorrectionState.Refused)).Code);

        // Beyond the step of the job, and within it but beyond the limit of the cell.
        cell.Drop("part_S2.csv", OffsetCell.Grown(0.06));
        Assert.Equal("offset-insufficient", (await cell.Until(2, CorrectionState.Refused)).Code);
        cell.Configuration = OffsetCell.Configuration("part", """{ "approve": "automatic", "limitMm": 0.03 }""");
        await cell.StopAsync();
        cell.Start();
        cell.Drop("part_S3.csv", OffsetCell.Grown(0.04));
        Assert.Equal("over-limit", (await cell.Until(3, CorrectionState.Refused)).Code);
        cell.Drop("part_S4.csv", OffsetCell.Shifted(0.028, 0.012));
        Assert.Equal("over-limit", (await cell.Until(4, CorrectionState.Refused)).Code);
        Assert.Empty(Directory.EnumerateFiles(cell.PathOf("m1")));
    }

    // Each is 0.04 mm from the uncorrected offset, and the second 0.08 mm from the first: LinuxCNC would stop at it.
    [Fact]
    public async Task An_offset_further_than_a_step_from_the_one_before_is_not_sent_until_that_is_taken_back()
    {
        await using var cell = OffsetCell.Of(allow: "\"tool-wear\"");
        cell.Start();
        cell.Drop("part_S1.csv", OffsetCell.Grown(0.04));
        await cell.Until(1, CorrectionState.Verified);
        var first = OffsetCell.Sent(cell);
        new CorrectionDecisions(cell.Store).Release(1, "sam", null);
        cell.Drop("part_S2.csv", OffsetCell.Grown(-0.04));
        var second = await cell.Until(2, CorrectionState.Failed);
        Assert.Equal(
            ("offset-step-too-large", "offset-step-too-large(0.0400, -0.0400, 0.0500, 1)"), (second.Code, Stated.As(second.Reason)));
        Assert.Equal(first, OffsetCell.Sent(cell));

        // Approved as it is, it fails again; behind the program that takes the first one back, it is sent.
        var steps = cell.Store.Corrections.StepsOf(2).Count;
        new CorrectionDecisions(cell.Store).Approve(2, "sam", null);
        await RunningCell.Until(() => cell.Store.Corrections.StepsOf(2).Count >= steps + 3);
        Assert.Equal(CorrectionState.Failed, cell.Store.Find(2)!.State);
        Assert.Equal(first, OffsetCell.Sent(cell));
        await cell.StopAsync();
        await Revert(cell, 1);
        new CorrectionDecisions(cell.Store).Release(1, "sam", null);
        new CorrectionDecisions(cell.Store).Approve(2, "sam", null);
        cell.Start();
        await cell.Until(2, CorrectionState.Verified);
        Assert.Contains("R[#502+[-0.04]]", Encoding.ASCII.GetString(OffsetCell.Sent(cell)), StringComparison.Ordinal);

        // From there to 0.01 is a step of the limit itself.
        new CorrectionDecisions(cell.Store).Release(2, "sam", null);
        cell.Drop("part_S3.csv", OffsetCell.Grown(0.01));
        await cell.Until(3, CorrectionState.Verified);
    }

    [Fact]
    public async Task In_feedback_offsets_add_up_and_a_revert_goes_back_to_the_one_before()
    {
        await using var cell = OffsetCell.Of("counterpart", "\"tool-wear\"", more: ", \"totalMm\": 0.045", uncertaintyMm: 0.0005);
        cell.Start();
        cell.Drop("part_S1.csv", OffsetCell.Grown(0));
        await cell.Until(1, CorrectionState.Recorded);

        // The counterpart is too small by this: the tool cut too much.
        cell.Drop("counterpart_S1.csv", OffsetCell.Grown(-0.02));
        var first = await cell.Until(2, CorrectionState.Verified);
        Assert.Equal("offset-radius(1, 0.0200, 0.0200)", Stated.As(first.Offset));
        new CorrectionDecisions(cell.Store).Release(2, "sam", null);

        // The tool wears: one piece may be a chip, several of them are the process.
        var (second, third, measured) = (first, first, 0);
        while (Total(third) == 0.02m)
        {
            Assert.True(++measured < 9);
            cell.Drop(FormattableString.Invariant($"counterpart_{measured}.csv"), OffsetCell.Grown(-0.008 - (measured * 1e-6)));
            (second, third) = (third, await cell.Until(third.Id + 1, CorrectionState.Verified));
            Assert.Equal(second.ProgramSha256, third.BaseSha256);
            if (Total(third) == 0.02m) new CorrectionDecisions(cell.Store).Release(third.Id, "sam", null);
        }

        var (before, total) = (Total(second), Total(third));
        Assert.InRange(total, before + 0.003m, 0.03m);
        Assert.Equal((double)total, third.SumMm!.Value, 6);
        Assert.Equal((double)(total - before), third.LargestMm!.Value, 6);
        Assert.Contains(FormattableString.Invariant($"ABS[#503-[{before}]]"), Encoding.ASCII.GetString(OffsetCell.Sent(cell)),
            StringComparison.Ordinal);

        await cell.StopAsync();
        await Revert(cell, third.Id);
        var undo = Encoding.ASCII.GetString(OffsetCell.Sent(cell));
        Assert.Contains(FormattableString.Invariant($"R[#502+[{before}]]"), undo, StringComparison.Ordinal);
        Assert.Contains(FormattableString.Invariant($"ABS[#503-[{total}]]"), undo, StringComparison.Ordinal);

        // What builds on it is not sent, and the next piece starts from what is there again.
        new CorrectionDecisions(cell.Store).Release(third.Id, "sam", null);
        cell.Start();
        cell.Drop("counterpart_next.csv", OffsetCell.Grown(-0.0079));
        var next = await cell.Until(third.Id + 1, CorrectionState.Verified);
        Assert.Equal(second.ProgramSha256, next.BaseSha256);
    }

    // Its name at the machine may be that of a program which cuts.
    [Fact]
    public async Task A_program_of_offsets_does_not_replace_one_that_cuts()
    {
        await using var cell = OffsetCell.Of();
        File.WriteAllText(cell.PathOf("m1/" + OffsetCell.Program), OffsetCell.Cutting);
        cell.Start();
        cell.Drop("part_S1.csv", OffsetCell.Grown(0.02));
        Assert.Equal("changed-at-machine", (await cell.Until(1, CorrectionState.Failed)).Code);
        Assert.Equal(OffsetCell.Cutting, Encoding.ASCII.GetString(OffsetCell.Sent(cell)));
    }

    // Both together would correct twice.
    [Theory]
    [InlineData("\"tool-wear\"", "\"blocks\"")]
    [InlineData("\"blocks\"", "\"tool-wear\"")]
    public async Task A_job_does_not_go_from_offsets_to_blocks_or_back(string first, string then)
    {
        await using var cell = OffsetCell.Of(allow: first);
        cell.Start();
        cell.Drop("part_S1.csv", OffsetCell.Grown(0.02));
        var sent = await cell.Until(1, CorrectionState.Verified);
        Assert.Equal(first.Contains("blocks", StringComparison.Ordinal), sent.Offset is null);
        new CorrectionDecisions(cell.Store).Release(1, "sam", null);
        cell.Change("job/job.json", $"[{first}]", $"[{then}]");
        cell.Drop("part_S2.csv", OffsetCell.Grown(0.01));
        Assert.Equal("correction-kind-changed", (await cell.Until(2, CorrectionState.Refused)).Code);
        Assert.Equal(sent.ProgramSha256, ContentHash.Sha256(OffsetCell.Sent(cell)));
    }

    [Theory]
    [InlineData("part", "\"tool-wear\", \"blocks\"", OffsetCell.Program, "$.jobs[0].job", "offsets-in-cell")]
    [InlineData("part", "\"tool-wear\"", "boss.ngc", "$.jobs[0].slot", "offsets-over-program")]
    public async Task A_configuration_that_would_mix_them_is_refused(string from, string allow, string program, string path, string code)
    {
        await using var cell = OffsetCell.Of(from, allow);
        cell.Configuration = OffsetCell.Configuration(from, "{ \"approve\": \"automatic\" }", program);
        var refusal = Assert.Single(Assert.Throws<Refusals.InputException>(() => cell.Settings).Refusals);
        Assert.Equal((path, code), (refusal.Place.Path, refusal.Code));
    }

    [Fact]
    public async Task Jobs_that_share_a_slot_or_variables_must_fit_together()
    {
        await using var cell = OffsetCell.Of(allow: "\"tool-wear\"");
        var job = File.ReadAllText(cell.PathOf("job/job.json"));
        var one = OffsetCell.Configuration("part", "{ \"approve\": \"automatic\" }");
        string Codes(string other)
        {
            File.WriteAllText(cell.PathOf("job/other.json"), other);
            var from = one.IndexOf("{ \"name\": \"boss\"", StringComparison.Ordinal);
            var first = one[from..one.IndexOf("],\n\"policy\"", StringComparison.Ordinal)];
            var second = first.Replace("\"boss\"", "\"other\"", StringComparison.Ordinal)
                .Replace("job.json", "other.json", StringComparison.Ordinal)
                .Replace("^part", "^other", StringComparison.Ordinal);
            cell.Configuration = one.Replace(first, first + ", " + second, StringComparison.Ordinal);
            try
            {
                return string.Join(' ', cell.Settings.Warnings.Select(w => w.Code));
            }
            catch (Refusals.InputException e)
            {
                return string.Join(' ', e.Refusals.Select(r => $"{r.Code} at {r.Place.Path}"));
            }
        }

        Assert.Equal("slot-of-both at $.jobs[1].slot", Codes(job.Replace("\"tool-wear\"", "\"blocks\"", StringComparison.Ordinal)));
        Assert.Equal("offset-variables-overlap at $.jobs[1].job", Codes(job.Replace("501", "510", StringComparison.Ordinal)));
        const string Warned = "offsets-not-callable offsets-of-one-control offsets-not-callable";
        Assert.Equal(Warned, Codes(job.Replace("501", "511", StringComparison.Ordinal)));
        Assert.Equal(Warned, Codes(job));
    }

    [Fact]
    public async Task Feedback_by_offsets_must_accumulate()
    {
        await using var cell = OffsetCell.Of("counterpart", "\"tool-wear\"");
        cell.Configuration = cell.Configuration.Replace(", \"accumulates\": true", "", StringComparison.Ordinal);
        var refusals = Assert.Throws<Refusals.InputException>(() => cell.Settings).Refusals;
        Assert.Equal(["$.jobs[0].job", "$.jobs[1].job"], refusals.Select(r => r.Place.Path));
        Assert.All(refusals, r => Assert.Equal("offsets-accumulate", r.Code));
    }

    private static decimal Total(Correction correction) => decimal.Parse(
        correction.Offset!.Parts[0].Values[2].Sentence, System.Globalization.CultureInfo.InvariantCulture);

    private static Task<Correction> Revert(ConfiguredCell cell, long id) =>
        new SlotReversal(cell.Settings, cell.Store, cell.Opens, TimeProvider.System).RevertAsync(
            id, "sam", "chatter", TestContext.Current.CancellationToken);
}
