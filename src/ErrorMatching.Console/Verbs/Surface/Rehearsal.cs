using System.Text;
using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>A rehearsal compensation of a small surface, run on the second core while the first one reads the job. The runtime loads, links
/// and compiles in advance what the real compensation needs.</summary>
/// <remarks>The result is discarded and nothing waits for it; the process may end before it does. With one core there is no
/// rehearsal.</remarks>
internal static class Rehearsal
{
    private const int Lines = 5;

    /// <summary>Starts it if there is a second core.</summary>
    public static void Begin()
    {
        if (Environment.ProcessorCount > 1)
        {
            _ = Task.Run(Run);
        }
    }

    /// <summary>Runs it; returns the report's page and the number of touched points.</summary>
    public static (byte[] Page, int Points) Run()
    {
        // The fit takes longest to prepare, so it comes first, even before what the first core prepares meanwhile.
        _ = FieldFit.Fit(
            [
                .. Errors().Select(
                    (e, k) => new ErrorSample(
                        k + 1, k % Lines, k / Lines, (k % Lines) / (Lines - 1.0), (k / Lines) / (Lines - 1.0), default, new(0, 0, 1), e))]);

        var template = FreeformJob.Parse(Encoding.UTF8.GetBytes(FreeformTemplate.Text), "rehearsal.json");
        var job = template with { Measuring = template.Measuring with { Curves = Lines, PointsPerCurve = Lines } };
        var heights = new[] { 0, 0.2, 0, 0.2, 0.3, 0.2, 0, 0.2, 0 };
        var square = KnotVector.Clamped(2, [0, 1]);
        var surface = new PartSurface(
            "rehearsal",
            new(square, square, [.. heights.Select((z, k) => new Point3(2 * (k / 3), 2 * (k % 3), z))]),
            SurfaceRegion.Whole,
            1);
        var stock = job.Stock.Of(job.Measuring.After);
        var plan = MeasuringPlanner.Plan(surface, job.Measuring, stock);
        var points = plan.Points.Zip(Errors(), (p, e) => new MeasuredPoint(p, p.Position + (p.Normal * (stock + e)), p.Number)).ToArray();
        var result = Compensator.Compensate(new(job, surface, plan, [new("rehearsal.csv", "", points, [])])).Result!;
        var dialect = NcDialects.Named(job.Toolpath.Dialect);
        var path = ToolPathPlanner.Plan(result.Surface, job, CuttingStage.Finishing, dialect).Path!;
        _ = FinishingProgram.Write(path, job, dialect);
        var none = new ReportInput("", "", new('0', 64));
        var report = new CompensationReport(new("", null, "", none.Sha256), [none], result, path, none, null);
        _ = (
            CompensationDocument.Of(report).Write(),
            StepWriter.Write(result.Surface),
            IgesWriter.Write(result.Surface),
            CompensationCsv.Write(result));
        return (CompensationReportHtml.Write(report), points.Length);
    }

    // Slow waves and a little noise, so that every kind of model is tried.
    private static IEnumerable<double> Errors() =>
        Enumerable.Range(0, Lines * Lines).Select(
            k => 0.01 + (0.005 * Math.Sin((0.8 * (k % Lines)) + (0.5 * (k / Lines)))) + (0.0003 * Math.Sin(7.3 * k * k)));
}
