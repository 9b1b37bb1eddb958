using System.Text;
using ErrorMatching.Freeform;
using ErrorMatching.Nc;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A design of the paper that goes round the whole loop: semi-finished, probed, compensated, finished, probed again. Cutting and probing are the referee's, of nothing but the programs' text.</summary>
internal sealed class SurfaceLoop
{
    // The paper's probe repeats to 0.25 um for two standard deviations; the referee's is worse.
    private const double ProbeRepeatability = 0.00025;

    private readonly FreeformJob _job, _finished;
    private readonly PartSurface _surface;
    private readonly MeasuringPlan _plan, _finishedPlan;
    private readonly string _probing, _finishedProbing;
    private readonly IReadOnlyList<AxisMove> _semiFinishing;

    /// <summary>The loop of a sample job, with a tool path coarse enough for many runs.</summary>
    public SurfaceLoop(string sample, bool mirror)
    {
        var text = File.ReadAllText(Repository.PathTo("samples", sample, "job.json"))
            .Replace("\"dialect\": \"siemens-840d\"", "\"dialect\": \"linuxcnc\"", StringComparison.Ordinal)
            .Replace("\"method\": \"mirror\"", mirror ? "\"method\": \"mirror\"" : "\"method\": \"tool-radius\"", StringComparison.Ordinal);
        _job = FreeformJob.Parse(Encoding.UTF8.GetBytes(text), "job.json");
        _finished = _job with { Measuring = _job.Measuring with { After = CuttingStage.Finishing } };
        var file = Repository.PathTo("samples", sample, _job.Surface.File);
        _surface = SurfaceReader.Read(File.ReadAllBytes(file), file, null, true);
        _plan = MeasuringPlanner.Plan(_surface, _job.Measuring, _job.Stock.SemiFinishingMm);
        _finishedPlan = MeasuringPlanner.Plan(_surface, _finished.Measuring, 0);
        _probing = Probing(_plan);
        _finishedProbing = Probing(_finishedPlan);
        _semiFinishing = Moves(_surface, CuttingStage.SemiFinishing);
    }

    /// <summary>Number of measuring points.</summary>
    public int Points => _plan.Points.Count;

    /// <summary>The statistics before and after, on a machine of its own.</summary>
    public SurfaceLoopRun Run(int seed) => Run(seed, repeats: false);

    /// <summary>The same.</summary>
    /// <param name="seed">Of the machine.</param>
    /// <param name="repeats">True for a machine whose cuts and a probe whose touches are always the same.</param>
    public SurfaceLoopRun Run(int seed, bool repeats)
    {
        var (before, after, expected) = Measure(seed, repeats);
        return new(SurfaceEvaluation.Of(_job, _surface, [before]).Together, SurfaceEvaluation.Of(_finished, _surface, [after]).Together, expected);
    }

    /// <summary>What was measured after semi-finishing and after finishing, on a machine of its own, and what was expected between.</summary>
    public (MeasuredPoints Before, MeasuredPoints After, SurfacePrediction Expected) Measure(int seed, bool repeats = false)
    {
        var random = new Random(seed);
        var machine = MachineError.Systematic(random);
        var (radius, repeatability) = (_job.Tool.RadiusMm, repeats ? 0 : ProbeRepeatability);
        var before = Measure(Cut(_semiFinishing), _probing, _plan, _job);
        var outcome = Compensator.Compensate(new(_job, _surface, _plan, [before]));
        Assert.Empty(outcome.Refusals);
        var result = outcome.Result!;
        var finishing = Moves(result.Surface, CuttingStage.Finishing);
        var after = Measure(Cut(finishing), _finishedProbing, _finishedPlan, _finished);
        return (before, after, result.Predicted);

        CutSurface Cut(IReadOnlyList<AxisMove> moves) => new(moves, radius, repeats ? machine : machine.NextCut(random));

        MeasuredPoints Measure(CutSurface piece, string program, MeasuringPlan plan, FreeformJob job) =>
            MeasuredSurfaceReader.Read(Encoding.UTF8.GetBytes(VirtualProbe.Run(program, piece, job.Measuring.StylusDiameterMm / 2, repeatability, random)), "probe.log", plan, job.Measuring);
    }

    private IReadOnlyList<AxisMove> Moves(PartSurface surface, CuttingStage stage)
    {
        var dialect = NcDialects.Named(_job.Toolpath.Dialect);
        var path = ToolPathPlanner.Plan(surface, _job.Tool, _job.Toolpath, _job.Stock.Of(stage), dialect);
        Assert.Null(path.Refusal);
        return StraightProgram.Read(Encoding.UTF8.GetString(FinishingProgram.Write(path.Path!, _job, dialect, stage)));
    }

    private static string Probing(MeasuringPlan plan)
    {
        Assert.Empty(plan.Refusals);
        return Encoding.UTF8.GetString(ProbingProgram.Of(plan, "loop", NcDialects.Named("linuxcnc"), ProbingTemplate.Named("linuxcnc")).Bytes.Span);
    }
}
