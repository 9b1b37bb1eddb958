namespace ErrorMatching.Hmi;

/// <summary>Something that a person should know before signing.</summary>
/// <param name="Text">In words, with its figures.</param>
/// <param name="Severity">How much it asks for attention.</param>
public sealed record Fact(string Text, Severity Severity)
{
    /// <summary>True if it has a sign: a mere figure is no tick.</summary>
    public bool IsLoud => Severity is not Severity.Quiet;
}
