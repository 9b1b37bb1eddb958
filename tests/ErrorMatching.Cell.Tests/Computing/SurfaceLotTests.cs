using System.Text.Json;
using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

/// <summary>Surfaces whose corrections go on from the report of the piece before.</summary>
public sealed class SurfaceLotTests(TwoSurfaces surfaces) : IClassFixture<TwoSurfaces>
{
    [Fact]
    public void A_compensated_piece_corrects_the_sum_and_its_step_is_small()
    {
        var (first, second) = (surfaces.First, surfaces.Second);

        Assert.InRange(first.SumMm, 0.020, 0.030);
        Assert.InRange(second.SumMm, 0.020, 0.030);
        Assert.Equal(second.LargestMm, second.Corrections.Max(c => c.LengthMm));
        Assert.InRange(second.LargestMm, 0.0001, 0.003);
        Assert.NotEqual(first.Basis.Identity, second.Basis.Identity);
        using var report = JsonDocument.Parse(second.Report);
        Assert.Equal(2, report.RootElement.GetProperty("lot").GetProperty("pieces").GetArrayLength());
        var sums = second.Sums.Points.Zip(first.Sums.Points, (now, was) => now.Z - was.Z);
        Assert.All(sums.Zip(second.Corrections), p => Assert.Equal(p.Second.Z, p.First, 1e-12));
    }

    [Fact]
    public void The_step_and_the_sum_have_limits_of_their_own()
    {
        var (request, second) = (surfaces.Request, surfaces.Second);

        Assert.IsType<ComputedProgram>(Samples.Compute(
            request, Samples.NoLimits with { LimitMm = second.LargestMm + 1e-9, SumLimitMm = second.SumMm + 1e-9 }));
        Assert.Equal(
            CorrectionCodes.OverLimit,
            Samples.Refusal(request, Samples.NoLimits with { LimitMm = second.LargestMm - 1e-9, SumLimitMm = 1 }).Code);
        Assert.Equal(
            CorrectionCodes.OverSumLimit,
            Samples.Refusal(request, Samples.NoLimits with { LimitMm = 1, SumLimitMm = second.SumMm - 1e-9 }).Code);
    }

    [Fact]
    public void Another_report_before_is_another_correction()
    {
        var request = surfaces.Request;
        var alone = request with { Previous = null, LastSent = null, Sums = CorrectionSums.None };

        Assert.NotEqual(surfaces.Second.Basis.Identity, Samples.Program(alone).Basis.Identity);
        Assert.Equal(
            "piece-compensated", Samples.Refusal(request with { Previous = null, Sums = CorrectionSums.None }).Code);
    }
}

/// <summary>The first piece as the nominal program cut it, and the piece that its correction cut. Each takes a while to compute.</summary>
public sealed class TwoSurfaces : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public TwoSurfaces()
    {
        foreach (var file in (string[])["job.json", "surface.igs"])
        {
            File.Copy(Repository.PathTo("samples", "surface-one", file), _folder[file]);
        }

        var job = Samples.Job(_folder["job.json"]) with { Accumulates = true };
        var text = File.ReadAllText(job.File).Replace(
            "\"scallopMm\": 0.001, \"chordMm\": 0.001", "\"scallopMm\": 0.05, \"chordMm\": 0.01", StringComparison.Ordinal);
        File.WriteAllText(job.File, text);
        First = Samples.Program(new() { Job = job, Piece = "surface", Measurement = Samples.File("surface-one", "measured.csv") });
        File.WriteAllText(job.File, text.Replace("\"semi-finishing\"", "\"finishing\"", StringComparison.Ordinal));
        Request = new()
        {
            Job = job,
            Piece = "surface",
            Measurement = Samples.File("surface-one", "after.csv"),
            LastSent = new(First.ProgramName, First.Program),
            Previous = new("report.json", First.Report),
            Sums = First.Sums,
        };
        Second = Samples.Program(Request);
    }

    /// <summary>The correction of the first piece.</summary>
    internal ComputedProgram First { get; }

    /// <summary>What is asked for the second one.</summary>
    internal CorrectionRequest Request { get; }

    /// <summary>The correction of the second one.</summary>
    internal ComputedProgram Second { get; }

    public void Dispose() => _folder.Dispose();
}
