namespace ErrorMatching.Nc;

/// <summary>How a control leads the tool's center under cutter compensation, as its dialect states it.</summary>
internal sealed class CompensationRule
{
    /// <summary>The way in, and the way out.</summary>
    public CompensationStart Start { get; set; }

    /// <summary>True if the control stops where the way in is not longer than the tool radius.</summary>
    public bool StartExceedsRadius { get; set; }

    /// <summary>True if the control stops where an arc is as tight as the tool, false only where it is tighter.</summary>
    public bool ArcsExceedRadius { get; set; }

    /// <summary>True if compensation may begin on an arc.</summary>
    public bool StartsOnArcs { get; set; }

    /// <summary>True if only a move in the plane is known to end it.</summary>
    public bool EndsInPlane { get; set; }

    /// <summary>True if a call of a program in another file ends it.</summary>
    public bool EndsAtCalls { get; set; }

    /// <summary>True if it works in the YZ plane.</summary>
    public bool WorksInYz { get; set; }

    /// <summary>Outside corners that turn by up to <see cref="SharpDegrees"/>.</summary>
    public CompensationCorner OutsideCorners { get; set; }

    /// <summary>Outside corners that turn further.</summary>
    public CompensationCorner SharpCorners { get; set; }

    /// <summary>Where the two kinds of outside corners part, degrees of the turn.</summary>
    public double SharpDegrees { get; set; }

    /// <summary>A turn of up to this many degrees is no corner.</summary>
    public double StraightDegrees { get; set; }

    /// <summary>By how many radians an arc may get longer under compensation, in a program in millimeters; a 25.4th of it in one in inches;
    /// infinite if there is no limit.</summary>
    public double ArcGrowthRadians { get; set; } = double.PositiveInfinity;

    /// <summary>G codes at which the control stops while compensation is on, times ten.</summary>
    public HashSet<int> StopCodes { get; } = [];

    /// <summary>M functions at which the control stops while compensation is on.</summary>
    public HashSet<int> StopFunctions { get; } = [];
}

/// <summary>How a control begins and ends cutter compensation.</summary>
internal enum CompensationStart : byte
{
    /// <summary>It is not followed.</summary>
    Unknown,

    /// <summary>The way in ends one tool radius beside its programmed end, at right angles to itself. What follows is a corner like any
    /// other.</summary>
    OwnNormal,

    /// <summary>The way in ends one tool radius beside its programmed end, at right angles to the contour's first element.</summary>
    NextNormal,

    /// <summary>Like <see cref="NextNormal"/> at an inside corner, like <see cref="OwnNormal"/> at an outside one.</summary>
    NextNormalOrCorner,
}

/// <summary>How a control goes around an outside corner under cutter compensation.</summary>
internal enum CompensationCorner : byte
{
    /// <summary>By an arc about the corner.</summary>
    Arc,

    /// <summary>On to the intersection of both paths of the tool's center; by an arc where there is none.</summary>
    Intersection,

    /// <summary>By one tool radius further along both elements, with a straight piece between.</summary>
    Pieces,
}
