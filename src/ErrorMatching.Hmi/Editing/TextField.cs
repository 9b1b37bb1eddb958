using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>A field that is typed into.</summary>
/// <param name="editing">The job that is edited.</param>
/// <param name="path">Where it stands in the draft.</param>
/// <param name="label">Key of its name.</param>
/// <param name="get">What the draft has there.</param>
/// <param name="set">The draft with something else there.</param>
public sealed class TextField(JobEditing editing, string path, string label, Func<MatingDraft, string> get, Func<MatingDraft, string, MatingDraft> set) : EditField(editing, path, label)
{
    private string _shown = "";

    /// <summary>What stands there.</summary>
    public string Text
    {
        get => _shown;
        set
        {
            if (value is not null && value != _shown)
            {
                _shown = value;
                Change(d => set(d, value));
            }
        }
    }

    /// <inheritdoc/>
    protected override bool IsEmpty => string.IsNullOrWhiteSpace(_shown);

    /// <inheritdoc/>
    protected override void Refresh()
    {
        Set(ref _shown, get(Editing.Draft), nameof(Text));
    }
}
