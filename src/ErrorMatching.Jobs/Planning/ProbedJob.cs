using System.Globalization;
using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Mating;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>The program that touches the key points of a mating job on the part: <c>errormatch job probe</c>.</summary>
public sealed record ProbedJob
{
    /// <summary>Code of the refusal of a point that aligns the part and is no key point: where to touch it from is not known.</summary>
    public const string DatumNotProbed = "datum-not-probed";

    /// <summary>Code of the refusal of a height that nobody stated and the program does not tell.</summary>
    public const string HeightMissing = "height-missing";

    /// <summary>Code of the refusal of a ball that is another one than the job's, by which a match takes centers for contacts.</summary>
    public const string StylusDiffers = "stylus-differs";

    /// <summary>Code of the refusal of a counterpart that was cut in another work offset than the templates select.</summary>
    public const string OtherWorkOffset = "other-work-offset";

    // G54, as frames count.
    private const int SelectedOffset = 540;

    // Without a word from the caller: a slow measuring move, and travel where the program travels, but not close to the piece.
    private const double FeedMmPerMin = 100;
    private const double LeastClearanceMm = 5;

    // Shorter approaches leave no room for a part that deviates, mm.
    private const double ShortApproachMm = 1;

    // Rounding of a program's words, mm, and blocks that a comment names.
    private const double RoundingMm = 0.01;
    private const int MostNamed = 3;

    // How far a measuring move goes on behind where the part can still be.
    private const double BehindMm = 1;

    private ProbedJob()
    {
    }

    /// <summary>The job.</summary>
    public required MatingJob Job { get; init; }

    /// <summary>The program.</summary>
    public required ProbingProgram Program { get; init; }

    /// <summary>True if the counterpart is touched, in the frame of its program; false for the part, in its own.</summary>
    public required bool OfCounterpart { get; init; }

    /// <summary>The points in the order of touching, with their numbers in the log from 1.</summary>
    public required IReadOnlyList<PlannedPoint> Points { get; init; }

    /// <summary>Height at which the ball's center touches, mm, in the work offset of the program.</summary>
    public required double TouchZ { get; init; }

    /// <summary>What to look at before the first run, in sentences.</summary>
    public required IReadOnlyList<string> Notes { get; init; }

    /// <summary>Name of the program's file: the ending is that of the counterpart's program.</summary>
    public string FileName => "probe" + (Path.GetExtension(Job.Counterpart.Program) is { Length: > 1 } extension ? extension : ".nc");

    /// <summary>The files that were read.</summary>
    public required IReadOnlyList<string> Read { get; init; }

