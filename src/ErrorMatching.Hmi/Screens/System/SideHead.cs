namespace ErrorMatching.Hmi;

/// <summary>The head of a side of a screen: its name, how much is to be corrected and to be filled in there,
/// and whether something is asked about.</summary>
/// <param name="title">Key of its name.</param>
public sealed class SideHead(string title) : Observable
{
    private int _wrong;
    private int _missing;
    private int _asked;

    /// <summary>Its name.</summary>
    public string Title => Texts.Current[title];

    /// <summary>How much is still to be filled in there.</summary>
    public string Missing => Shown.Count(_missing);

    /// <summary>All in words; null if there is nothing.</summary>
    public string? Problem =>
        HasWrong || HasMissing || HasAsked
            ? string.Join(
                " · ",
                new[]
                {
                    JobEditing.CountOf(_wrong, _missing),
                    HasAsked ? Texts.Current.With("Setup.Asked", _asked) : ""
                }.Where(t => t.Length > 0))
            : null;

    /// <summary>True if something is to be corrected there.</summary>
    public bool HasWrong => _wrong > 0;

    /// <summary>True if something is still to be filled in there.</summary>
    public bool HasMissing => _missing > 0;

    /// <summary>True if something can be saved there and is hardly meant.</summary>
    public bool HasAsked => _asked > 0;

    /// <summary>True where that much is shown: there is room for the worst alone.</summary>
    public bool ShowsMissing => HasMissing && !HasWrong;

    /// <summary>True where it is shown that something is asked about.</summary>
    public bool ShowsAsked => HasAsked && !HasWrong && !HasMissing;

    /// <summary>Says how much is to be corrected and to be filled in there, and how much is asked about,
    /// in the language of the screen.</summary>
    internal void Show(int wrong, int missing, int asked)
    {
        (_wrong, _missing, _asked) = (wrong, missing, asked);
        Say();
    }
}
