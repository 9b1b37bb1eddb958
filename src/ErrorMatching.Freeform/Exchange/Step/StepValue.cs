namespace ErrorMatching.Freeform;

/// <summary>An attribute of a STEP instance.</summary>
/// <param name="Kind">Its kind.</param>
/// <param name="Text">The string, the word without its periods, or the type name.</param>
/// <param name="Number">The number, or the referenced instance number.</param>
/// <param name="Items">The values in parentheses.</param>
internal sealed record StepValue(StepValueKind Kind, string Text, double Number, IReadOnlyList<StepValue> Items)
{
    public static StepValue Omitted { get; } = new(StepValueKind.Omitted, "", 0, []);
}
