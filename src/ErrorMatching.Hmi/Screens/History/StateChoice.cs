using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A state that can be looked for. It stays the same in another language, so that what is chosen stays chosen.</summary>
/// <param name="state">The state; null for any.</param>
public sealed class StateChoice(CorrectionState? state) : Observable
{
    /// <summary>The state; null for any.</summary>
    public CorrectionState? State { get; } = state;

    /// <summary>Its name.</summary>
    public string Name => State is { } known ? Texts.Current.Word(known) : Texts.Current["History.AnyState"];

    /// <summary>Says that the language is another one.</summary>
    internal void Rename() => Say(nameof(Name));
}
