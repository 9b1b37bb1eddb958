namespace ErrorMatching.Measurement;

/// <summary>How a file arranges its points.</summary>
public enum MeasurementKind
{
    /// <summary>One line per point: its label and its coordinates.</summary>
    Points,

    /// <summary>One line per coordinate of a feature: feature, item (X, Y, Z, ...), nominal, actual, deviation.</summary>
    FeatureTable,
}
