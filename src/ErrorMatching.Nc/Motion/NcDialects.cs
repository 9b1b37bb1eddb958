namespace ErrorMatching.Nc;

/// <summary>The dialects that are built in.</summary>
public static class NcDialects
{
    private const string Iso = "ISO 6983-1:2009";
    private const string Fanuc = "Fanuc Series 0i-MF operator's manual B-64604EN";
    private const string Delta = "Delta NC300 series programming manual";
    private const string LinuxCncManual = "LinuxCNC 2.9 G-code reference";
    private const string Assumed = "assumed";

    private static readonly HashSet<string> MacroFlow = new(["IF", "GOTO", "WHILE", "DO", "END", "THEN"], StringComparer.Ordinal);
    private static readonly HashSet<string> OWordFlow = new(["SUB", "ENDSUB", "IF", "ELSEIF", "ELSE", "ENDIF", "WHILE", "ENDWHILE", "DO", "REPEAT", "ENDREPEAT", "CALL", "BREAK", "CONTINUE", "RETURN"], StringComparer.Ordinal);

    private static readonly DialectFact[] CommonFacts =
    [
        new("G0 G1 G2 G3", "Positioning, straight cut, clockwise and counter-clockwise arc; modal.", Iso),
        new("G17 G18 G19", "Planes XY, ZX, YZ; arcs turn as seen against the third axis.", Iso),
        new("G90 G91", "Coordinates are positions or increments; modal.", Iso),
        new("I J K", "Arc center from the start of the arc, along X, Y, Z; a missing one is zero.", Iso),
        new("before the first code", "G1, G17, G21, G90, G40, incremental centers.", Assumed),
        new("block skip", "A block behind a slash is taken to be executed.", Assumed),
        new("called programs", "May change position and modes: coordinates and modes must be stated again before a block can be changed. Units are taken to stay.", Assumed),
    ];

    /// <summary>The common part of ISO controls; what most programs for milling need.</summary>
    public static NcDialect Generic { get; } = Iso6983(new("generic", "What ISO milling controls have in common.")
    {
        FlowKeywords = MacroFlow,
        CallFunctions = new HashSet<int> { 97, 98 },
        Facts = [.. CommonFacts, new("G68 G51 G51.1 G16", "Rotation, scaling, mirror, polar coordinates: nothing is changed while one is active.", Assumed), new("least increment", "0.001 mm, 0.0001 in.", Assumed), new("arc tolerance", "Both radii agree within 0.02 mm; what is written agrees within 0.001 mm.", Assumed)],
    });

    /// <summary>Fanuc series 0i and 30i milling.</summary>
    public static NcDialect FanucMill { get; } = FanucCodes(Iso6983(new("fanuc", "Fanuc series 0i and 30i, milling.")
    {
        FlowKeywords = MacroFlow,
        CallFunctions = new HashSet<int> { 97, 98 },
        Facts =
        [
            .. CommonFacts,
            new("least increment", "0.001 mm, 0.0001 in (increment system IS-B).", Fanuc),
            new("numbers without a point", "Read as millimetres or inches (calculator-type decimal point, parameter 3401#0 = 1).", Assumed),
            new("arc tolerance", "Parameter 3410, taken as 0.02 mm; what is written agrees within 0.001 mm.", Assumed),
            new("G65 G66 M98", "Call a macro or subprogram.", Fanuc),
            new("G68 G51 G51.1 G16 G7.1 G12.1", "Rotation, scaling, mirror, polar coordinates, cylinder and polar interpolation: nothing is changed while one is active.", Fanuc),
        ],
    }));

    /// <summary>Delta NC300 series milling, as on the paper's machining center.</summary>
    public static NcDialect DeltaNc300 { get; } = FanucCodes(Iso6983(new("delta-nc300", "Delta NC300 series, milling: like Fanuc where not stated otherwise.")
    {
        FlowKeywords = MacroFlow,
        CallFunctions = new HashSet<int> { 97, 98 },
        Facts =
        [
            .. CommonFacts,
            new("least increment", "0.001 mm, 0.0001 in.", Delta),
            new("numbers", "A trailing point marks whole numbers (I6. F1000.), as in the blocks of figure 9 of Wang 2021.", "Wang 2021, figure 9"),
            new("arc tolerance", "Both radii agree within 0.02 mm; what is written agrees within 0.001 mm.", Assumed),
            new("macros", "Codes and calls as Fanuc.", Assumed),
        ],
    }));

    /// <summary>LinuxCNC 2.9.</summary>
    public static NcDialect LinuxCnc { get; } = Iso6983(new("linuxcnc", "LinuxCNC 2.9 (rs274).")
    {
        MetricDecimals = 4,
        InchDecimals = 5,
        ArcMismatchMm = 0.028,
        ArcMismatchOfRadius = 0.001,
        TurnsLetter = (byte)'P',
        FlowKeywords = OWordFlow,
        Facts =
        [
            .. CommonFacts,
            new("least increment", "None; 0.0001 mm and 0.00001 in are written.", Assumed),
            new("arc tolerance", "Radii may differ by 0.028 mm or 0.1 % of the radius.", "measured with rs274"),
            new("G90.1 G91.1", "Arc centers absolute or incremental.", LinuxCncManual),
            new("P with G2 G3", "Number of turns, the first included.", LinuxCncManual),
        ],
    })
        .Code(NcMeaning.AbsoluteCenters, 90.1).Code(NcMeaning.IncrementalCenters, 91.1)
        .Code(NcMeaning.Probe, 38.2, 38.3, 38.4, 38.5)
        .Code(NcMeaning.ClearPosition, 92.1, 92.2).Code(NcMeaning.RestorePosition, 92.3)
        .Code(NcMeaning.LengthOffset, 43.1, 43.2).Code(NcMeaning.InverseTimeFeed, 93).Code(NcMeaning.Harmless, 28.1, 30.1, 97, 96)
        .Code(NcMeaning.OpaqueCycle, 33, 33.1).Code(NcMeaning.Spline, 5, 5.1, 5.2)
        .Code(NcMeaning.CompensationLeft, 41.1).Code(NcMeaning.CompensationRight, 42.1);

