using System.Text;
using System.Text.Json.Nodes;
using ErrorMatching.Freeform;
using ErrorMatching.Mating;
using ErrorMatching.Reporting;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

/// <summary>The reports of all samples are read as they were written.</summary>
public sealed class SampleReportTests
{
    private static CancellationToken Cancellation => TestContext.Current.CancellationToken;

    [Theory]
    [InlineData("complex-mating")]
    [InlineData("curve-mating")]
    [InlineData("circle-mating")]
    [InlineData("slot-mating")]
    [InlineData("dovetail")]
    public void A_match_and_its_verification(string sample)
    {
        string In(string file) => Repository.PathTo("samples", sample, file);
        var files = new JobFiles(In("job.json"));
        var report = MatingRun.Run(files, new(), Cancellation).Result!.Report;
        DocumentCheck.IsReadAndWritten(
            MatchReportJson.Write(report), b => MatchReportJson.Write(MatchReportJson.Read(ReportReader.Document(b))));

        // What is derived from it is the same, too.
        var read = MatchReportJson.Read(ReportReader.Document(MatchReportJson.Write(report)));
        Assert.Equal(report.Outside.Points, read.Outside.Points);
        Assert.Equal(report.Outside.DrivenOut, read.Outside.DrivenOut);
        Assert.Equal(report.Prediction.Outside.Points, read.Prediction.Outside.Points);
        Assert.Equal(report.OnCorners, read.OnCorners);
        Assert.All(
            report.Features.Zip(read.Features),
            f => Assert.Equal(
                report.BeyondTolerance(f.First).Select(p => p.Point), read.BeyondTolerance(f.Second).Select(p => p.Point)));

        var part = files.Part(null);
        var verified = VerifyRun.Report(
            new(
                files.Job,
                files.Theoretical(),
                part,
                files.Counterpart(new(In("counterpart.csv")), part),
                files.Counterpart(new(In("counterpart-after.csv")), part),
                "counterpart.nc",
                files.Program(null).Bytes),
            out _)!;
        DocumentCheck.IsReadAndWritten(
            VerifyReportJson.Write(verified),
            b => VerifyReportJson.Write(VerifyReportJson.Read(ReportReader.Document(b))),
            // Small differences of large numbers, and what is calculated from them.
            ["$.verdict.probability", .. Enumerable.Range(0, 99).Select(i => $"$.features[{i}].improvementPercent")]);
    }

    [Theory]
    [InlineData("surface-one")]
    [InlineData("surface-two")]
    [InlineData("surface-three")]
    public void A_compensated_surface(string sample)
    {
        var finished = SurfaceRun.Compensate(
            new(Repository.PathTo("samples", sample, "job.json")),
            new() { Measured = [new(Repository.PathTo("samples", sample, "measured.csv"))] },
            Cancellation).Result!;
        DocumentCheck.IsReadAndWritten(finished.ReportJson(), b => CompensationDocument.Read(ReportReader.Document(b))!.Write());
    }

    [Fact]
    public void A_displaced_surface()
    {
        var displaced = SurfaceRun.Displace(
            new(Repository.PathTo("samples", "surface-one", "job.json")),
            new() { Measured = [new(Repository.PathTo("samples", "surface-one", "measured.csv"))] },
            new(Repository.PathTo("samples", "surface-one", "cam.nc")),
            Cancellation).Result!;
        var document = displaced.ReportJson();
        DocumentCheck.IsReadAndWritten(document, b => DisplacementDocument.Read(ReportReader.Document(b))!.Write());

        var old = JsonNode.Parse(document)!;
        old["proof"]!.AsObject().Remove("marker");
        Assert.Null(DisplacementDocument.Read(ReportReader.Document(Encoding.UTF8.GetBytes(old.ToJsonString())))!.Proof.Marker);
        old.AsObject().Remove("map");
        Assert.Null(DisplacementDocument.Read(ReportReader.Document(Encoding.UTF8.GetBytes(old.ToJsonString()))));
    }
}
