using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A job that is to be saved where it is in use, or to be put in use: what its gauge runs from then on.
/// It takes a signature.</summary>
/// <param name="Place">The cell's job in whose place it comes: its machine and slot stay.</param>
/// <param name="Name">Its name.</param>
/// <param name="Before">Name of the one that is used.</param>
/// <param name="Undecided">How many corrections of that one still wait, are approved or failed.</param>
/// <param name="HasComments">True if its file has comments, which are not taken over.</param>
/// <param name="IsNew">True for another job that is put in its place.</param>
public sealed record JobReplacement(CellJobSettings Place, string Name, string Before, int Undecided, bool HasComments, bool IsNew)
{
    /// <summary>Whose place it takes, from when on and where, in words.</summary>
    public string Told => !IsNew ? "" : Texts.Current.With(
        Name == Before ? "Setup.Replace.ToldSame" : "Setup.Replace.Told",
        Name, Before.Length > 0 ? Before : Place.Name, Place.Machine, Place.Slot);

    /// <summary>What becomes of the corrections that still wait, and of what people wrote into the file;
    /// none where there is neither.</summary>
    public IReadOnlyList<Fact> Facts => [.. new[]
    {
        Undecided > 0 && IsNew ? new Fact(Texts.Current.With("Setup.Replace.Waiting", Undecided), Severity.Attention) : null,
        HasComments ? new Fact(Texts.Current["Setup.CommentsLost"], Severity.Attention) : null,
    }.OfType<Fact>()];
}
