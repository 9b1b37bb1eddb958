namespace ErrorMatching.Jobs;

/// <summary>Why nothing from a <see cref="PointTable"/> was put into a draft.</summary>
public enum PointTableRefusal
{
    /// <summary>Not refused; the coordinates were taken.</summary>
    None,

    /// <summary>The features have no points yet to take coordinates.</summary>
    NoFeatures,

    /// <summary>The table has a duplicate label.</summary>
    LabelTwice,

    /// <summary>The number of points waiting for labels and the number of unused rows differ, so rows cannot be assigned.</summary>
    OtherCount,

    /// <summary>The number of rows without labels differs from the number of points.</summary>
    NoLabels,
}
