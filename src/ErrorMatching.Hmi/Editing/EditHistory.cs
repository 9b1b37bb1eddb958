using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>A draft with the ways back and forth. What is typed into one field in a row is one step.</summary>
internal sealed class EditHistory
{
    private const int Most = 500;
    private readonly List<EditStep> _undo = [];
    private readonly List<EditStep> _redo = [];
    private string? _typing;

    /// <summary>The draft as it is now.</summary>
    public MatingDraft Draft { get; private set; } = new();

    /// <summary>True if there is a way back.</summary>
    public bool CanUndo => _undo.Count > 0;

    /// <summary>True if there is a way forth.</summary>
    public bool CanRedo => _redo.Count > 0;

    /// <summary>Begins with a draft, without a way back.</summary>
    public void Begin(MatingDraft draft)
    {
        _undo.Clear();
        _redo.Clear();
        (Draft, _typing) = (draft, null);
    }

    /// <summary>Makes it another draft.</summary>
    /// <param name="draft">The other draft.</param>
    /// <param name="field">The field that is typed into; empty for a step of its own.</param>
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

    /// <summary>Goes back a step.</summary>
    public void Undo() => Go(_undo, _redo);

    /// <summary>Goes forth a step.</summary>
    public void Redo() => Go(_redo, _undo);

    private void Go(List<EditStep> from, List<EditStep> to)
    {
        if (from.Count > 0)
        {
            to.Add(new(Draft, from[^1].Field));
            Draft = from[^1].Draft;
            from.RemoveAt(from.Count - 1);
            _typing = null;
        }
    }
}
