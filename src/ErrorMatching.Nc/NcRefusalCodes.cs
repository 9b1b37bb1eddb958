namespace ErrorMatching.Nc;

/// <summary>The stable words of refusals.</summary>
public static class NcRefusalCodes
{
    /// <summary>A selector names no block of the program.</summary>
    public const string BlockNotFound = "block-not-found";

    /// <summary>A selector's number stands in several blocks.</summary>
    public const string BlockAmbiguous = "block-ambiguous";

    /// <summary>The named blocks hold no cutting motion.</summary>
    public const string NoMotion = "no-motion";

    /// <summary>A coordinate that must change is computed by the control (variable or expression).</summary>
    public const string Expression = "expression";

    /// <summary>A word in a block that must change is not known to the dialect.</summary>
    public const string UnknownWord = "unknown-word";

    /// <summary>Rotation, scaling, mirroring or polar coordinates are active where a block must change.</summary>
    public const string ActiveTransform = "active-transform";

    /// <summary>A canned cycle, reference move or machine-coordinate move is among what must change.</summary>
    public const string NotASimpleMove = "not-a-simple-move";

    /// <summary>A rotary or secondary axis moves in a block that must change.</summary>
    public const string OtherAxis = "other-axis";

    /// <summary>The position or a mode of the control is not known where a block must change.</summary>
    public const string UnknownState = "unknown-state";

    /// <summary>A block that runs several times would have to change differently at each run.</summary>
    public const string RunsDiffer = "runs-differ";

    /// <summary>An arc is given by an opening angle, a point on the way, or the direction before it.</summary>
    public const string ArcForm = "arc-form";

    /// <summary>A displaced contour could no longer be entered or left as it is with cutter compensation.</summary>
    public const string CompensationEntry = "compensation-entry";

    /// <summary>The work offset or origin changes between blocks that must change together.</summary>
    public const string FrameChange = "frame-change";

    /// <summary>An arc whose words do not describe a circle within the control's tolerance.</summary>
    public const string BadArc = "bad-arc";

    /// <summary>An element would vanish or turn round if displaced as asked.</summary>
    public const string ElementFlips = "element-flips";

    /// <summary>Two displaced neighbors no longer meet.</summary>
    public const string NoIntersection = "no-intersection";

    /// <summary>
    /// Two cuts that are not connected share a place, they do not move alike, and no rapid between them has coordinates of its own
    /// that could lead from one to the other.
    /// </summary>
    public const string NoPositioning = "no-positioning";

    /// <summary>Corner rounding or chamfer words (,R ,C) at a vertex that must move.</summary>
    public const string CornerWord = "corner-word";

    /// <summary>Motions in different planes cannot be displaced together.</summary>
    public const string PlaneChange = "plane-change";

    /// <summary>A point of a wish lies too far from the path of the named blocks.</summary>
    public const string PointOffPath = "point-off-path";

    /// <summary>Blocks are to be displaced by points, and none of the points lies on them.</summary>
    public const string RunWithoutPoint = "run-without-point";

    /// <summary>Two points of a wish ask for different displacements at one place.</summary>
    public const string PointsCoincide = "points-coincide";

    /// <summary>A number has more digits than can be changed exactly.</summary>
    public const string NumberTooLong = "number-too-long";

    /// <summary>The displaced program, read again, does not do what was asked.</summary>
    public const string ProofFailed = "proof-failed";

    /// <summary>A loop does not end: it repeats without changing anything, or the limit of executed blocks is reached.</summary>
    public const string EndlessLoop = "endless-loop";

    /// <summary>A program that is called is neither in the file nor in the library.</summary>
    public const string MissingProgram = "missing-program";

    /// <summary>A block behind a slash changes what is cut, and nobody has said how the switch for block skip stands.</summary>
    public const string BlockSkip = "block-skip";

    /// <summary>A jump has no target, or a loop or branch has no end.</summary>
    public const string MissingLabel = "missing-label";

    /// <summary>A branch, loop or call hangs on a value that only the machine knows.</summary>
    public const string UnknownCondition = "unknown-condition";

    /// <summary>An expression or statement that the control would stop at.</summary>
    public const string BadExpression = "bad-expression";

    /// <summary>Programs call one another deeper than the limit.</summary>
    public const string CallTooDeep = "call-too-deep";
}
