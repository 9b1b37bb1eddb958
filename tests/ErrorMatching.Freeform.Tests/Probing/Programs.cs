using ErrorMatching.Nc;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Probing programs of a plan and what they do.</summary>
internal static class Programs
{
    public static MeasuringPlan Plan(PartSurface? surface = null) =>
        MeasuringPlanner.Plan(surface ?? Surfaces.One, Surfaces.Measuring(4, 5), 0.2);

    public static ProbingProgram Of(string template, MeasuringPlan? plan = null) =>
        ProbingProgram.Of(plan ?? Plan(), "Surface one", Dialect(template), ProbingTemplate.Named(template));

    public static NcDialect Dialect(string template) => NcDialects.Named(
        template switch { "fanuc-p98xx" => "fanuc", "haas-p98xx" => "haas", "siemens-cycle978" => "siemens-840d", _ => template });

    public static NcPath Path(ReadOnlyMemory<byte> program, NcDialect dialect) =>
        NcInterpreter.Run(NcProgram.Read(program, dialect.Syntax), dialect);

    /// <summary>A log as the control would write it where the ball's center stopped at some places.</summary>
    public static string Log(MeasuringPlan plan, Func<PlanPoint, Geometry.Point3> center) =>
        $"ERRORMATCH PROBE PLAN {ProbingProgram.PlanId(plan)} MM\n"
            + string.Concat(plan.Points.Select(p => FormattableString.Invariant(
                $"P{p.Number} C X{center(p).X:R} Y{center(p).Y:R} Z{center(p).Z:R}\n")));
}
