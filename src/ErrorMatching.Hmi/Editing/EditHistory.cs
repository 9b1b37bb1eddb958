using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>A draft with undo and redo. Successive input in one field is one step.</summary>
internal sealed class EditHistory
{
    private const int Most = 500;
    private readonly List<Step> _undo = [];
    private readonly List<Step> _redo = [];
    private string? _typing;

    /// <summary>The current draft.</summary>
    public MatingDraft Draft { get; private set; } = new();

    public bool CanUndo => _undo.Count > 0;

    public bool CanRedo => _redo.Count > 0;

    /// <summary>Starts with a draft and an empty history.</summary>
    public void Begin(MatingDraft draft)
    {
        _undo.Clear();
        _redo.Clear();
        (Draft, _typing) = (draft, null);
    }

    /// <summary>Changes the draft.</summary>
    /// <param name="draft">The new draft.</param>
    /// <param name="field">The field with the input; empty for a separate step.</param>
    public void Change(MatingDraft draft, string field)
    {
        if (_typing != field || field.Length == 0 || _redo.Count > 0)
        {
            _undo.Add(new(Draft, field));
            if (_undo.Count > Most)
            {
                _undo.RemoveAt(0);
            }
        }

        _redo.Clear();
        (Draft, _typing) = (draft, field);
    }

    public void Undo() => Go(_undo, _redo);

    public void Redo() => Go(_redo, _undo);

    private void Go(List<Step> from, List<Step> to)
    {
        if (from.Count > 0)
        {
            to.Add(new(Draft, from[^1].Field));
            Draft = from[^1].Draft;
            from.RemoveAt(from.Count - 1);
            _typing = null;
        }
    }

    /// <summary>An earlier or later draft.</summary>
    /// <param name="Draft">The draft.</param>
    /// <param name="Field">The field that was changed next; successive input in one field is one step.</param>
    private sealed record Step(MatingDraft Draft, string Field);
}
