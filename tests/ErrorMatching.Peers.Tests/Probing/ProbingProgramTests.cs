using System.Text;
using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Peers.Tests;

/// <summary>The probing program for LinuxCNC, run by LinuxCNC's own interpreter: its motions, and the log that it writes.</summary>
public sealed class ProbingProgramTests
{
    private const double Width = 75, Depth = 63;

    [Fact]
    public void Rs274_makes_the_motions_of_the_probing_program_that_we_see()
    {
        Rs274.IsNeeded();
        var program = Program();
        var peer = Rs274.Run(Numbered(program.Bytes));
        Assert.Null(peer.Refusal);
        Assert.Equal(program.Moves.Touches.Count, peer.Motions.Count(m => m.Kind == MotionKind.Probe));
        Assert.Null(Agreement.FirstDifference(
            peer.Motions, NcInterpreter.Run(NcProgram.Read(program.Bytes, NcSyntax.LinuxCnc), NcDialects.LinuxCnc), mostUnknown: 0.5));
    }

    [Fact]
    public void Rs274_goes_on_from_semi_finishing_to_probing_in_one_program()
    {
        Rs274.IsNeeded();
        var program = Program();
        var merged = program.MergeAfter(
            "G21 G90 G17 G54\nM3 S10000\nG0 X0 Y0 Z30\nG1 Z10 F1200\nX75\nG0 Z30\nM5\nM2\n"u8.ToArray(), "semi.ngc");
        var peer = Rs274.Run(Numbered(merged));
        Assert.Null(peer.Refusal);
        Assert.Equal(program.Moves.Touches.Count, peer.Motions.Count(m => m.Kind == MotionKind.Probe));
    }

    [Fact]
    public void The_log_that_rs274_writes_is_read_back()
    {
        Rs274.IsNeeded();
        var program = Program();
        var run = Rs274.Run(Encoding.ASCII.GetString(program.Bytes.Span));
        Assert.Null(run.Refusal);
        var log = Encoding.ASCII.GetBytes(string.Join('\n', run.Log));

        // Nothing trips the simulated probe: it stops where the measuring move ends, which the reader lets pass only where it is told that
        // the surface may be so far off.
        var plan = Plan();
        var far = plan.Measuring with { ApproachMm = 5, OvertravelMm = 5 };
        var measured = MeasuredSurfaceReader.Read(log, "errormatch-probe.log", plan, far);
        Assert.Empty(measured.Warnings);
        Assert.All(measured.Points, p => Assert.True((p.Contact - (p.Planned.Position + (p.Planned.Normal * (0.2 - 2)))).Length < 1e-3));
        Assert.Equal(
            "far-off-point",
            Assert.Throws<InputException>(() => MeasuredSurfaceReader.Read(log, "errormatch-probe.log", plan, plan.Measuring)).Code);
    }

    // Our templates put a word before the name. This one does not.
    [Theory]
    [InlineData("Saddle", null)]
    [InlineData("ABORT, the saddle", null)]
    [InlineData("log , the saddle", null)]
    [InlineData("PROBEOPEN saddle.txt", null)]
    [InlineData("print,#5061", null)]
    [InlineData("Sattel für Gehäuse", null)]
    [InlineData(null, "ABORT, the saddle")]
    public void Rs274_takes_every_name_for_a_comment(string? name, string? executed)
    {
        Rs274.IsNeeded();
        var comment = name is null ? executed! : "{job}";
        var template = ProbingTemplate.Parse(
            Encoding.UTF8.GetBytes(
                $"@body\n({comment})\n(order {{order}})\nG17 G21 G90 G94\nG0 Z{{clearance.z}}\n@each point\n"
                    + "G0 X{approach.x} Y{approach.y}\n@next\nM2\n"),
            "own.txt");
        var run = Rs274.Run(Numbered(Program(name ?? "Saddle", template).Bytes));

        // What the name would do if it were executed shows that the peer would tell.
        Assert.Equal(executed is not null, run.Refusal is not null);
        Assert.Empty(run.Log);
        Assert.Equal(executed is null ? 31 : 0, run.Motions.Count);
    }

    private static ProbingProgram Program(string name = "saddle", ProbingTemplate? template = null) =>
        ProbingProgram.Of(Plan(), name, NcDialects.LinuxCnc, template ?? ProbingTemplate.Named("linuxcnc"), order: name);

    // A saddle, so that normals lean in all directions: z = (x/75 - 1/2)(y/63 - 1/2) 20, bilinear.
    private static MeasuringPlan Plan()
    {
        var knots = KnotVector.Clamped(1, [0, 1]);
        var surface = new PartSurface(
            "saddle",
            new SplineSurface(knots, knots, [new(0, 0, 5), new(0, Depth, -5), new(Width, 0, -5), new(Width, Depth, 5)]),
            SurfaceRegion.Whole,
            1);
        var measuring = new JobMeasuring
        {
            Curves = 5,
            PointsPerCurve = 6,
            StylusDiameterMm = 6,
            ApproachMm = 2,
            OvertravelMm = 2,
            ClearanceMm = 10,
            FeedMmPerMin = 100,
            Dialect = "linuxcnc",
            ReportsStylusCenter = false,
            After = CuttingStage.SemiFinishing,
            UncertaintyMm = 0.000125,
            BestFit = false,
        };
        return MeasuringPlanner.Plan(surface, measuring, 0.2);
    }

    // Line numbers, so that the peer says which block a motion is of.
    private static string Numbered(ReadOnlyMemory<byte> program) =>
        string.Join(
            '\n',
            Encoding.ASCII.GetString(program.Span)
                .Split('\n')
                .Select((l, i) => l.Length == 0 || l[0] == '(' ? l : FormattableString.Invariant($"N{i + 1} {l}")));
}
