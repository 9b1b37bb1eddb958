using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>A field of the draft on a screen: its name, and what is wrong with it.</summary>
/// <param name="editing">The job that is edited.</param>
/// <param name="path">Where it stands in the draft (<see cref="DraftPaths"/>).</param>
/// <param name="label">Key of its name.</param>
public abstract class EditField(JobEditing editing, string path, string label) : Observable
{
    /// <summary>What the identifiers of fields begin with.</summary>
    internal const string IdStart = "edit-";

    private string? _problem;
    private bool _isTouched;
    private bool _isWrong;
    private bool _isDoubtful;

    /// <summary>Where it stands in the draft.</summary>
    public string Path => path;

    /// <summary>Its name.</summary>
    public string Label => Texts.Current[label];

    /// <summary>Name of the row that it stands in, where others of its name stand in other rows; null where none does.</summary>
    public Func<string>? Row { get; init; }

    /// <summary>Its name with that of its row.</summary>
    public string Title => Row?.Invoke() is { Length: > 0 } row ? $"{row} · {Label}" : Label;

    /// <summary>Identifies it.</summary>
    public string AutomationId => IdStart + path.Replace("$.", "", StringComparison.Ordinal);

    /// <summary>Identifies what is wrong with it.</summary>
    public string ProblemId => "problem-" + path.Replace("$.", "", StringComparison.Ordinal);

    /// <summary>What is wrong with it, or that it is still to be filled in; null if nothing is.</summary>
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

    /// <summary>True if there is something to say of it.</summary>
    public bool HasProblem => Problem is not null;

    /// <summary>True if something is wrong with it; false also while it is only still to be filled in.</summary>
    public bool IsWrong
    {
        get => _isWrong;
        private set => Set(ref _isWrong, value);
    }

    /// <summary>True if it can be saved and is hardly meant.</summary>
    public bool IsDoubtful
    {
        get => _isDoubtful;
        private set => Set(ref _isDoubtful, value);
    }

    /// <summary>True if something is wrong with it or it is still to be filled in.</summary>
    public bool IsToMend => HasProblem && !IsDoubtful;

    /// <summary>True if nothing stands in it and that is told.</summary>
    public bool IsToFillIn => IsToMend && !IsWrong && IsEmpty;

    /// <summary>True if it can be edited now.</summary>
    public bool CanEdit => editing.CanEdit;

    /// <summary>The job that is edited.</summary>
    protected JobEditing Editing => editing;

    /// <summary>True if nothing was filled in.</summary>
    protected abstract bool IsEmpty { get; }

    /// <summary>Shows what the draft has, and what is wrong there.</summary>
    /// <param name="problems">The problems at this field.</param>
    /// <param name="doubts">The questions at this field, which are asked where nothing is wrong.</param>
    public void Show(IEnumerable<DraftProblem> problems, IEnumerable<DraftProblem> doubts)
    {
        // First what stands there: fields that were made anew are empty until then.
        Refresh();
        var all = problems.ToArray();
        var texts = all.Select(p => ProblemText.Of(p, IsEmpty)).Distinct(StringComparer.Ordinal).ToArray();
        var told = texts.Length > 0 && (editing.IsTold || _isTouched || !IsEmpty) ? Sentence.Joined(texts) : null;
        var questions = doubts.Select(d => ProblemText.Of(d)).ToArray();
        IsDoubtful = texts.Length == 0 && questions.Length > 0;
        Problem = IsDoubtful ? Sentence.Joined(questions) : told;
        IsWrong = HasProblem && all.Any(p => !p.IsMissing);
        Say(nameof(IsToMend));
        Say(nameof(IsToFillIn));
        Say(nameof(CanEdit));
        Say(nameof(Label));
        Say(nameof(Title));
        ShowTold();
    }

    /// <summary>Shows what the draft has.</summary>
    protected abstract void Refresh();

    /// <summary>Shows what follows from what is wrong.</summary>
    protected virtual void ShowTold()
    {
    }

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
