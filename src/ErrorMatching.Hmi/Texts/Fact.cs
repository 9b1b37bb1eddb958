namespace ErrorMatching.Hmi;

/// <summary>A fact that the user should know before signing.</summary>
/// <param name="Text">The text, with its numbers.</param>
/// <param name="Severity">Its severity.</param>
public sealed record Fact(string Text, Severity Severity)
{
    /// <summary>True if it has an icon; a plain number needs none.</summary>
    public bool IsLoud => Severity is not Severity.Quiet;
}
