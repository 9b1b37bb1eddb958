namespace ErrorMatching.Nc;

/// <summary>The modes of a call level as saved by M70 or M73.</summary>
/// <param name="State">Modes and feed, without the tool's place.</param>
/// <param name="WorkOffset">The selected work offset.</param>
/// <param name="IsWorkOffsetUnsure">True if something unseen could have selected another one.</param>
/// <param name="HasLength">True if a tool length was active.</param>
/// <param name="OpaqueFamilies">Active transformations that are not followed.</param>
/// <param name="AtReturn">True if they are restored when the call ends.</param>
internal readonly record struct SavedModes(
    ModalState State, (int Code, int Number) WorkOffset, bool IsWorkOffsetUnsure, bool HasLength, ulong OpaqueFamilies, bool AtReturn);
