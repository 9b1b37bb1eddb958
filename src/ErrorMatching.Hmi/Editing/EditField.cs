using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>A field of the draft on a screen, with its name and its problem.</summary>
/// <param name="editing">The edited job.</param>
/// <param name="path">Its path in the draft (<see cref="DraftPaths"/>).</param>
/// <param name="label">Text key of its name.</param>
internal abstract class EditField(JobEditing editing, string path, string label) : Observable
{
    /// <summary>Prefix of field identifiers.</summary>
    internal const string IdStart = "edit-";

    private string? _problem;
    private bool _isTouched;
    private bool _isWrong;
    private bool _isDoubtful;

    public string Path => path;

    public string Label => Texts.Current[label];

    /// <summary>Name of its row, if rows have fields with the same name; otherwise null.</summary>
    public Func<string>? Row { get; init; }

    /// <summary>Its name with that of its row.</summary>
    public string Title => Row?.Invoke() is { Length: > 0 } row ? $"{row} · {Label}" : Label;

    public string AutomationId => IdStart + path.Replace("$.", "", StringComparison.Ordinal);

    public string ProblemId => "problem-" + path.Replace("$.", "", StringComparison.Ordinal);

    /// <summary>Its problem, question, or reminder to fill it in; null if there is none.</summary>
    public string? Problem
    {
        get => _problem;
        private set
        {
            if (Set(ref _problem, value))
            {
                OnPropertyChanged(nameof(HasProblem));
            }
        }
    }

    public bool HasProblem => Problem is not null;

    /// <summary>True if its value is wrong; false if it only needs to be filled in.</summary>
    public bool IsWrong
    {
        get => _isWrong;
        private set => Set(ref _isWrong, value);
    }

    /// <summary>True if its value is valid but probably unintended.</summary>
    public bool IsDoubtful
    {
        get => _isDoubtful;
        private set => Set(ref _isDoubtful, value);
    }

    /// <summary>True if it is wrong or needs to be filled in.</summary>
    public bool IsToMend => HasProblem && !IsDoubtful;

    /// <summary>True if it is empty and shown as such.</summary>
    public bool IsToFillIn => IsToMend && !IsWrong && IsEmpty;

    public bool CanEdit => editing.CanEdit;

    protected JobEditing Editing => editing;

    protected abstract bool IsEmpty { get; }

    /// <summary>Shows the draft's value and its problems.</summary>
    /// <param name="problems">The problems at this field.</param>
    /// <param name="doubts">The questions at this field, shown if there are no problems.</param>
    public void Show(IEnumerable<DraftProblem> problems, IEnumerable<DraftProblem> doubts)
    {
        // Show the value first: recreated fields are empty until then.
        Refresh();
        var all = problems.ToArray();
        var texts = all.Select(p => ProblemText.Of(p, IsEmpty)).Distinct(StringComparer.Ordinal).ToArray();
        var told = texts.Length > 0 && (editing.IsTold || _isTouched || !IsEmpty) ? Sentence.Joined(texts) : null;
        var questions = doubts.Select(d => ProblemText.Of(d)).ToArray();
        IsDoubtful = texts.Length == 0 && questions.Length > 0;
        Problem = IsDoubtful ? Sentence.Joined(questions) : told;
        IsWrong = HasProblem && all.Any(p => !p.IsMissing);
        OnPropertyChanged(nameof(IsToMend));
        OnPropertyChanged(nameof(IsToFillIn));
        OnPropertyChanged(nameof(CanEdit));
        OnPropertyChanged(nameof(Label));
        OnPropertyChanged(nameof(Title));
        ShowTold();
    }

    /// <summary>Shows the draft's value.</summary>
    protected abstract void Refresh();

    /// <summary>Shows what depends on the problems.</summary>
    protected virtual void ShowTold()
    {
    }

    protected void Change(Func<MatingDraft, MatingDraft> change)
    {
        _isTouched = true;
        editing.Typed = null;
        editing.Change(path, change);
    }

    /// <summary>Reports that the typed text cannot be intended.</summary>
    protected void Mistyped(DraftProblem problem)
    {
        _isTouched = true;
        editing.Typed = problem;
    }
}
