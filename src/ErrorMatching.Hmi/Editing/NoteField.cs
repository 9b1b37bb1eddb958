namespace ErrorMatching.Hmi;

/// <summary>A place where something can be wrong that is not typed itself, such as a list that is empty.</summary>
/// <param name="editing">The job that is edited.</param>
/// <param name="path">Where it stands in the draft.</param>
/// <param name="label">Key of its name.</param>
public sealed class NoteField(JobEditing editing, string path, string label) : EditField(editing, path, label)
{
    /// <inheritdoc/>
    protected override bool IsEmpty => true;

    /// <inheritdoc/>
    protected override void Refresh()
    {
        // There is nothing to show but what is wrong.
    }
}
