namespace ErrorMatching.Nc;

/// <summary>
/// Which roles decide how a program goes on. They are executed by <see cref="NcFlow"/>, or refused there; all others belong to the
/// interpreter.
/// </summary>
internal static class Steering
{
    /// <summary>
    /// True unless a role says that the program goes on with the next block: a role that is not listed here is the flow's.
    /// </summary>
    public static bool Steers(this FunctionRole role) => role is not (FunctionRole.Unknown or FunctionRole.Harmless or FunctionRole.Unsure
        or FunctionRole.SaveModes or FunctionRole.SaveModesOfCall or FunctionRole.RestoreModes or FunctionRole.DropModes);

    /// <summary>True for codes and words that call.</summary>
    public static bool Steers(this NcMeaning meaning) =>
        meaning is NcMeaning.Call or NcMeaning.ModalCall or NcMeaning.ModalCallOff or NcMeaning.OpaqueCall;
}
