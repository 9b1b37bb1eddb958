using System.Globalization;
using System.Security.Cryptography;
using System.Text;
using ErrorMatching.Mating;
using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

public sealed class CorrectionComputerTests
{
    public static TheoryData<string> Requests =>
        ["complex-mating", "curve-mating", "circle-mating", "slot-mating", "surface-one", "surface-one displaced"];

    [Theory]
    [MemberData(nameof(Requests))]
    public void Same_inputs_give_the_same_bytes(string name)
    {
        var (one, other) = (Samples.Program(Request(name)), Samples.Program(Request(name)));
        Assert.True(one.Program.Span.SequenceEqual(other.Program.Span));
        Assert.True(one.Report.Span.SequenceEqual(other.Report.Span));
        Assert.True(one.Page.Span.SequenceEqual(other.Page.Span));
        Assert.Equal(one.Sums.ToJson(), other.Sums.ToJson());
        Assert.Equal(one.Basis.Identity, other.Basis.Identity);
    }

    [Theory]
    [MemberData(nameof(Requests))]
    public void A_correction_stands_on_what_it_was_identified_by(string name)
    {
        var request = Request(name);
        var identified = Assert.IsType<Identified>(new CorrectionComputer(Samples.NoLimits).Identify(request)).Basis;
        var computed = Samples.Program(request with { Identity = identified.Identity }).Basis;
        Assert.Equal(
            (identified.Identity, identified.JobSha256, identified.BaseSha256),
            (computed.Identity, computed.JobSha256, computed.BaseSha256));
        Assert.Equal(Sha256(File.ReadAllBytes(request.Job.File)), Sha256(computed.Job.Span));
        Assert.Equal(computed.JobSha256, Sha256(computed.Job.Span));
        Assert.Equal(computed.BaseSha256, computed.Base is { } bytes ? Sha256(bytes.Span) : null);
        Assert.Equal(name == "surface-one", computed.Base is null);
    }

    [Theory]
    [InlineData("job.json")]
    [InlineData("theoretical.csv")]
    [InlineData("counterpart.nc")]
    public void A_job_that_changed_after_it_was_recognized_is_refused(string file)
    {
        using var folder = new TemporaryFolder();
        var request = Samples.Part("complex-mating") with { Job = Samples.Copied(folder) };
        var computer = new CorrectionComputer(Samples.NoLimits);
        request = request with { Identity = Assert.IsType<Identified>(computer.Identify(request)).Basis.Identity };
        Assert.IsType<ComputedProgram>(Samples.Compute(request));
        File.AppendAllText(folder[file], "\n");
        Assert.Equal(CorrectionCodes.JobChanged, Samples.Refusal(request).Code);
    }

    // A control's log arrives as a gauge's file does. Its points have no labels, so they have the order of the theoretical file.
    [Fact]
    public void A_log_of_a_control_gives_what_its_table_gives()
    {
        var part = Samples.Part("complex-mating");
        var rows = System.Text.Encoding.UTF8.GetString(part.Measurement.Bytes.Span)
            .Split('\n', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries).Skip(1).Select(l => l.Split(','));
        var log = string.Concat(rows.Select(r => $"[PRB:{r[1]},{r[2]},-5.000:1]\r\nok\r\n"));
        var logged = part with { Measurement = new("probe.log", System.Text.Encoding.UTF8.GetBytes(log)) };
        Assert.Equal(Blocks(Samples.Program(part)), Blocks(Samples.Program(logged)));
        var missed = log.Replace(":1]\r\nok\r\n[PRB:-32.3", ":0]\r\nok\r\n[PRB:-32.3", StringComparison.Ordinal);
        Assert.NotEqual(log, missed);
        Assert.Equal(
            "missed-touch",
            Samples.Refusal(part with { Measurement = new("probe.log", System.Text.Encoding.UTF8.GetBytes(missed)) }).Code);

        // The marker has the hash of the measurement.
        static string[] Blocks(ComputedProgram computed) =>
            [.. System.Text.Encoding.Latin1.GetString(computed.Program.Span).Split('\n').Where(l => l.StartsWith('N'))];
    }

