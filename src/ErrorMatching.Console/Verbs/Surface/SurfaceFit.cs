using System.CommandLine;
using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Jobs;

namespace ErrorMatching.Console;

/// <summary><c>errormatch surface fit</c>.</summary>
internal sealed class SurfaceFit : Verb
{
    private readonly Argument<string> _points = new("POINTS.csv")
    {
        Description = "A header with i, j, x, y and z, then one line per point: i along a curve, j from curve to curve."
    };

    private readonly Option<string> _method = new("--method")
    {
        Description = "The way of fitting: " + string.Join(", ", FitMethod.All) + ".",
        HelpName = "M",
        DefaultValueFactory = _ => FitMethod.Best.Name,
    };

    private readonly Option<string> _check = FileOption(
        "--check", "Points of the true surface to compare the fit with: a header with x, y and z, then one line per point.");

    private readonly Option<string> _out = SurfaceOptions.Out(
        "The folder to write the surface to, as surface.stp and surface.igs: a nominal surface for a job, with its breaks, where only "
            + "points are known. Without it nothing is written.");

    public SurfaceFit()
        : base(
            "fit",
            "Lays a surface through a grid of points and says how far it can be trusted.",
            "errormatch surface fit samples/surface-fit/points.csv --method through-curve-mesh --check samples/surface-fit/check.csv")
    {
        Arguments.Add(_points);
        Options.Add(_method);
        Options.Add(_check);
        Options.Add(_out);
        _method.CompletionSources.Add(_ => FitMethod.All.Select(m => new System.CommandLine.Completions.CompletionItem(m.Name)));
        Demand(_method, name => FitMethod.Named(name) is not null, string.Join(", ", FitMethod.All));
    }

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        using var progress = new LateProgress(ProgressTo);
        progress.Report("reading the points");
        var file = arguments.GetRequiredValue(_points);
        var given = GivenMeasurement(file);
        var grid = given.Bytes is { } bytes ? GridReader.Read(bytes, given.File) : GridReader.Read(file);
        var check = arguments.GetValue(_check) is { } checkFile ? GridReader.ReadPoints(checkFile) : null;
        cancellation.ThrowIfCancellationRequested();
        try
        {
            progress.Report("fitting the surface");
            var fit = SurfaceFitter.Fit(grid, FitMethod.Named(arguments.GetRequiredValue(_method))!, JobFit.Default.CurveToleranceMm);
            cancellation.ThrowIfCancellationRequested();
            progress.Report("measuring its distance from the points");
            var distance = new SurfaceDistance(fit.Surface);
            var folder = arguments.GetValue(_out);
            var answer = new SurfaceFitAnswer(
                given.File,
                grid.Points.Count(),
                fit,
                distance.Of(grid.Points.Select(p => p.Position)),
                check is null ? null : distance.Of(check),
                folder);
            if (folder is not null)
            {
                OutputFile.WriteAll(answer.Files, [file, .. arguments.GetValue(_check) is { } other ? new[] { other } : []], cancellation);
            }

            return answer;
        }
        catch (GeometryException e)
        {
            return FailureOf.Geometry(e, given.File);
        }
    }
}