    /// <summary>Makes the program.</summary>
    /// <param name="file">The job.</param>
    /// <param name="wish">What the caller states.</param>
    /// <param name="cancellation">Cancels between steps.</param>
    /// <returns>The program, or why there is none.</returns>
    /// <exception cref="InputException">A file cannot be opened or used. No template is there for the dialect.</exception>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static Outcome<ProbedJob> Make(string file, ProbeWish wish, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(wish);
        var files = new JobFiles(file);
        var job = files.Job;
        var theoretical = files.Theoretical();
        var interpreted = files.Interpret(cancellation);
        var (program, path) = (interpreted.File, interpreted.Path);
        if (wish.StylusDiameterMm is { } given && job.Gauge.StylusDiameterMm is { } ofJob && given != ofJob)
        {
            return new Refusal(
                StylusDiffers,
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"--stylus-diameter is {given} mm, and the gauge of the job has a ball of {ofJob} mm: the match would put every "
                        + $"contact {Math.Abs(given - ofJob) / 2:0.####} mm off. Correct one of them."))
                .In(job.File);
        }

        var (assumed, notes) = (new List<string>(), new List<string>());
        var diameter = wish.StylusDiameterMm ?? job.Gauge.StylusDiameterMm ?? Assumed(PlannedJob.AssumedStylusMm, "ball");
        var isBuiltIn = wish.Template is not { } named || ProbingTemplate.Names.Contains(named);
        if (wish.OfCounterpart && isBuiltIn && OtherOffset(path) is { } other)
        {
            return new Refusal(
                OtherWorkOffset,
                $"{path.Program.NameOf(path.Program[other])} cuts in another work offset than G54, or with a shift of it: the built-in "
                    + "templates touch in G54 as it is, which would be beside the counterpart. Give a --template of your own that selects "
                    + "what the program selects.",
                new() { File = program, Line = other + 1, Block = path.Program.NameOf(path.Program[other]) });
        }

        var depth = TouchPlanner.DepthMm(job, path, theoretical);
        if ((wish.TouchZ ?? TouchHeight(depth, diameter / 2)) is not { } z)
        {
            return new Refusal(
                HeightMissing,
                $"{program} does not say how deep it cuts the features below Z0, so that a height to touch at cannot be taken from it. "
                    + "Give --z.");
        }

        z = wish.TouchZ ?? Assumed(z, "touch at Z");
        if (!wish.OfCounterpart && !(z - (diameter / 2) >= depth - RoundingMm))
        {
            Assumed(z - (diameter / 2), "a floor below Z");
        }

        var approach = wish.ApproachMm ?? TouchPlanner.ApproachMm;
        var planned = wish.OfCounterpart
            ? TouchPlanner.OwnOfCounterpart(job, path, theoretical, diameter, approach, z)
            : TouchPlanner.Own(job, path, theoretical, diameter, approach);
        if (planned.Result is not { } plan)
        {
            return Outcome.Refused<ProbedJob>(InputRefusals.Of(planned.Refusals, job.File, program));
        }

        var byLabel = plan.Points.ToDictionary(p => p.Label, StringComparer.Ordinal);
        var order = TouchOrder.Labels(job, theoretical);
        if (order.FirstOrDefault(l => !byLabel.ContainsKey(l)) is { } datum)
        {
            return new Refusal(
                DatumNotProbed,
                $"The point {datum} aligns the part and belongs to no feature, so that it is not known from which side to touch it. Set "
                    + "the work offset of the part in the control, and take \"alignment\" and \"originCheck\" out of the job.")
                .In(job.File);
        }

        // Of a tool the program says where its tip is, of the probe where the center of its ball is.
        var clearance = wish.ClearanceZ ?? Assumed(Math.Max(LeastClearanceMm, Highest(path)) + (diameter / 2), "travel at Z");
        if (clearance - (diameter / 2) <= Math.Max(0, z))
        {
            return new Refusal(
                "clearance-too-low",
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"The bottom of the ball would travel at Z{clearance - (diameter / 2):0.###}, not above Z{Math.Max(0, z):0.###}. Give "
                        + $"a higher --clearance."));
        }

        if (plan.Unplaced.Count > 0)
        {
            string[] names = [.. plan.Unplaced.Take(MostNamed).Select(b => path.Program.NameOf(path.Program[b]))];
            var others = plan.Unplaced.Count > MostNamed ? " and others" : "";
            assumed.Add($"what is cleared by {string.Join(" ", names)}{others}");
        }

        var (dialect, template) = Template(wish, job, interpreted.OwnDialect, files, assumed);
        PlannedPoint[] points = [.. order.Select(l => byLabel[l])];
        var overtravel = wish.OvertravelMm ?? job.Compensation.LimitMm + BehindMm;
        var shortMm = Math.Max(ShortApproachMm, job.Compensation.LimitMm);
        if (points.Where(p => p.ApproachMm < shortMm).Select(p => p.Label).ToArray() is { Length: > 0 } near)
        {
            notes.Add(string.Create(
                CultureInfo.InvariantCulture,
                $"There is little room at {string.Join(", ", near)}: the measuring move starts {points.Min(p => p.ApproachMm):0.##} mm ")
                + "from the piece as designed. One that stands out further is touched on the way down.");
        }

        if (job.Gauge.StylusDiameterMm is null)
        {
            notes.Add("Write \"stylusDiameterMm\" under \"gauge\" before the match: the log has the centers of the ball.");
        }

        if (template.File == ProbingTemplate.Named("grbl").File && job.Gauge.Reports != ProbeReport.StylusCenter)
        {
            notes.Add("The answers of grbl are centers of the ball in machine coordinates: write \"reports\": \"stylus-center\" under "
                + "\"gauge\", and an \"alignment\".");
        }

        var moves = new ProbingMoves
        {
            Plan = wish.OfCounterpart ? TouchOrder.PlanOfCounterpart(job, theoretical) : TouchOrder.PlanOf(job, theoretical),
            Touches = [.. points.Select((p, i) => TouchOf(i + 1, p, z, diameter / 2, overtravel))],
            ClearanceZ = clearance,
            StylusDiameterMm = diameter,
            ApproachMm = points.Max(p => p.ApproachMm),
            OvertravelMm = overtravel,
            FeedMmPerMin = wish.FeedMmPerMin ?? FeedMmPerMin,
            ToolKey = "--tool",
            Tool = wish.ToolNumber is { } tool ? new ToolCall(tool, null, dialect.UsualOffsetOf(tool)) : null,
            Assumed = assumed,
        };
        return new ProbedJob
        {
            Job = job,
            Program = ProbingProgram.Of(moves, job.Name, dialect, template, job.WorkOrder),
            OfCounterpart = wish.OfCounterpart,
            Points = points,
            TouchZ = z,
            Notes = notes,
            Read = files.Opened,
        };

        double Assumed(double value, string what)
        {
            assumed.Add(string.Create(CultureInfo.InvariantCulture, $"{what} {value:0.###}"));
            return value;
        }
    }

    // The job's own control, or the one that is named. Those that print by DPRNT may do what Fanuc does, which is assumed.
    private static (NcDialect Dialect, ProbingTemplate Template) Template(
        ProbeWish wish, MatingJob job, NcDialect? own, JobFiles files, List<string> assumed)
    {
        var dialect = wish.Dialect is { } named ? InputFile.Dialect(named) : own ?? NcDialects.Named(job.Counterpart.Dialect);
        if (wish.Template is { } template)
        {
            if (ProbingTemplate.Names.Contains(template))
            {
                return (dialect, ProbingTemplate.Named(template));
            }

            files.Add(template);
            return (dialect, ProbingTemplate.Parse(InputFile.Bytes(template, ProbingTemplate.MaxBytes), template));
        }

        if (ProbingTemplate.Find(dialect) is { } found)
        {
            return (dialect, found);
        }

        if (dialect.MeaningOf("DPRNT"u8) != NcMeaning.Harmless)
        {
            throw InputException.At(
                "unknown-template",
                dialect.Name,
                $"no probing program is built in for this control. Give --template with one that it runs "
                    + $"({string.Join(", ", ProbingTemplate.Names)}) or with a file of your own, or name another control that "
                    + "measures with --dialect.");
        }

        assumed.Add("codes of Fanuc");
        return (dialect, ProbingTemplate.Named("fanuc"));
    }

    private static ProbingTouch TouchOf(int number, PlannedPoint point, double z, double radius, double overtravel)
    {
        var normal = new Vector3(point.Normal.X, point.Normal.Y, 0);
        return new(number, At(radius + point.ApproachMm), At(0), At(radius), At(radius - overtravel), normal)
        {
            Name = point.Label,
        };

        Point3 At(double off)
        {
            var place = point.Place + (point.Normal * off);
            return new(place.X, place.Y, z);
        }
    }

    // The first block that cuts elsewhere than in G54.
    private static int? OtherOffset(NcPath path)
    {
        foreach (var motion in path.Motions)
        {
            if (motion is { IsCut: true, MovesInPlane: true } && path.Frames[motion.Frame] is var frame
                && (frame.WorkOffset != SelectedOffset || frame.WorkOffsetNumber != 0 || frame.Shift != Vector3.Zero
                    || frame.UnknownShift != AxisSet.None))
            {
                return motion.Block;
            }
        }

        return null;
    }

    // Half as deep as the features are cut, but above what is below them if there is room for the ball.
    private static double? TouchHeight(double? depth, double radius) => depth is not { } mm || mm >= 0 ? null
        : Math.Round(mm + radius < 0 ? Math.Max(mm / 2, mm + radius) : mm / 2, 3);

    private static double Highest(NcPath path)
    {
        var highest = 0.0;
        foreach (var motion in path.Motions)
        {
            if ((motion.UnknownEnd & AxisSet.Z) == AxisSet.None && double.IsFinite(motion.End.Z))
            {
                highest = Math.Max(highest, motion.End.Z);
            }
        }

        return highest;
    }
}

/// <summary>What a caller states about a probing program. What is null is the job's, or assumed and told.</summary>
public sealed record ProbeWish
{
    /// <summary>True to touch the counterpart instead of the part.</summary>
    public bool OfCounterpart { get; init; }

    /// <summary>Diameter of the ball, mm.</summary>
    public double? StylusDiameterMm { get; init; }

    /// <summary>Height at which the ball's center touches, mm.</summary>
    public double? TouchZ { get; init; }

    /// <summary>Height of the ball's center during travel, mm.</summary>
    public double? ClearanceZ { get; init; }

    /// <summary>Distance from the part at which measuring moves start where there is room, mm.</summary>
    public double? ApproachMm { get; init; }

    /// <summary>How far measuring moves go on behind the expected contact, mm.</summary>
    public double? OvertravelMm { get; init; }

    /// <summary>Feed of the measuring move, mm/min.</summary>
    public double? FeedMmPerMin { get; init; }

    /// <summary>Number of the probe as a tool, and of its length offset.</summary>
    public int? ToolNumber { get; init; }

    /// <summary>The control that the program is for; null for that of the counterpart's program.</summary>
    public string? Dialect { get; init; }

    /// <summary>A built-in template, or a file of the shop.</summary>
    public string? Template { get; init; }
}
