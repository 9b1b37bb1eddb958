namespace ErrorMatching.Nc;

/// <summary>The state in which a run reached a block: all that determines the plain cuts from there on.</summary>
/// <param name="Motions">Number of motions so far.</param>
/// <param name="State">The modal state of the control.</param>
/// <param name="Integers">Number of coordinates without a decimal point so far.</param>
/// <param name="EndsCuts">True if, since the previous border, exactly the blocks between the two ran, each once, only moved, and had no
/// problem.</param>
internal readonly record struct RunBorder(int Motions, ModalState State, long Integers, bool EndsCuts);
