namespace ErrorMatching.Hmi;

/// <summary>The head of a side of a screen: its name, and how much is to be corrected there.</summary>
/// <param name="title">Key of its name.</param>
public sealed class SideHead(string title) : Observable
{
    private int _problems;

    /// <summary>Its name.</summary>
    public string Title => Texts.Current[title];

    /// <summary>How much is to be corrected there.</summary>
    public string Count => Shown.Count(_problems);

    /// <summary>The same in words; null if nothing is.</summary>
    public string? Problem => HasProblems ? Texts.Current.With("Setup.Problems", _problems) : null;

    /// <summary>True if something is.</summary>
    public bool HasProblems => _problems > 0;

    /// <summary>Says how much is to be corrected there, in the language of the screen.</summary>
    internal void Show(int problems)
    {
        _problems = problems;
        Say();
    }
}
