namespace ErrorMatching.Nc;

/// <summary>Role of a letter or a multi-letter address in a dialect.</summary>
public enum LetterRole : byte
{
    /// <summary>Not in the table.</summary>
    Unknown,

    /// <summary>Changes no position: spindle, tool, offset numbers, parameters.</summary>
    Harmless,

    /// <summary>X, Y or Z.</summary>
    Axis,

    /// <summary>I, J or K.</summary>
    Center,

    /// <summary>Radius of an arc.</summary>
    Radius,

    /// <summary>Feed.</summary>
    Feed,

    /// <summary>Preparatory code.</summary>
    G,

    /// <summary>Miscellaneous function.</summary>
    M,

    /// <summary>Block number.</summary>
    Number,

    /// <summary>Program number.</summary>
    Program,

    /// <summary>A rotary or secondary axis.</summary>
    OtherAxis,

    /// <summary>A variable of the control, which itself moves nothing (Siemens <c>R1=5</c>).</summary>
    Variable,

    /// <summary>Opening angle of an arc (<c>AR=</c>).</summary>
    OpeningAngle,

    /// <summary>Number of turns of an arc beyond the first (<c>TURN=</c>).</summary>
    MoreTurns,

    /// <summary>Intermediate point of an arc along X, Y or Z (<c>I1=</c>, <c>J1=</c>, <c>K1=</c>).</summary>
    IntermediatePoint,

    /// <summary>Changes the tool and applies its length: where it is afterwards is unknown (<c>TOOL CALL 5</c>).</summary>
    ToolCall,

    /// <summary>Part of an end point that moves axes in a way that is not followed.</summary>
    PolarEnd,

    /// <summary>Radius of a polar end point about the pole (<c>RP=</c>).</summary>
    PolarRadius,

    /// <summary>Angle of a polar end point about the pole (<c>AP=</c>).</summary>
    PolarAngle,

    /// <summary>Angle of a straight line (<c>ANG=</c>).</summary>
    LineAngle,

    /// <summary>Activates a tool length that only the machine knows (Siemens <c>T</c> and <c>D</c>).</summary>
    Length,

    /// <summary>Number of a tool length: the active one becomes another, which only the machine knows (<c>H</c>).</summary>
    LengthNumber,
}
