using System.Text;
using System.Text.Json;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

public sealed class SurfaceRunTests
{
    private static readonly string Job = Repository.PathTo("samples", "surface-one", "job.json");
    private static readonly GivenFile Measured = new(Repository.PathTo("samples", "surface-one", "measured.csv"));
    private static readonly GivenFile Cam = new(Repository.PathTo("samples", "surface-one", "cam.nc"));

    [Fact]
    public void Bytes_give_what_their_file_gives()
    {
        var (byFile, byBytes) = (Finished(new() { Measured = [Measured] }), Finished(new() { Measured = [WithBytes(Measured)] }));
        Assert.Equal(byFile.Program.ToArray(), byBytes.Program.ToArray());
        Assert.Equal(byFile.ReportJson(), byBytes.ReportJson());
        Assert.Equal(byFile.ReportHtml(), byBytes.ReportHtml());
    }

    [Fact]
    public void A_displaced_program_is_the_same_from_bytes_and_its_page_lists_what_changed()
    {
        var (byFile, byBytes) = (Displaced(Measured, Cam), Displaced(WithBytes(Measured), WithBytes(Cam)));
        Assert.Equal(byFile.Program.ToArray(), byBytes.Program.ToArray());
        Assert.Equal(byFile.ReportJson(), byBytes.ReportJson());
        Assert.Equal(byFile.ReportHtml(), byBytes.ReportHtml());

        using var json = JsonDocument.Parse(byFile.ReportJson());
        Assert.Equal("errormatch/surface-displace/1", json.RootElement.GetProperty("schema").GetString());
        Assert.True(json.RootElement.GetProperty("proof").GetProperty("holds").GetBoolean());

        // What is compensated is said as where a program is made.
        using var made = JsonDocument.Parse(Finished(new() { Measured = [Measured] }).ReportJson());
        Assert.All(["before", "compensation", "predicted", "points", "map"], p => Assert.Equal(made.RootElement.GetProperty(p).GetRawText(), json.RootElement.GetProperty(p).GetRawText()));

        // The first changed block as both files have it.
        var (before, after) = (Encoding.Latin1.GetString(File.ReadAllBytes(Cam.File)).Split('\n'), Encoding.Latin1.GetString(byFile.Program.Span).Split('\n'));
        var first = before.Zip(after).First(l => l.First != l.Second);
        var page = Encoding.UTF8.GetString(byFile.ReportHtml());
        Assert.Contains(first.First.TrimEnd('\r'), page, StringComparison.Ordinal);
        Assert.Contains(first.Second.TrimEnd('\r'), page, StringComparison.Ordinal);
        Assert.DoesNotContain("<script", page, StringComparison.Ordinal);
    }

    [Fact]
    public void Half_the_gain_moves_half_as_far_and_the_report_says_so()
    {
        var (whole, half) = (Finished(new() { Measured = [Measured] }), Finished(new() { Measured = [Measured], Gain = 0.5 }));
        Assert.Equal(whole.Report.Result.LargestMoveMm / 2, half.Report.Result.LargestMoveMm, 9);
        Assert.Contains("A gain of 0.5 took the place of the job's, which is 1.", half.Report.Result.Notes);
        Assert.Throws<ArgumentOutOfRangeException>(() => Finished(new() { Measured = [Measured], Gain = 3 }));
    }

    [Fact]
    public void A_program_beside_the_surface_is_refused_by_name()
    {
        var program = Repository.PathTo("samples", "figure-nine", "original.nc");
        var outcome = SurfaceRun.Displace(new(Job), new() { Measured = [Measured] }, new(program), TestContext.Current.CancellationToken);
        Assert.Null(outcome.Result);
        Assert.Equal(program, Assert.Single(outcome.Refusals).File);
    }

    private static GivenFile WithBytes(GivenFile file) => file with { Bytes = File.ReadAllBytes(file.File) };

    private static FinishedSurface Finished(SurfaceRequest request) => SurfaceRun.Compensate(new(Job), request, TestContext.Current.CancellationToken).Result!;

    private static DisplacedSurface Displaced(GivenFile measured, GivenFile program) => SurfaceRun.Displace(new(Job), new() { Measured = [measured] }, program, TestContext.Current.CancellationToken).Result!;
}
