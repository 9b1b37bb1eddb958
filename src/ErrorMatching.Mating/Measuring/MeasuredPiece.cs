namespace ErrorMatching.Mating;

/// <summary>Which of the two pieces was measured.</summary>
internal enum MeasuredPiece
{
    /// <summary>The part: its material is on the tool's side of the boundary that the counterpart's tool cuts.</summary>
    Part,

    /// <summary>The counterpart: its material is on the other side.</summary>
    Counterpart,
}