    /// <summary>All built-in dialects, in the order in which they are listed.</summary>
    public static IReadOnlyList<NcDialect> All { get; } = [Generic, FanucMill, DeltaNc300, LinuxCnc];

    /// <summary>The dialect of a name.</summary>
    /// <exception cref="NcException">No dialect has this name (<see cref="NcErrorCode.UnknownDialect"/>).</exception>
    public static NcDialect Named(string name) => All.FirstOrDefault(d => d.Name == name)
        ?? throw new NcException(NcErrorCode.UnknownDialect, $"\"{name}\" is no known dialect. Known are {string.Join(", ", All.Select(d => d.Name))}.");

    private static NcDialect Iso6983(NcDialect dialect) => dialect
        .Letters(LetterRole.Axis, "XYZ").Letters(LetterRole.Center, "IJK").Letters(LetterRole.Radius, "R").Letters(LetterRole.Feed, "F")
        .Letters(LetterRole.G, "G").Letters(LetterRole.M, "M").Letters(LetterRole.Number, "N").Letters(LetterRole.Program, "O")
        .Letters(LetterRole.Harmless, "DHLPQST").Letters(LetterRole.OtherAxis, "ABCUVW")
        .Code(NcMeaning.Rapid, 0).Code(NcMeaning.Line, 1).Code(NcMeaning.ArcClockwise, 2).Code(NcMeaning.ArcCounterClockwise, 3)
        .Code(NcMeaning.Dwell, 4).Code(NcMeaning.SetOffset, 10).Code(NcMeaning.LocalShift, 52).Code(NcMeaning.SetPosition, 92)
        .Code(NcMeaning.PlaneXY, 17).Code(NcMeaning.PlaneZX, 18).Code(NcMeaning.PlaneYZ, 19)
        .Code(NcMeaning.Inch, 20).Code(NcMeaning.Metric, 21).Code(NcMeaning.ReferenceReturn, 28, 30)
        .Code(NcMeaning.CompensationOff, 40).Code(NcMeaning.CompensationLeft, 41).Code(NcMeaning.CompensationRight, 42)
        .Code(NcMeaning.LengthOffset, 43, 44).Code(NcMeaning.LengthOffsetOff, 49).Code(NcMeaning.Harmless, 9, 61, 61.1, 64)
        .Code(NcMeaning.FeedPerMinute, 94).Code(NcMeaning.FeedPerRevolution, 95).Code(NcMeaning.RetractToInitial, 98).Code(NcMeaning.RetractToR, 99)
        .Code(NcMeaning.MachineCoordinates, 53).Codes(NcMeaning.WorkOffset, 54, 59).Code(NcMeaning.WorkOffset, 54.1, 59.1, 59.2, 59.3)
        .Code(NcMeaning.CycleOff, 80).Code(NcMeaning.DrillCycle, 81).Code(NcMeaning.DwellDrillCycle, 82).Code(NcMeaning.PeckCycle, 83).Code(NcMeaning.ChipBreakCycle, 73)
        .Code(NcMeaning.FeedOutCycle, 74, 84, 85, 89).Code(NcMeaning.StopOutCycle, 86).Code(NcMeaning.OpaqueCycle, 76, 87, 88)
        .Code(NcMeaning.Rotation, 68).Code(NcMeaning.RotationOff, 69).Code(NcMeaning.Scaling, 51).Code(NcMeaning.ScalingOff, 50)
        .Code(NcMeaning.Mirroring, 51.1).Code(NcMeaning.MirroringOff, 50.1).Code(NcMeaning.Polar, 16).Code(NcMeaning.PolarOff, 15).Code(NcMeaning.OpaqueTransform, 68.2)
        .Code(NcMeaning.Absolute, 90).Code(NcMeaning.Incremental, 91);

    private static NcDialect FanucCodes(NcDialect dialect) => dialect
        .Code(NcMeaning.Harmless, 5, 5.1, 8, 11, 15.1, 23, 25, 26, 60, 62, 63, 96, 97).Code(NcMeaning.LengthOffset, 43.1).Code(NcMeaning.InverseTimeFeed, 93)
        .Code(NcMeaning.Dwell, 22).Code(NcMeaning.OpaqueCycle, 33).Code(NcMeaning.ReferenceReturn, 27, 29)
        .Code(NcMeaning.Probe, 31).Code(NcMeaning.Call, 65).Code(NcMeaning.ModalCall, 66).Code(NcMeaning.ModalCallOff, 67)
        .Code(NcMeaning.OpaqueTransform, 7.1, 12.1, 43.4, 43.5).Code(NcMeaning.OpaqueTransformOff, 13.1);
}
