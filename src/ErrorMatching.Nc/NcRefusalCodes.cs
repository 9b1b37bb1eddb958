namespace ErrorMatching.Nc;

/// <summary>The stable identifiers of refusals.</summary>
public static class NcRefusalCodes
{
    /// <summary>A selector names no block of the program.</summary>
    public const string BlockNotFound = "block-not-found";

    /// <summary>Several blocks have a selector's number.</summary>
    public const string BlockAmbiguous = "block-ambiguous";

    /// <summary>The named blocks have no cutting motion.</summary>
    public const string NoMotion = "no-motion";

    /// <summary>The control computes a coordinate that must change (variable or expression).</summary>
    public const string Expression = "expression";

    /// <summary>The dialect does not know a word in a block that must change.</summary>
    public const string UnknownWord = "unknown-word";

    /// <summary>Rotation, scaling, mirroring or polar coordinates are active where a block must change.</summary>
    public const string ActiveTransform = "active-transform";

    /// <summary>A canned cycle, reference move or machine-coordinate move would have to change.</summary>
    public const string NotASimpleMove = "not-a-simple-move";

    /// <summary>A rotary or secondary axis moves in a block that must change.</summary>
    public const string OtherAxis = "other-axis";

    /// <summary>The position or a mode of the control is unknown where a block must change.</summary>
    public const string UnknownState = "unknown-state";

    /// <summary>A block that runs several times would need different changes in each run.</summary>
    public const string RunsDiffer = "runs-differ";

    /// <summary>An arc is given by an opening angle, an intermediate point, or the direction before it.</summary>
    public const string ArcForm = "arc-form";

    /// <summary>Cutter compensation could no longer enter or leave a displaced contour as before.</summary>
    public const string CompensationEntry = "compensation-entry";

    /// <summary>Under cutter compensation the tool does not fit: an arc is too tight, or an element is too short for it.</summary>
    public const string CompensationGouge = "compensation-gouge";

    /// <summary>The control stops at a word that must not be there while cutter compensation is on.</summary>
    public const string CompensationStop = "compensation-stop";

    /// <summary>The path of the tool's center under cutter compensation is not followed.</summary>
    public const string CompensationUnfollowed = "compensation-unfollowed";

    /// <summary>Cutter compensation is on, and nobody stated the tool's radius.</summary>
    public const string ToolRadiusUnknown = "tool-radius-unknown";

    /// <summary>The work offset or origin changes between blocks that must change together.</summary>
    public const string FrameChange = "frame-change";

    /// <summary>An arc whose words do not describe a circle within the control's tolerance.</summary>
    public const string BadArc = "bad-arc";

    /// <summary>An element would vanish or reverse if displaced as wished.</summary>
    public const string ElementFlips = "element-flips";

    /// <summary>Two displaced neighbors no longer meet.</summary>
    public const string NoIntersection = "no-intersection";

    /// <summary>Two unconnected cuts share a place and do not move alike, and no rapid between them has its own coordinates to lead from
    /// one to the other.</summary>
    public const string NoPositioning = "no-positioning";

    /// <summary>Corner rounding or chamfer words (,R ,C) at a vertex that must move.</summary>
    public const string CornerWord = "corner-word";

    /// <summary>Motions in different planes cannot be displaced together.</summary>
    public const string PlaneChange = "plane-change";

    /// <summary>A point of a wish is too far from the path of the named blocks.</summary>
    public const string PointOffPath = "point-off-path";

    /// <summary>Blocks are to be displaced by points, but none of the points is on them.</summary>
    public const string RunWithoutPoint = "run-without-point";

    /// <summary>Two points of a wish have different displacements at one place.</summary>
    public const string PointsCoincide = "points-coincide";

    /// <summary>A number has more digits than can be changed exactly.</summary>
    public const string NumberTooLong = "number-too-long";

    /// <summary>The displaced program, read again, does not do what was wished.</summary>
    public const string ProofFailed = "proof-failed";

    /// <summary>A loop does not end: it repeats without changing anything, or the limit of executed blocks is reached.</summary>
    public const string EndlessLoop = "endless-loop";

    /// <summary>A called program is neither in the file nor in the library.</summary>
    public const string MissingProgram = "missing-program";

    /// <summary>A block after a slash changes what is cut, and the state of the block skip switch is not stated.</summary>
    public const string BlockSkip = "block-skip";

    /// <summary>A jump has no target, or a loop or branch has no end.</summary>
    public const string MissingLabel = "missing-label";

    /// <summary>A branch, loop or call depends on a value that only the machine knows.</summary>
    public const string UnknownCondition = "unknown-condition";

    /// <summary>An expression or statement at which the control would stop.</summary>
    public const string BadExpression = "bad-expression";

    /// <summary>The control refuses the block, so that the program stops there.</summary>
    public const string RefusedByControl = "refused-by-control";

    /// <summary>Programs call one another more deeply than the limit.</summary>
    public const string CallTooDeep = "call-too-deep";
}
