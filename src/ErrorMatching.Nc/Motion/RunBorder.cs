namespace ErrorMatching.Nc;

/// <summary>How a run came to a block: all that decides what plain cuts from there on are.</summary>
/// <param name="Motions">How many motions came before.</param>
/// <param name="State">What the control remembers.</param>
/// <param name="Integers">How many coordinates without a point came before.</param>
/// <param name="EndsCuts">True if all that ran since the border before are blocks between the two, each once, that do no more than move,
/// without a problem.</param>
internal readonly record struct RunBorder(int Motions, ModalState State, long Integers, bool EndsCuts);
