using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>A field that is typed into.</summary>
/// <param name="editing">The job that is edited.</param>
/// <param name="path">Where it stands in the draft.</param>
/// <param name="label">Key of its name.</param>
/// <param name="get">What the draft has there.</param>
/// <param name="set">The draft with something else there.</param>
/// <param name="misread">Code of what is wrong with a text that the draft has no place for, null for every other;
/// null if it has a place for all of them.</param>
public sealed class TextField(
    JobEditing editing,
    string path,
    string label,
    Func<MatingDraft, string> get,
    Func<MatingDraft, string, MatingDraft> set,
    Func<string, string?>? misread = null)
    : EditField(editing, path, label)
{
    private string _shown = "";
    private string _missing = "";

    /// <summary>What holds while it is empty: a value; null where nothing does.</summary>
    public string? Default { get; init; }

    /// <summary>Whether it may stay empty in a draft; null if it never may.</summary>
    public Func<MatingDraft, bool>? MayBeEmpty { get; init; }

    /// <summary>Key of an example of what is typed there; null for none.</summary>
    public string? Example { get; init; }

    /// <summary>What stands in the empty field.</summary>
    public string Placeholder =>
        IsToFillIn
            ? Texts.Current["Setup.FillIn"]
            : Example is { } example
            ? Texts.Current[example]
            : MayBeEmpty?.Invoke(Editing.Draft) != true
            ? ""
            : Default is { } value
            ? Texts.Current.With("Setup.Default", value)
            : Texts.Current["Setup.Optional"];

    /// <summary>What stands there.</summary>
    public string Text
    {
        get => _shown;
        set
        {
            if (value is not null && value != _shown)
            {
                _shown = value;
                if (misread?.Invoke(value) is { } code)
                {
                    Mistyped(new(Path, code, value, value));
                }
                else
                {
                    Change(d => set(d, value));
                }
            }
        }
    }

    /// <summary>What the number lacks to as many decimals as others of its column have (<see cref="Decimals"/>);
    /// empty if nothing.</summary>
    public string Missing
    {
        get => _missing;
        internal set => Set(ref _missing, value);
    }

    /// <inheritdoc/>
    protected override bool IsEmpty => string.IsNullOrWhiteSpace(_shown);

    /// <inheritdoc/>
    protected override void ShowTold() => Say(nameof(Placeholder));

    /// <inheritdoc/>
    protected override void Refresh()
    {
        // What was typed and cannot be meant stays to be mended.
        if (Editing.Typed?.Field != Path)
        {
            Set(ref _shown, get(Editing.Draft), nameof(Text));
        }
    }
}
