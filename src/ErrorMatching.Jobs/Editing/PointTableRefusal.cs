namespace ErrorMatching.Jobs;

/// <summary>Why nothing of a <see cref="PointTable"/> was put into a draft.</summary>
public enum PointTableRefusal
{
    /// <summary>It was put in.</summary>
    None,

    /// <summary>The features have no points yet: none could have a coordinate.</summary>
    NoFeatures,

    /// <summary>A label stands there more than once.</summary>
    LabelTwice,

    /// <summary>Points that wait for their labels are not as many as the rows that are left for them:
    /// which row is whose cannot be known.</summary>
    OtherCount,

    /// <summary>Rows without labels are not as many as the points.</summary>
    NoLabels,
}
