namespace ErrorMatching.Nc;

/// <summary>Finds roles that determine how a program continues. <see cref="NcFlow"/> executes or refuses them; the interpreter handles
/// all others.</summary>
internal static class Steering
{
    /// <summary>True unless a role means that the program continues with the next block: a role that is not listed here belongs to the
    /// flow.</summary>
    public static bool Steers(this FunctionRole role) => role is not (FunctionRole.Unknown or FunctionRole.Harmless or FunctionRole.Unsure
        or FunctionRole.SaveModes or FunctionRole.SaveModesOfCall or FunctionRole.RestoreModes or FunctionRole.DropModes);

    /// <summary>True for codes and words that call.</summary>
    public static bool Steers(this NcMeaning meaning) =>
        meaning is NcMeaning.Call or NcMeaning.ModalCall or NcMeaning.ModalCallOff or NcMeaning.OpaqueCall;
}
