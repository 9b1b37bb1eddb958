namespace ErrorMatching.Hmi;

/// <summary>How a move is drawn, from below to above.</summary>
internal enum StrokeKind
{
    /// <summary>Dashed: nothing is cut.</summary>
    Rapid,

    /// <summary>Solid: a cut.</summary>
    Cut,

    /// <summary>Thick: it belongs to a feature.</summary>
    Feature,

    /// <summary>Thick and in the color of what is chosen, with a ring at its start and a dot at its end.</summary>
    Chosen,
}
