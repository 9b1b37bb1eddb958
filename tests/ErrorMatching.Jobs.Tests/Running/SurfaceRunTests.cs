using System.Security.Cryptography;
using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;
using ErrorMatching.Nc;
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
        Assert.All(
            ["before", "compensation", "predicted", "points", "map"],
            p => Assert.Equal(made.RootElement.GetProperty(p).GetRawText(), json.RootElement.GetProperty(p).GetRawText()));

        // The first changed block as both files have it.
        var (before, after) = (
            Encoding.Latin1.GetString(File.ReadAllBytes(Cam.File)).Split('\n'), Encoding.Latin1.GetString(byFile.Program.Span).Split('\n'));
        var first = before.Zip(after.Skip(1)).First(l => l.First != l.Second);
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

    [Theory]
    [InlineData("tensor")]
    [InlineData("best")]
    public void A_displaced_program_follows_the_error_where_the_job_fits_points_and_says_so(string method)
    {
        using var folder = new TemporaryFolder();
        File.Copy(Repository.PathTo("samples", "surface-one", "surface.igs"), folder["surface.igs"]);
        var text = File.ReadAllText(Job);
        var fit = "\"method\": \"best\", \"of\": \"error\"";
        Assert.Contains(fit, text, StringComparison.Ordinal);
        var job = folder.File("job.json", text.Replace(fit, $"\"method\": \"{method}\", \"of\": \"points\"", StringComparison.Ordinal));

        var byError = Displaced(Measured, Cam);
        var byPoints = SurfaceRun.Displace(new(job), new() { Measured = [Measured] }, Cam, TestContext.Current.CancellationToken).Result!;

        Assert.Equal(byError.Program.ToArray(), byPoints.Program.ToArray());
        Assert.Equal("fit-follows-error", Assert.Single(byPoints.Report.Compensation.Warnings).Code);
        Assert.Empty(byError.Report.Compensation.Warnings);

        // What is said to be expected, and by how much points move, is of the program that was made.
        Assert.Equal(byError.Report.Compensation.Mirror.Statistics, byPoints.Report.Compensation.Mirror.Statistics);
        Assert.All(
            byPoints.Report.Compensation.Samples,
            s => Assert.Equal(byError.Report.Compensation.MoveAt(s), byPoints.Report.Compensation.MoveAt(s)));
    }

    // Whether the error was cut away by a displaced program or by one that was made anew, it must not be cut away again.
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void What_follows_the_measurement_is_not_displaced_again(bool isMade)
    {
        var program = isMade ? Finished(new() { Measured = [Measured] }).Program : Displaced(Measured, Cam).Program;
        var marker = Assert.Single(Marker.Find(NcProgram.Read(program, NcSyntax.Siemens))).Marker!;
        Assert.Equal(Sha256(Measured.File), marker.MeasurementSha256);
        Assert.Equal(Sha256(isMade ? Repository.PathTo("samples", "surface-one", "surface.igs") : Cam.File), marker.BaseSha256);
        var refusal = Assert.Single(
            SurfaceRun.Displace(
                new(Job), new() { Measured = [Measured] }, new("again.nc", program), TestContext.Current.CancellationToken).Refusals);
        Assert.Equal((Marker.AlreadyCompensated, "again.nc", 1), (refusal.Code, refusal.Place.File, refusal.Place.Line));
    }

    [Fact]
    public void The_page_shows_changed_blocks_side_by_side_although_the_marker_moved_them()
    {
        var displaced = Displaced(Measured, Cam);
        var (before, after) = (File.ReadAllLines(Cam.File), Encoding.Latin1.GetString(displaced.Program.Span).Split('\n'));
        var block = displaced.Report.Displaced.Rewrite.ChangedBlocks[0];
        var page = Encoding.UTF8.GetString(displaced.ReportHtml());
        var (old, changed) = (Regex.Escape(before[block]), Regex.Escape(after[block + 1].TrimEnd('\r')));
        Assert.Matches($"{old}</code></td>\\s*<td[^>]*><code>{changed}<", page);
        using var json = JsonDocument.Parse(displaced.ReportJson());
        Assert.Equal(after[0].TrimEnd('\r'), json.RootElement.GetProperty("proof").GetProperty("marker").GetString());
    }

    [Fact]
    public void A_program_beside_the_surface_is_refused_by_name()
    {
        var program = Repository.PathTo("samples", "figure-nine", "original.nc");
        var outcome = SurfaceRun.Displace(new(Job), new() { Measured = [Measured] }, new(program), TestContext.Current.CancellationToken);
        Assert.Null(outcome.Result);
        Assert.Equal(program, Assert.Single(outcome.Refusals).Place.File);
    }

    private static string Sha256(string file) => Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(file)));

    private static GivenFile WithBytes(GivenFile file) => file with { Bytes = File.ReadAllBytes(file.File) };

    private static FinishedSurface Finished(SurfaceRequest request) =>
        SurfaceRun.Compensate(new(Job), request, TestContext.Current.CancellationToken).Result!;

    private static DisplacedSurface Displaced(GivenFile measured, GivenFile program) =>
        SurfaceRun.Displace(new(Job), new() { Measured = [measured] }, program, TestContext.Current.CancellationToken).Result!;
}
