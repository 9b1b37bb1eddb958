namespace ErrorMatching.Hmi;

/// <summary>Height of touch targets.</summary>
public enum TouchSize
{
    /// <summary>15 mm.</summary>
    Standard,

    /// <summary>17.5 mm, for thick gloves.</summary>
    Large,

    /// <summary>20 mm.</summary>
    Largest,
}