    [Fact]
    public void A_part_within_tolerance_gives_the_original_program()
    {
        var computed = Samples.Program(
            Samples.Part("complex-mating") with { Measurement = Samples.File("complex-mating", "theoretical.csv") });
        Assert.Equal(File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "counterpart.nc")), computed.Program.ToArray());
        Assert.Equal((0, 0.0, 0.0, ""), (computed.ChangedWords!.Value, computed.LargestMm, computed.SumMm, computed.LargestAt));
        Assert.Equal(0, computed.Sums.Largest!.LengthMm);
    }

    [Fact]
    public void The_gain_of_the_policy_takes_the_place_of_the_job_s()
    {
        var whole = Samples.Program(Samples.Part("complex-mating"));
        var half = Samples.Program(Samples.Part("complex-mating"), Samples.NoLimits with { Gain = 0.5 });

        // On a corner, half the correction is not half the way of the vertex.
        Assert.InRange(half.LargestMm / whole.LargestMm, 0.45, 0.55);
        Assert.All(whole.Corrections.Zip(half.Corrections), p => Assert.Equal((p.First.X / 2, p.First.Y / 2), (p.Second.X, p.Second.Y)));
        Assert.NotEqual(whole.Basis.Identity, half.Basis.Identity);
        Assert.Contains(
            "A gain of 0.5 took the place of the job", System.Text.Encoding.UTF8.GetString(half.Report.Span), StringComparison.Ordinal);

        var own = Samples.Part("complex-mating");
        own = own with { Job = own.Job with { Policy = Samples.NoLimits with { Gain = 0.5 } } };
        Assert.True(Samples.Program(own).Program.Span.SequenceEqual(half.Program.Span));
    }

    [Fact]
    public void A_refusal_with_values_is_stated_by_its_code_and_not_by_its_sentence()
    {
        var request = Samples.Part("complex-mating");
        var moved = Encoding.UTF8.GetString(request.Measurement.Bytes.Span).Split('\n')
            .Select(l => l.Split(',') is [var point, var x, var y, ..] && double.TryParse(x, CultureInfo.InvariantCulture, out var mm)
                ? string.Create(CultureInfo.InvariantCulture, $"{point},{mm + 3},{y.Trim()}")
                : l);
        var refused = Samples.Refusal(
            request with { Measurement = request.Measurement with { Bytes = Encoding.UTF8.GetBytes(string.Join('\n', moved)) } });
        Assert.Equal("implausible-deviation", refused.Code);
        Assert.Equal(
            ["implausible-deviation", "implausible-deviation", "implausible-deviation", "and-more"],
            refused.Reason.Parts.Select(p => p.Code));
        Assert.All(refused.Reason.Parts.SkipLast(1), p => Assert.Same(RefusalForms.ImplausibleDeviation, p.Form));
    }

    // The flanks of the triangle turn: at N150, where they meet, the program moves further than at any key point.
    [Fact]
    public void A_step_beyond_the_limit_is_refused_and_says_where()
    {
        var computed = Samples.Program(Samples.Part("complex-mating"), Samples.NoLimits with { LimitMm = 0.3 });
        Assert.Equal("block N150", computed.LargestAt.Sentence);
        Assert.InRange(computed.LargestMm, computed.Corrections.Max(c => c.LengthMm), 0.3);
        Assert.Equal(computed.LargestMm, computed.SumMm);
        var refused = Samples.Refusal(Samples.Part("complex-mating"), Samples.NoLimits with { LimitMm = computed.LargestMm - 0.001 });
        Assert.Equal(CorrectionCodes.OverLimit, refused.Code);
        Assert.Contains(computed.LargestAt.Sentence, refused.Reason.Sentence, StringComparison.Ordinal);
        Assert.Equal("N150", refused.Block);
        Assert.False(refused.MayPass);
    }

    [Theory]
    [InlineData("surface-one")]
    [InlineData("surface-one displaced")]
    public void A_surface_beyond_the_limit_is_refused_and_names_a_point(string name)
    {
        var computed = Samples.Program(Request(name));
        Assert.StartsWith("point ", computed.LargestAt.Sentence, StringComparison.Ordinal);
        Assert.True(computed.Corrections.Max(c => c.LengthMm) <= computed.LargestMm + 1e-9);
        var refused = Samples.Refusal(Request(name), Samples.NoLimits with { LimitMm = computed.LargestMm / 2 });
        Assert.Equal(CorrectionCodes.OverLimit, refused.Code);
        Assert.Contains(computed.LargestAt.Sentence, refused.Reason.Sentence, StringComparison.Ordinal);
    }

    // What the store sent last has cut a piece without stock: nothing that follows a measurement is compensated once more. A piece that
    // still has its stock was cut by no finishing program.
    [Fact]
    public void A_finished_surface_behind_a_compensated_program_is_refused()
    {
        using var folder = new TemporaryFolder();
        var first = Samples.Surface("surface-one");
        var sent = new StoredFile("finishing.nc", Samples.Program(first).Program);
        Assert.NotEmpty(Samples.Program(first with { LastSent = sent }).Corrections);

        File.Copy(Repository.PathTo("samples", "surface-one", "surface.igs"), folder["surface.igs"]);
        var text = File.ReadAllText(first.Job.File).Replace(
            "\"measuredAfter\": \"semi-finishing\"", "\"measuredAfter\": \"finishing\"", StringComparison.Ordinal);
        var finished = first with
        {
            Job = first.Job with { File = folder.File("job.json", text) },
            Measurement = new("after.csv", File.ReadAllBytes(Repository.PathTo("samples", "surface-one", "after.csv"))),
        };
        Assert.Equal("piece-compensated", Samples.Refusal(finished with { LastSent = sent }).Code);
        Assert.NotEmpty(Samples.Program(finished).Corrections);
    }

    [Fact]
    public void A_file_of_the_job_that_cannot_be_opened_may_pass()
    {
        using var folder = new TemporaryFolder();
        var request = Samples.Part("complex-mating") with { Job = Samples.Copied(folder) };
        foreach (var file in new[] { "counterpart.nc", "theoretical.csv", "job.json" })
        {
            File.Delete(folder[file]);
            var refused = Samples.Refusal(request);
            Assert.Equal(("file-unreadable", true), (refused.Code, refused.MayPass));
            Assert.Contains(file, refused.Reason.Sentence, StringComparison.Ordinal);
        }
    }

    [Fact]
    public void A_job_of_the_other_kind_is_refused()
    {
        Assert.NotEmpty(Samples.Refusal(Samples.Part("complex-mating") with { Piece = "surface" }).Reason.Sentence);
        Assert.NotEmpty(Samples.Refusal(Samples.Surface("surface-one") with { Piece = "part" }).Reason.Sentence);
        Assert.Throws<ArgumentException>(() => Samples.Compute(Samples.Part("complex-mating") with { Piece = "Part" }));
    }

    [Fact]
    public void A_cancelled_computation_computes_nothing() => Assert.Throws<OperationCanceledException>(() =>
        new CorrectionComputer(Samples.NoLimits).Compute(Samples.Surface("surface-one"), new CancellationToken(canceled: true)));

    internal static CorrectionRequest Request(string name)
    {
        var sample = name.Split(' ')[0];
        var request = sample.StartsWith("surface", StringComparison.Ordinal) ? Samples.Surface(sample) : Samples.Part(sample);
        return name == sample
            ? request
            : request with { Job = request.Job with { Program = Repository.PathTo("samples", sample, "cam.nc") } };
    }

    private static string Sha256(ReadOnlySpan<byte> bytes) => Convert.ToHexStringLower(SHA256.HashData(bytes));
}
