using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>By what a correction may be made.</summary>
/// <param name="Allowed">The allowed kinds.</param>
/// <param name="OtherCutsMayMove">True if cuts that belong to no feature may move with an offset.</param>
/// <param name="WithinMm">How far the boundary by an offset may be from that by blocks, mm.</param>
/// <param name="FirstVariable">The first of the control's variables in which the program of the offsets keeps what it did; 0 if none is
/// stated.</param>
/// <param name="ProgramNumber">Number of the program of the offsets.</param>
/// <param name="Tool">Number of the tool; null if none is stated.</param>
/// <param name="RadiusOffset">Number of the radius offset; null if the program names it.</param>
/// <param name="Limits">The largest corrections.</param>
public sealed record JobCorrection(
    IReadOnlyList<CorrectionKind> Allowed,
    bool OtherCutsMayMove,
    double WithinMm,
    int FirstVariable,
    int ProgramNumber,
    int? Tool,
    int? RadiusOffset,
    OffsetLimits Limits)
{
    /// <summary>The default of <see cref="WithinMm"/>.</summary>
    public const double DefaultWithinMm = 0.001;

    /// <summary>The default of <see cref="ProgramNumber"/>.</summary>
    public const int DefaultProgramNumber = 9001;

    /// <summary>By blocks.</summary>
    public static JobCorrection Default { get; } =
        new([CorrectionKind.Blocks], false, DefaultWithinMm, 0, DefaultProgramNumber, null, null, OffsetLimits.Default);

    /// <summary>True if an offset may be changed.</summary>
    public bool AllowsOffsets => Allows(CorrectionKind.ToolWear) || Allows(CorrectionKind.WorkOffset);

    /// <summary>True if a kind is allowed.</summary>
    public bool Allows(CorrectionKind kind) => Allowed.Contains(kind);
}

/// <summary>By what a correction is made, the smallest first.</summary>
public enum CorrectionKind
{
    /// <summary>The radius of the tool in the control.</summary>
    ToolWear,

    /// <summary>The origin of the program, and its rotation.</summary>
    WorkOffset,

    /// <summary>The blocks of the program.</summary>
    Blocks,
}
