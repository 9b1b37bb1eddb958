namespace ErrorMatching.Hmi.Platform;

/// <summary>What the X Input Extension reports of a finger, or of the pointer, on a window.</summary>
/// <param name="Window">The window.</param>
/// <param name="Kind"><see cref="XInput.TouchBegin"/>, <see cref="XInput.TouchUpdate"/>, <see cref="XInput.TouchEnd"/> or
/// <see cref="XInput.Motion"/>.</param>
/// <param name="Finger">The finger, from its beginning to its end; for the pointer, of no meaning.</param>
/// <param name="X">Pixels from the window's left edge.</param>
/// <param name="Y">Pixels from the window's upper edge.</param>
/// <param name="State">Modifiers and buttons that are held, as in an event of the core protocol.</param>
/// <param name="IsMarked">Of a finger: it is lifted, and another client still decides whose it was (XITouchPendingEnd). Of the pointer: a
/// finger moved it (XIPointerEmulated).</param>
internal readonly record struct XInputEvent(nint Window, int Kind, uint Finger, double X, double Y, uint State, bool IsMarked);
