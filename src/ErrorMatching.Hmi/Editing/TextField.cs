using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>A text field.</summary>
/// <param name="editing">The edited job.</param>
/// <param name="path">Its path in the draft.</param>
/// <param name="label">Text key of its name.</param>
/// <param name="get">Reads the text from the draft.</param>
/// <param name="set">Returns the draft with another text.</param>
/// <param name="misread">Returns the code of the problem with a text that the draft cannot store, null for any other text; null if the
/// draft can store every text.</param>
internal sealed class TextField(
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

    /// <summary>The field of the text at a path of the draft.</summary>
    /// <param name="editing">The edited job.</param>
    /// <param name="path">The path.</param>
    /// <param name="label">Text key of its name.</param>
    public TextField(JobEditing editing, string path, string label)
        : this(editing, path, label, d => d[path], (d, t) => d.With(path, t))
    {
    }

    /// <summary>The default value that applies while it is empty; null if there is none.</summary>
    public string? Default { get; init; }

    /// <summary>Whether it may stay empty in a draft; null if never.</summary>
    public Func<MatingDraft, bool>? MayBeEmpty { get; init; }

    /// <summary>Text key of an example input, or null.</summary>
    public string? Example { get; init; }

    /// <summary>True if the job wants a number here.</summary>
    public bool IsNumber { get; } = MatingDraft.PlaceOf(path) is { TakesNumbers: true, TakesTexts: false };

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

    /// <summary>The decimals that the number lacks compared with its column (<see cref="Decimals"/>), or empty.</summary>
    public string Missing
    {
        get => _missing;
        internal set => Set(ref _missing, value);
    }

    protected override bool IsEmpty => string.IsNullOrWhiteSpace(_shown);

    protected override void ShowTold() => OnPropertyChanged(nameof(Placeholder));

    protected override void Refresh()
    {
        // Keep input that cannot be intended, so that the user can correct it.
        if (Editing.Typed?.Field != Path)
        {
            Set(ref _shown, get(Editing.Draft), nameof(Text));
        }
    }
}
