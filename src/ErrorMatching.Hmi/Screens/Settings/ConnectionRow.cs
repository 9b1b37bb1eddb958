namespace ErrorMatching.Hmi;

/// <summary>Something that has to answer: the store, a machine, a gauge, a job's files.</summary>
/// <param name="Kind">Which of them: <c>store</c>, <c>machine</c>, <c>gauge</c> or <c>job</c>.</param>
/// <param name="Name">What people call it.</param>
/// <param name="Where">Where it is.</param>
/// <param name="Found">How it is; null before it was tested.</param>
/// <param name="Outcome">That in words.</param>
public sealed record ConnectionRow(string Kind, string Name, string Where, Severity? Found, string Outcome)
{
    /// <summary>Which kind it is, in a word.</summary>
    public string KindName => Texts.Current["Connection." + Kind];

    /// <summary>Key of the icon of how it is; null before it was tested.</summary>
    public string? Icon => Found switch { Severity.Alarm => "Icon.alarm", Severity.Attention => "Icon.attention", Severity.Quiet => "Icon.quiet", _ => null };

    /// <summary>True if it does not answer.</summary>
    public bool IsAlarm => Found is Severity.Alarm;

    /// <summary>Identifies the row.</summary>
    public string AutomationId => $"connection-{Kind}-{Name}";
}
