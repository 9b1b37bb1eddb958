namespace ErrorMatching.Measurement;

/// <summary>The unit in which a file gives its coordinates.</summary>
public enum LengthUnit
{
    /// <summary>Millimeters.</summary>
    Millimeter,

    /// <summary>Inches of exactly 25.4 mm.</summary>
    Inch,
}
