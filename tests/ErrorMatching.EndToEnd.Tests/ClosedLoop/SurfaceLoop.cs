using System.Text;
using ErrorMatching.Freeform;
using ErrorMatching.Nc;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A design of the paper that goes round the whole loop: semi-finished, probed, compensated, finished, probed again. Cutting,
/// probing and what the touches come to are the referee's, of nothing but the programs' text.</summary>
internal sealed class SurfaceLoop
{
    // The paper's probe repeats to 0.25 um for two standard deviations; the referee's is worse.
    private const double ProbeRepeatability = 0.00025;

    private readonly FreeformJob _job, _finished;
    private readonly PartSurface _surface;
    private readonly MeasuringPlan _plan, _finishedPlan;
    private readonly string _sample, _probing, _finishedProbing;
    private readonly IReadOnlyList<AxisMove> _semiFinishing;

    /// <summary>The loop of a sample job.</summary>
    public SurfaceLoop(string sample, bool mirror)
    {
        _sample = sample;
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
        var (before, after, expected) = Go(seed, repeats);
        var ball = _job.Measuring.StylusDiameterMm / 2;
        return new(
            RefereeFigures.Of(before, _sample, ball + _job.Stock.SemiFinishingMm), RefereeFigures.Of(after, _sample, ball), expected);
    }

    /// <summary>What was measured after semi-finishing and after finishing, on a machine of its own,
    /// and what was expected between.</summary>
    public (MeasuredPoints Before, MeasuredPoints After) Measure(int seed)
    {
        var (before, after, _) = Go(seed, repeats: false);
        return (Read(before, _plan, _job), Read(after, _finishedPlan, _finished));
    }

    // The logs of both measurements, and what was expected between.
    private (string Before, string After, SurfacePrediction Expected) Go(int seed, bool repeats)
    {
        var random = new Random(seed);
        var machine = MachineError.Systematic(random);
        var (radius, repeatability) = (_job.Tool.RadiusMm, repeats ? 0 : ProbeRepeatability);
        var before = Touch(Cut(_semiFinishing), _probing);
        var outcome = Compensator.Compensate(new(_job, _surface, _plan, [Read(before, _plan, _job)]));
        Assert.Empty(outcome.Refusals);
        var result = outcome.Result!;
        var finishing = Moves(result.Surface, CuttingStage.Finishing);
        return (before, Touch(Cut(finishing), _finishedProbing), result.Predicted);

        CutSurface Cut(IReadOnlyList<AxisMove> moves) => new(moves, radius, repeats ? machine : machine.NextCut(random));

        string Touch(CutSurface piece, string program) =>
            VirtualProbe.Run(program, piece, _job.Measuring.StylusDiameterMm / 2, repeatability, random);
    }

    private static MeasuredPoints Read(string log, MeasuringPlan plan, FreeformJob job) =>
        MeasuredSurfaceReader.Read(Encoding.UTF8.GetBytes(log), "probe.log", plan, job.Measuring);

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
        return Encoding.UTF8.GetString(
            ProbingProgram.Of(plan, "loop", NcDialects.Named("linuxcnc"), ProbingTemplate.Named("linuxcnc")).Bytes.Span);
    }
}
