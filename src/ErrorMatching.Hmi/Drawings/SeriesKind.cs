namespace ErrorMatching.Hmi;

/// <summary>The meaning of a plot line, which decides how it looks: never by color alone.</summary>
internal enum SeriesKind
{
    /// <summary>Without compensation: a line with circles.</summary>
    Before,

    /// <summary>With compensation: a line with diamonds.</summary>
    After,

    /// <summary>A second figure without compensation: dashes.</summary>
    BeforeMean,

    /// <summary>A second figure with compensation: dashes.</summary>
    AfterMean,
}
