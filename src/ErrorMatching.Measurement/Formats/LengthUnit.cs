namespace ErrorMatching.Measurement;

/// <summary>The unit of a file's coordinates.</summary>
public enum LengthUnit
{
    /// <summary>Millimeters.</summary>
    Millimeter,

    /// <summary>Inches of exactly 25.4 mm.</summary>
    Inch,
}
