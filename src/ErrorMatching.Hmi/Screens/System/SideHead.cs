namespace ErrorMatching.Hmi;

/// <summary>The head of a tab: its name, how much is to be corrected and filled in there, and whether there are questions.</summary>
/// <param name="title">Text key of its name.</param>
internal sealed class SideHead(string title) : Observable
{
    private int _wrong;
    private int _missing;
    private int _asked;

    public string Title => Texts.Current[title];

    public string Missing => Shown.Count(_missing);

    /// <summary>All counts in words, or null.</summary>
    public string? Problem =>
        HasWrong || HasMissing || HasAsked
            ? string.Join(
                " · ",
                new[]
                {
                    DraftProblems.CountOf(_wrong, _missing),
                    HasAsked ? Texts.Current.With("Setup.Asked", _asked) : ""
                }.Where(t => t.Length > 0))
            : null;

    public bool HasWrong => _wrong > 0;

    public bool HasMissing => _missing > 0;

    /// <summary>True if something there is valid but probably unintended.</summary>
    public bool HasAsked => _asked > 0;

    /// <summary>True if the count is shown; there is space only for the most severe mark.</summary>
    public bool ShowsMissing => HasMissing && !HasWrong;

    /// <summary>True if the mark for questions is shown.</summary>
    public bool ShowsAsked => HasAsked && !HasWrong && !HasMissing;

    /// <summary>Sets how much is to be corrected, filled in and asked about there, in the display language.</summary>
    internal void Show(int wrong, int missing, int asked)
    {
        (_wrong, _missing, _asked) = (wrong, missing, asked);
        OnPropertyChanged();
    }
}
