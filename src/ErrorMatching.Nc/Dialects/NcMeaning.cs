namespace ErrorMatching.Nc;

/// <summary>The meaning of a G code for the interpreter. The dialect's table assigns meanings to codes.</summary>
public enum NcMeaning : byte
{
    /// <summary>Not in the table.</summary>
    Unknown,

    /// <summary>Changes no position: modes of feed, spindle, smoothing and the like.</summary>
    Harmless,

    /// <summary>Positioning.</summary>
    Rapid,

    /// <summary>Straight cut.</summary>
    Line,

    /// <summary>Clockwise arc.</summary>
    ArcClockwise,

    /// <summary>Counter-clockwise arc.</summary>
    ArcCounterClockwise,

    /// <summary>Probing move; modal.</summary>
    Probe,

    /// <summary>The motion of its block is a probing move (G31, MEAS).</summary>
    ProbeInBlock,

    /// <summary>Moves nothing although it has axis words: a dwell, whose X is a time, or limits of travel.</summary>
    Dwell,

    /// <summary>Plane X Y.</summary>
    PlaneXY,

    /// <summary>Plane Z X.</summary>
    PlaneZX,

    /// <summary>Plane Y Z.</summary>
    PlaneYZ,

    /// <summary>Lengths in inches.</summary>
    Inch,

    /// <summary>Lengths in millimeters.</summary>
    Metric,

    /// <summary>Coordinates are positions.</summary>
    Absolute,

    /// <summary>Coordinates are increments.</summary>
    Incremental,

    /// <summary>Arc centers are positions.</summary>
    AbsoluteCenters,

    /// <summary>Arc centers are increments from the start.</summary>
    IncrementalCenters,

    /// <summary>Cutter compensation off.</summary>
    CompensationOff,

    /// <summary>Cutter compensation left of the path.</summary>
    CompensationLeft,

    /// <summary>Cutter compensation right of the path.</summary>
    CompensationRight,

    /// <summary>Chooses a work offset.</summary>
    WorkOffset,

    /// <summary>Sets the coordinates of the tool's current place (G92); its axis words are not a motion.</summary>
    SetPosition,

    /// <summary>Cancels such a shift permanently (G92.1).</summary>
    ClearPosition,

    /// <summary>Suspends such a shift until it is restored (G92.2).</summary>
    SuspendPosition,

    /// <summary>Restores a suspended shift (G92.3).</summary>
    RestorePosition,

    /// <summary>Shifts the origin of the work offsets (G52).</summary>
    LocalShift,

    /// <summary>Writes offsets (G10); its axis words are not a motion.</summary>
    SetOffset,

    /// <summary>Return to a reference point through the place that the block names.</summary>
    ReferenceReturn,

    /// <summary>Return to a reference point; axis words name the axes that return, not a place (Siemens G74, G75).</summary>
    ReferenceReturnOfAxes,

    /// <summary>Stores the tool's current place for a later return (G28.1, G30.1).</summary>
    StoreReference,

    /// <summary>The block uses machine coordinates.</summary>
    MachineCoordinates,

    /// <summary>Suppresses all offsets and frames in its block (G153, SUPA).</summary>
    SuppressFrames,

    /// <summary>Applies tool length from the machine's table.</summary>
    LengthOffset,

    /// <summary>Applies the tool length that the block's axis words state (G43.1); they are not a motion.</summary>
    ToolLength,

    /// <summary>Cancels tool length.</summary>
    LengthOffsetOff,

    /// <summary>Rotates the coordinates about a point in the plane (G68).</summary>
    Rotation,

    /// <summary>Ends the rotation.</summary>
    RotationOff,

    /// <summary>Scales the coordinates about a point (G51).</summary>
    Scaling,

    /// <summary>Ends the scaling.</summary>
    ScalingOff,

    /// <summary>Mirrors the coordinates at points of named axes (G51.1).</summary>
    Mirroring,

    /// <summary>Ends the mirroring of named axes.</summary>
    MirroringOff,

    /// <summary>Coordinates of the plane are a radius and an angle (G16).</summary>
    Polar,

    /// <summary>Ends polar coordinates.</summary>
    PolarOff,

    /// <summary>A transformation that is not followed (cylinder, polar interpolation, tilted plane, tool center point): the path is
    /// unknown, and nothing is changed.</summary>
    OpaqueTransform,

    /// <summary>Ends all such transformations.</summary>
    OpaqueTransformOff,

    /// <summary>Sets the programmable frame to a shift (TRANS); without axes it clears the frame.</summary>
    FrameShift,

