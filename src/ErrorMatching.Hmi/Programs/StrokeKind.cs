namespace ErrorMatching.Hmi;

/// <summary>How a stroke is drawn, from the bottom layer to the top.</summary>
internal enum StrokeKind
{
    /// <summary>Dashed: a rapid.</summary>
    Rapid,

    /// <summary>Solid: a cut.</summary>
    Cut,

    /// <summary>Thick: part of a feature.</summary>
    Feature,

    /// <summary>Thick and in the selection's color, with a ring at its start and a dot at its end.</summary>
    Chosen,
}
