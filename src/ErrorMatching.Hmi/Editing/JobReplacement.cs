using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A job in use to be saved, or a prepared job to be put in use. Changes what its gauge uses from then on and needs a
/// signature.</summary>
/// <param name="Place">The cell's job that it replaces; machine and slot stay.</param>
/// <param name="Name">Its name.</param>
/// <param name="Before">Name of the job in use.</param>
/// <param name="Undecided">Number of its corrections that are waiting, approved or failed.</param>
/// <param name="HasComments">True if its file has comments, which are lost.</param>
/// <param name="IsNew">True if a prepared job replaces it.</param>
public sealed record JobReplacement(CellJobSettings Place, string Name, string Before, int Undecided, bool HasComments, bool IsNew)
{
    /// <summary>Which job is replaced, where and from when, in words; empty unless <see cref="IsNew"/>.</summary>
    public string Told => !IsNew ? "" : Texts.Current.With(
        Name == Before ? "Setup.Replace.ToldSame" : "Setup.Replace.Told",
        Name, Before.Length > 0 ? Before : Place.Name, Place.Machine, Place.Slot);

    /// <summary>What happens to undecided corrections (only if <see cref="IsNew"/>) and to comments in the file; empty if there are
    /// none.</summary>
    public IReadOnlyList<Fact> Facts => [.. new[]
    {
        Undecided > 0 && IsNew ? new Fact(Texts.Current.With("Setup.Replace.Waiting", Undecided), Severity.Attention) : null,
        HasComments ? new Fact(Texts.Current["Setup.CommentsLost"], Severity.Attention) : null,
    }.OfType<Fact>()];
}
