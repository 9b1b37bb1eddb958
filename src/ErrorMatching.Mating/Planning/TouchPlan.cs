using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>Where to touch the part.</summary>
/// <param name="Features">The features in the order of the job.</param>
/// <param name="StylusDiameterMm">Diameter of the ball that must reach every point, mm.</param>
/// <param name="Notes">What was left out, or could not be had, in sentences.</param>
public sealed record TouchPlan(IReadOnlyList<PlannedFeature> Features, double StylusDiameterMm, IReadOnlyList<string> Notes)
{
    /// <summary>The points in the order of the features.</summary>
    public IEnumerable<PlannedPoint> Points => Features.SelectMany(f => f.Lists.SelectMany(l => l));

    /// <summary>Blocks of the counterpart's program that clear something of which it is not known where: what stands there on the part may
    /// be in the ball's way.</summary>
    public IReadOnlyList<int> Unplaced { get; init; } = [];

    /// <summary>What it will tell; null of points that nobody chose, such as a job's own.</summary>
    public PlanPrediction? Prediction { get; init; }

    /// <summary>The plan without the two points that were chosen last, which tell least; null if each point is needed.</summary>
    public TouchPlan? TwoLess { get; init; }
}

/// <summary>The points of a feature.</summary>
/// <param name="Name">Name of the feature.</param>
/// <param name="Lists">The points, list by list as a job writes them, in the order of cutting.</param>
public sealed record PlannedFeature(string Name, IReadOnlyList<IReadOnlyList<PlannedPoint>> Lists);

/// <summary>A point to touch.</summary>
/// <param name="Label">Its name: that of the job's key point, or a new one.</param>
/// <param name="Place">Where it is as designed, mm, in the part's frame.</param>
/// <param name="Normal">Unit normal out of the part's material.</param>
/// <param name="Reason">The reason for it.</param>
/// <param name="ApproachMm">Distance from the part at which there is room to start the measuring move, mm.</param>
public sealed record PlannedPoint(string Label, Point2 Place, Vector2 Normal, TouchReason Reason, double ApproachMm);

/// <summary>The reason for a point of a plan.</summary>
public enum TouchReason
{
    /// <summary>One of the two ends of an element, which tell where it is and how it is turned.</summary>
    End,

    /// <summary>Between the ends, where the form is known least.</summary>
    Form,

    /// <summary>A key point of a kind that needs all of its own, such as a circle.</summary>
    Kept,
}
