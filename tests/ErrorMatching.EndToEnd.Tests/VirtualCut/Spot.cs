namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A place of the tool, mm. An axis that the referee cannot know (after a return to home) is NaN.</summary>
internal readonly record struct Spot(double X, double Y, double Z)
{
    /// <summary>The two coordinates of a working plane, in the order that makes its third axis point to the viewer.</summary>
    public Flat In(WorkPlane plane) => plane switch
    {
        WorkPlane.XY => new(X, Y),
        WorkPlane.ZX => new(Z, X),
        WorkPlane.YZ => new(Y, Z),
        _ => throw new ArgumentOutOfRangeException(nameof(plane)),
    };
}
