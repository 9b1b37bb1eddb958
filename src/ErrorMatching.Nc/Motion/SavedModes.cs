namespace ErrorMatching.Nc;

/// <summary>The modes of a call level as M70 or M73 found them.</summary>
/// <param name="State">Modes and feed; where the tool was is not part of them.</param>
/// <param name="WorkOffset">The work offset that was chosen.</param>
/// <param name="IsWorkOffsetUnsure">True if something unseen could have chosen another one.</param>
/// <param name="HasLength">True if a tool length was in force.</param>
/// <param name="OpaqueFamilies">Transformations that are not followed and were active.</param>
/// <param name="AtReturn">True if they are restored when the call ends.</param>
internal readonly record struct SavedModes(
    ModalState State, (int Code, int Number) WorkOffset, bool IsWorkOffsetUnsure, bool HasLength, ulong OpaqueFamilies, bool AtReturn);
