using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A state to search for. The object stays the same in another language, so that it stays selected.</summary>
/// <param name="state">The state; null for any.</param>
internal sealed class StateChoice(CorrectionState? state) : Observable
{
    public CorrectionState? State { get; } = state;

    public string Name => State is { } known ? Texts.Current.Word(known) : Texts.Current["History.AnyState"];

    /// <summary>Updates the name after a change of language.</summary>
    internal void Rename() => OnPropertyChanged(nameof(Name));
}
