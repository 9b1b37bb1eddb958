namespace ErrorMatching.Freeform;

/// <summary>An attribute of a STEP instance.</summary>
/// <param name="Kind">What it is.</param>
/// <param name="Text">The string, the word without its points, or the name of the type.</param>
/// <param name="Number">The number, or the number of the instance that is referred to.</param>
/// <param name="Items">The values in the brackets.</param>
internal sealed record StepValue(StepValueKind Kind, string Text, double Number, IReadOnlyList<StepValue> Items)
{
    /// <summary>A value that was left out.</summary>
    public static StepValue Omitted { get; } = new(StepValueKind.Omitted, "", 0, []);
}
