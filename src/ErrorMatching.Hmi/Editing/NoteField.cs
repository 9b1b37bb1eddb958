namespace ErrorMatching.Hmi;

/// <summary>A place without input that can have a problem, such as an empty list.</summary>
/// <param name="editing">The edited job.</param>
/// <param name="path">Its path in the draft.</param>
/// <param name="label">Text key of its name.</param>
internal sealed class NoteField(JobEditing editing, string path, string label) : EditField(editing, path, label)
{
    protected override bool IsEmpty => true;

    protected override void Refresh()
    {
        // Only the problem is shown.
    }
}
