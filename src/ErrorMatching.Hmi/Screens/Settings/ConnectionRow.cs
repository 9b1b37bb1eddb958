namespace ErrorMatching.Hmi;

/// <summary>A connection to test: the store, a machine, a gauge, or a job's files.</summary>
/// <param name="Kind">Its kind: <c>store</c>, <c>machine</c>, <c>gauge</c> or <c>job</c>.</param>
/// <param name="Name">Its display name.</param>
/// <param name="Where">Its address or path.</param>
/// <param name="Found">The result of the test; null before it was tested.</param>
/// <param name="Outcome">The result in words.</param>
internal sealed record ConnectionRow(string Kind, string Name, string Where, Severity? Found, string Outcome)
{
    /// <summary>Its kind, in a word.</summary>
    public string KindName => Texts.Current["Connection." + Kind];

    /// <summary>Key of the icon of the result; null before it was tested.</summary>
    public string? Icon =>
        Found switch { Severity.Alarm => "Icon.alarm", Severity.Attention => "Icon.attention", Severity.Quiet => "Icon.quiet", _ => null };

    /// <summary>True if it does not respond.</summary>
    public bool IsAlarm => Found is Severity.Alarm;

    public string AutomationId => $"connection-{Kind}-{Name}";
}
