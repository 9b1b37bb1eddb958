namespace ErrorMatching.Hmi;

/// <summary>A message to the user, with what to do next.</summary>
/// <param name="Severity">Its severity.</param>
/// <param name="What">The situation.</param>
/// <param name="Next">What to do.</param>
/// <param name="Correction">The correction to open; null if there is none.</param>
internal sealed record MessageRow(Severity Severity, string What, string Next, long? Correction)
{
    /// <summary>True to open the verification of a measured piece instead.</summary>
    public bool IsMeasured { get; init; }

    /// <summary>True if a tap opens something.</summary>
    public bool CanLook => Correction is not null;

    public string AutomationId { get; init; } = Correction is { } id ? "message-" + Shown.Id(id) : "message";
}
