using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>A field that something is chosen in: the job's words, with texts <c>LABEL.WORD</c>.</summary>
/// <param name="editing">The job that is edited.</param>
/// <param name="path">Where it stands in the draft.</param>
/// <param name="label">Key of its name.</param>
/// <param name="words">The job's words.</param>
/// <param name="get">What the draft has there.</param>
/// <param name="set">The draft with something else there.</param>
public sealed class ChoiceField(
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

    /// <summary>What can be chosen.</summary>
    public IReadOnlyList<ChoiceItem> Items => _items ??= [.. words.Select(w => new ChoiceItem(w, Texts.Current[$"{_label}.{w}"]))];

    /// <summary>What is chosen.</summary>
    public ChoiceItem? Chosen
    {
        get => Items.FirstOrDefault(i => i.Word == _shown);
        set
        {
            // A list that is made anew in another language has nothing chosen for a moment.
            if (value is not null && value.Word != _shown)
            {
                _shown = value.Word;
                Change(d => set(d, value.Word));
            }
        }
    }

    /// <summary>The word that is chosen.</summary>
    public string Word => _shown;

    /// <inheritdoc/>
    protected override bool IsEmpty => false;

    /// <inheritdoc/>
    protected override void Refresh()
    {
        _shown = get(Editing.Draft);
        if (_items is null || _items.Any(i => i.Name != Texts.Current[$"{_label}.{i.Word}"]))
        {
            _items = null;
            Say(nameof(Items));
        }

        Say(nameof(Chosen));
    }
}
