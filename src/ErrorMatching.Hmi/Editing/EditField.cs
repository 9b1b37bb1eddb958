using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>A field of the draft on a screen: its name, and what is wrong with it beside it.</summary>
/// <param name="editing">The job that is edited.</param>
/// <param name="path">Where it stands in the draft (<see cref="DraftPaths"/>).</param>
/// <param name="label">Key of its name.</param>
public abstract class EditField(JobEditing editing, string path, string label) : Observable
{
    private string? _problem;
    private bool _isTouched;

    /// <summary>Where it stands in the draft.</summary>
    public string Path => path;

    /// <summary>Its name.</summary>
    public string Label => Texts.Current[label];

    /// <summary>Identifies it.</summary>
    public string AutomationId => "edit-" + path.Replace("$.", "", StringComparison.Ordinal);

    /// <summary>Identifies what is wrong with it.</summary>
    public string ProblemId => "problem-" + path.Replace("$.", "", StringComparison.Ordinal);

    /// <summary>What is wrong with it; null if nothing is.</summary>
    public string? Problem
    {
        get => _problem;
        private set
        {
            if (Set(ref _problem, value))
            {
                Say(nameof(HasProblem));
            }
        }
    }

    /// <summary>True if something is wrong with it.</summary>
    public bool HasProblem => Problem is not null;

    /// <summary>True if it can be edited now.</summary>
    public bool CanEdit => editing.CanEdit;

    /// <summary>The job that is edited.</summary>
    protected JobEditing Editing => editing;

    /// <summary>True if nothing was filled in.</summary>
    protected abstract bool IsEmpty { get; }

    /// <summary>Shows what the draft has, and what is wrong there.</summary>
    /// <param name="problems">The problems at this field.</param>
    public void Show(IEnumerable<DraftProblem> problems)
    {
        // First what stands there: fields that were made anew are empty until then.
        Refresh();
        var texts = problems.Select(p => ProblemText.Of(p, IsEmpty)).Distinct(StringComparer.Ordinal).ToArray();
        Problem = texts.Length > 0 && (editing.IsTold || _isTouched || !IsEmpty) ? Sentence.Joined(texts) : null;
        Say(nameof(CanEdit));
        Say(nameof(Label));
    }

    /// <summary>Shows what the draft has.</summary>
    protected abstract void Refresh();

    /// <summary>Changes the draft.</summary>
    protected void Change(Func<MatingDraft, MatingDraft> change)
    {
        _isTouched = true;
        editing.Typed = null;
        editing.Change(path, change);
    }

    /// <summary>Says that what was typed cannot be meant.</summary>
    protected void Mistyped(DraftProblem problem)
    {
        _isTouched = true;
        editing.Typed = problem;
    }
}
