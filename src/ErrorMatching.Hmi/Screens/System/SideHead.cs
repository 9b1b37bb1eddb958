namespace ErrorMatching.Hmi;

/// <summary>The head of a side of a screen: its name, and how much is to be corrected and to be filled in there.</summary>
/// <param name="title">Key of its name.</param>
public sealed class SideHead(string title) : Observable
{
    private int _wrong;
    private int _missing;

    /// <summary>Its name.</summary>
    public string Title => Texts.Current[title];

    /// <summary>How much is to be corrected there.</summary>
    public string Wrong => Shown.Count(_wrong);

    /// <summary>How much is still to be filled in there.</summary>
    public string Missing => Shown.Count(_missing);

    /// <summary>Both in words; null if there is nothing.</summary>
    public string? Problem => HasWrong || HasMissing ? JobEditing.CountOf(_wrong, _missing) : null;

    /// <summary>True if something is to be corrected there.</summary>
    public bool HasWrong => _wrong > 0;

    /// <summary>True if something is still to be filled in there.</summary>
    public bool HasMissing => _missing > 0;

    /// <summary>Says how much is to be corrected and to be filled in there, in the language of the screen.</summary>
    internal void Show(int wrong, int missing)
    {
        (_wrong, _missing) = (wrong, missing);
        Say();
    }
}
