namespace ErrorMatching.Hmi;

/// <summary>What a line of a plot stands for, which decides how it looks: never by color alone.</summary>
public enum SeriesKind
{
    /// <summary>Without compensation: a line with circles.</summary>
    Before,

    /// <summary>With it: a line with diamonds.</summary>
    After,

    /// <summary>A second figure without compensation: dashes.</summary>
    BeforeMean,

    /// <summary>A second figure with it: dashes.</summary>
    AfterMean,
}
