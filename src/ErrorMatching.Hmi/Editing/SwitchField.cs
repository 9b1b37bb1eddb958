using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>A field that is on or off.</summary>
/// <param name="editing">The edited job.</param>
/// <param name="path">Its path in the draft.</param>
/// <param name="label">Text key of its name.</param>
/// <param name="get">Reads the value from the draft.</param>
/// <param name="set">Returns the draft with another value.</param>
internal sealed class SwitchField(
    JobEditing editing, string path, string label, Func<MatingDraft, bool> get, Func<MatingDraft, bool, MatingDraft> set)
    : EditField(editing, path, label)
{
    private bool _shown;

    /// <summary>The field of a value at a path of the draft that is off without it.</summary>
    /// <param name="editing">The edited job.</param>
    /// <param name="path">The path.</param>
    /// <param name="label">Text key of its name.</param>
    public SwitchField(JobEditing editing, string path, string label)
        : this(editing, path, label, d => d[path] == "true", (d, on) => d.With(path, on ? "true" : ""))
    {
    }

    public bool IsOn
    {
        get => _shown;
        set
        {
            if (value != _shown)
            {
                _shown = value;
                Change(d => set(d, value));
            }
        }
    }

    protected override bool IsEmpty => false;

    protected override void Refresh()
    {
        _shown = get(Editing.Draft);
        OnPropertyChanged(nameof(IsOn));
    }
}