    /// <summary>Adds a shift to the frame (ATRANS).</summary>
    FrameShiftMore,

    /// <summary>Sets the frame to a rotation (ROT).</summary>
    FrameRotation,

    /// <summary>Adds a rotation to the frame (AROT).</summary>
    FrameRotationMore,

    /// <summary>Sets the frame to a scale (SCALE).</summary>
    FrameScale,

    /// <summary>Adds a scale to the frame (ASCALE).</summary>
    FrameScaleMore,

    /// <summary>Sets the frame to a mirroring (MIRROR).</summary>
    FrameMirror,

    /// <summary>Adds a mirroring to the frame (AMIRROR).</summary>
    FrameMirrorMore,

    /// <summary>Canned cycle: feed to depth, rapid out (G81).</summary>
    DrillCycle,

    /// <summary>Canned cycle: feed to depth, wait, rapid out (G82).</summary>
    DwellDrillCycle,

    /// <summary>Canned cycle: depth in steps, full retract (G83).</summary>
    PeckCycle,

    /// <summary>Canned cycle: depth in steps, short retract (G73).</summary>
    ChipBreakCycle,

    /// <summary>Canned cycle: feed to depth and out (G84, G74, G85, G89).</summary>
    FeedOutCycle,

    /// <summary>Canned cycle: feed to depth and out to the cycle's retract plane, not first to its R plane (LinuxCNC's G89).</summary>
    FeedOutToClearCycle,

    /// <summary>The same for tapping, in the XY plane only (LinuxCNC's G74, G84).</summary>
    TapCycle,

    /// <summary>Canned cycle: feed to depth, spindle stop, rapid out (G86).</summary>
    StopOutCycle,

    /// <summary>Canned cycle: feed to depth, off the wall, rapid out (G76).</summary>
    FineBoreCycle,

    /// <summary>Canned cycle: off the wall, rapid below the hole, feed upwards to depth, off the wall, rapid out (G87).</summary>
    BackBoreCycle,

    /// <summary>A canned cycle whose motions are not followed; it ends over its position (G88).</summary>
    OpaqueCycle,

    /// <summary>Ends canned cycles.</summary>
    CycleOff,

    /// <summary>Cycles retract to the tool's initial level (G98).</summary>
    RetractToInitial,

    /// <summary>Cycles retract to their R plane (G99).</summary>
    RetractToR,

    /// <summary>Calls a macro once (G65).</summary>
    Call,

    /// <summary>Calls a macro after every motion from here on (G66).</summary>
    ModalCall,

    /// <summary>Ends modal macro calls.</summary>
    ModalCallOff,

    /// <summary>Calls a program in a way that is not followed, or from another place (PCALL, G72.1): refused.</summary>
    OpaqueCall,

    /// <summary>An arc through an intermediate point (CIP).</summary>
    ArcThrough,

    /// <summary>An arc that continues the path tangentially (CT).</summary>
    TangentArc,

    /// <summary>A straight cut in step with the spindle (G33); it is not displaced.</summary>
    ThreadCut,

    /// <summary>A spline (G5, G5.1, G5.2): its end is known, but its path is not followed.</summary>
    Spline,

    /// <summary>Feed is the inverse of the block's time (G93).</summary>
    InverseTimeFeed,

    /// <summary>Feed is length per minute.</summary>
    FeedPerMinute,

    /// <summary>Feed is length per revolution.</summary>
    FeedPerRevolution,

    /// <summary>The control smooths the path (G641, COMPCAD), so it is as programmed only within the control's tolerance. Causes a
    /// warning.</summary>
    Smoothing,

    /// <summary>Calls a cycle or subprogram after every motion from here on (MCALL); without a name, ends this.</summary>
    ModalCycle,

    /// <summary>A machining or measuring cycle with its arguments in parentheses (CYCLE81), or the call of one that was defined before
    /// (CYCL CALL, M99).</summary>
    CycleCall,

    /// <summary>The block moves the axes by itself in a way that is not followed: a pocket, engraving, measuring, homing. Positions are
    /// unknown until the program states them; modes stay.</summary>
    OpaqueMotion,

    /// <summary>The same, and the modes are unknown too.</summary>
    Unsure,

    /// <summary>Runs the active canned cycle at holes on a circle about the block's place: radius I, angle of the first J, number L (Haas
    /// G70).</summary>
    BoltCircle,

    /// <summary>The same on an arc, with the angle K from hole to hole (Haas G71).</summary>
    BoltArc,

