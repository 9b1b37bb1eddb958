using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>A field that is on or off.</summary>
/// <param name="editing">The job that is edited.</param>
/// <param name="path">Where it stands in the draft.</param>
/// <param name="label">Key of its name.</param>
/// <param name="get">What the draft has there.</param>
/// <param name="set">The draft with something else there.</param>
public sealed class SwitchField(
    JobEditing editing, string path, string label, Func<MatingDraft, bool> get, Func<MatingDraft, bool, MatingDraft> set)
    : EditField(editing, path, label)
{
    private bool _shown;

    /// <summary>True if it is on.</summary>
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

    /// <inheritdoc/>
    protected override bool IsEmpty => false;

    /// <inheritdoc/>
    protected override void Refresh()
    {
        _shown = get(Editing.Draft);
        Say(nameof(IsOn));
    }
}
