using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>A field with a choice of the job's words; their texts have the keys <c>LABEL.WORD</c>.</summary>
/// <param name="editing">The edited job.</param>
/// <param name="path">Its path in the draft.</param>
/// <param name="label">Text key of its name.</param>
/// <param name="words">The job's words.</param>
/// <param name="get">Reads the word from the draft.</param>
/// <param name="set">Returns the draft with another word.</param>
internal sealed class ChoiceField(
    JobEditing editing,
    string path,
    string label,
    IReadOnlyList<string> words,
    Func<MatingDraft, string> get,
    Func<MatingDraft, string, MatingDraft> set)
    : EditField(editing, path, label)
{
    private readonly string _label = label;
    private string _shown = "";
    private IReadOnlyList<ChoiceItem>? _items;

    /// <summary>The field of a word at a path of the draft, of those that the job's schema allows. Without one, the first of them
    /// holds.</summary>
    /// <param name="editing">The edited job.</param>
    /// <param name="path">The path.</param>
    /// <param name="label">Text key of its name.</param>
    public ChoiceField(JobEditing editing, string path, string label)
        : this(editing, path, label, MatingDraft.PlaceOf(path).Words)
    {
    }

    /// <summary>The field of one of some words at a path of the draft. Without one, the first of them holds.</summary>
    /// <param name="editing">The edited job.</param>
    /// <param name="path">The path.</param>
    /// <param name="label">Text key of its name.</param>
    /// <param name="words">The words.</param>
    public ChoiceField(JobEditing editing, string path, string label, IReadOnlyList<string> words)
        : this(editing, path, label, words, d => d[path] is { Length: > 0 } word ? word : words[0], (d, t) => d.With(path, t))
    {
    }

    public IReadOnlyList<ChoiceItem> Items => _items ??= [.. words.Select(w => new ChoiceItem(w, Texts.Current[$"{_label}.{w}"]))];

    public ChoiceItem? Chosen
    {
        get => Items.FirstOrDefault(i => i.Word == _shown);
        set
        {
            // While the list is recreated in another language, nothing is selected for a moment.
            if (value is not null && value.Word != _shown)
            {
                _shown = value.Word;
                Change(d => set(d, value.Word));
            }
        }
    }

    public string Word => _shown;

    protected override bool IsEmpty => false;

    protected override void Refresh()
    {
        _shown = get(Editing.Draft);
        if (_items is null || _items.Any(i => i.Name != Texts.Current[$"{_label}.{i.Word}"]))
        {
            _items = null;
            OnPropertyChanged(nameof(Items));
        }

        OnPropertyChanged(nameof(Chosen));
    }
}

/// <summary>An item of a choice.</summary>
/// <param name="Word">The job's word for it.</param>
/// <param name="Name">Its displayed name.</param>
internal sealed record ChoiceItem(string Word, string Name);