    /// <summary>A canned cycle that is not followed and retracts to a level that is not known: it ends over its position (Okuma G81 with
    /// M53).</summary>
    OpaqueLevelCycle,

    /// <summary>Sets the pole of polar ends from the tool's place (G110).</summary>
    PoleFromPosition,

    /// <summary>Sets it from the origin (G111).</summary>
    PoleFromOrigin,

    /// <summary>Sets it from the pole before (G112).</summary>
    PoleFromPole,

    /// <summary>The straight motion of its block is a rapid (FMAX).</summary>
    RapidInBlock,

    /// <summary>An arc by its radius whose sense another word states (CR).</summary>
    ArcByRadius,

    /// <summary>An arc about the pole whose sense another word states (C).</summary>
    ArcAboutPole,

    /// <summary>An arc about the pole to a polar end (CP).</summary>
    PolarArc,

    /// <summary>A straight motion to a polar end (LP).</summary>
    PolarLine,

    /// <summary>A tangential arc to a polar end (CTP).</summary>
    PolarTangentArc,

    /// <summary>The sense of its block's arc: counter-clockwise with a plus sign, clockwise with a minus sign (DR).</summary>
    ArcSense,

    /// <summary>States the pole for arcs and polar ends after it (CC); its axis words are not a motion.</summary>
    SetPole,

    /// <summary>Rounds the corner between the motions before and after its block (RND).</summary>
    CornerRounding,

    /// <summary>Chamfers the corner between the motions before and after its block (CHF).</summary>
    CornerChamfer,

    /// <summary>Sets the programmable shift of the axes that it names; the others keep theirs (CYCL DEF 7). Without axes, the shift is
    /// unknown.</summary>
    DatumShift,

    /// <summary>Chooses or writes an origin in a way that is not followed (CYCL DEF 247).</summary>
    UnknownOrigin,

    /// <summary>Retracts the tool along its axis by a way that is not followed, before its block's motion (M140).</summary>
    ToolAxisRetract,

    /// <summary>Goes to the first point of a contour by a way that is not followed (APPR CT).</summary>
    Approach,

    /// <summary>Leaves a contour by a way that is not followed, and ends cutter compensation (DEP CT). Without coordinates, its end is
    /// unknown.</summary>
    Departure,

    /// <summary>Refused: an element of a contour that only the control computes (FL, FC).</summary>
    ComputedContour,

    /// <summary>Cutter compensation left of the path; D is the diameter of the tool (G41.1).</summary>
    CompensationLeftByDiameter,

    /// <summary>Cutter compensation right of the path; D is the diameter of the tool (G42.1).</summary>
    CompensationRightByDiameter,

    /// <summary>Outside corners under cutter compensation are rounded by an arc (G450).</summary>
    CompensationRoundCorners,

    /// <summary>Outside corners under cutter compensation go on to the intersection (G451).</summary>
    CompensationSharpCorners,

    /// <summary>Cutter compensation begins and ends at right angles to the contour (NORM).</summary>
    CompensationNormalEntry,

    /// <summary>Cutter compensation begins and ends around the contour's first and last point, in a way that is not followed
    /// (KONT).</summary>
    CompensationOtherEntry,

    /// <summary>The outside corner at the end of its block goes on to the intersection under cutter compensation (M97).</summary>
    CompensationSharpCorner,

    /// <summary>Changes how the control leads the tool's center under cutter compensation, in a way that is not followed (M98,
    /// M120).</summary>
    CompensationUnfollowed,

    /// <summary>Goes to the first point of a contour over a point ahead of its first element (APPR LT).</summary>
    ApproachTangent,

    /// <summary>Goes to the first point of a contour over a point at right angles to its first element (APPR LN).</summary>
    ApproachNormal,

    /// <summary>Leaves a contour straight on from its last element, and ends cutter compensation (DEP LT).</summary>
    DepartureTangent,

    /// <summary>Leaves a contour at right angles to its last element, and ends cutter compensation (DEP LN).</summary>
    DepartureNormal,

    /// <summary>Calls a tool: its number and the oversize of its radius are words of the block (TOOL CALL).</summary>
    ToolCall,

    /// <summary>Defines a tool by its number and radius (TOOL DEF).</summary>
    ToolDefinition,

    /// <summary>Runs the active cycle at holes on a line from the place of the block (G72 of Haas).</summary>
    BoltLine,

    /// <summary>Moves a probe from where it is until it touches, and back: a word that changes no offset. Positions are unknown until the
    /// program states them; modes stay (TCH PROBE 3).</summary>
    MeasuringCycle,
}
