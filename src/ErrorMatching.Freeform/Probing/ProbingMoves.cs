using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>How a probing program moves the ball of a stylus, and what its log says about its plan.</summary>
/// <remarks>Lengths in millimeters. All places but the contacts are those of the ball's center, in the work offset of the
/// program.</remarks>
public sealed record ProbingMoves
{
    /// <summary>The plan's identifier in the log: 16 hexadecimal digits.</summary>
    public required string Plan { get; init; }

    /// <summary>The touches in the order of measuring.</summary>
    public required IReadOnlyList<ProbingTouch> Touches { get; init; }

    /// <summary>Height of the ball's center during travel between touches.</summary>
    public required double ClearanceZ { get; init; }

    /// <summary>Diameter of the ball.</summary>
    public required double StylusDiameterMm { get; init; }

    /// <summary>Distance from the expected contact at which a measuring move starts; at most.</summary>
    public required double ApproachMm { get; init; }

    /// <summary>How far a measuring move goes on behind the expected contact before it counts as a miss.</summary>
    public required double OvertravelMm { get; init; }

    /// <summary>Feed of the measuring move.</summary>
    public required double FeedMmPerMin { get; init; }

    /// <summary>How the control calls the probe; null if the template loads it into the spindle.</summary>
    public ToolCall? Tool { get; init; }

    /// <summary>Where the caller names that tool, for messages.</summary>
    public string ToolKey { get; init; } = "measuring.tool";

    /// <summary>What nobody stated, in a few words each, such as <c>Z -5</c>: the program names them and stops before it moves. Empty if
    /// everything is stated.</summary>
    public IReadOnlyList<string> Assumed { get; init; } = [];

    /// <summary>The moves of a surface's plan.</summary>
    public static ProbingMoves Of(MeasuringPlan plan)
    {
        ArgumentNullException.ThrowIfNull(plan);
        return new()
        {
            Plan = ProbingProgram.PlanId(plan),
            Touches = [
                .. plan.Points.Select(p => new ProbingTouch(
                    p.Number, plan.ApproachOf(p), plan.ContactOf(p), plan.CenterOf(p), plan.OvertravelOf(p), p.Normal)
                {
                    Grid = (p.I, p.J),
                })],
            ClearanceZ = plan.ClearanceZ,
            StylusDiameterMm = plan.Measuring.StylusDiameterMm,
            ApproachMm = plan.Measuring.ApproachMm,
            OvertravelMm = plan.Measuring.OvertravelMm,
            FeedMmPerMin = plan.Measuring.FeedMmPerMin,
            Tool = plan.Measuring.Tool,
        };
    }
}

/// <summary>A touch of a probing program.</summary>
/// <param name="Number">Its number in the log.</param>
/// <param name="Approach">Where the measuring move starts.</param>
/// <param name="Contact">The place that is touched.</param>
/// <param name="Center">The ball's center when it touches there.</param>
/// <param name="Overtravel">Where the measuring move ends if nothing is touched.</param>
/// <param name="Normal">Unit normal out of the material.</param>
public sealed record ProbingTouch(int Number, Point3 Approach, Point3 Contact, Point3 Center, Point3 Overtravel, Vector3 Normal)
{
    /// <summary>Indices of the point along its curve and of the curve; null if it is in no grid.</summary>
    public (int I, int J)? Grid { get; init; }

    /// <summary>Name of the point for a comment; empty for its indices.</summary>
    public string Name { get; init; } = "";
}
