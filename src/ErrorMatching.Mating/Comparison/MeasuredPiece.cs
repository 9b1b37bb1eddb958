namespace ErrorMatching.Mating;

/// <summary>Which of the two pieces was measured.</summary>
internal enum MeasuredPiece
{
    /// <summary>The part: its material lies on the tool's side of the boundary that the counterpart's tool cuts.</summary>
    Part,

    /// <summary>The counterpart: its material lies on the other side.</summary>
    Counterpart,
}
