namespace ErrorMatching.Hmi;

/// <summary>Something that a person should know, and what to do next.</summary>
/// <param name="Severity">How much it asks for attention.</param>
/// <param name="What">What is so.</param>
/// <param name="Next">What to do.</param>
/// <param name="Correction">What to look at; null if there is nothing.</param>
public sealed record MessageRow(Severity Severity, string What, string Next, long? Correction)
{
    /// <summary>True where what is to be looked at is how well a measured piece fits.</summary>
    public bool IsMeasured { get; init; }

    /// <summary>True if a tap leads on.</summary>
    public bool CanLook => Correction is not null;

    /// <summary>Identifies the row.</summary>
    public string AutomationId { get; init; } = Correction is { } id ? "message-" + Shown.Id(id) : "message";
}
