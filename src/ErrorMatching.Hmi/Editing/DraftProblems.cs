using ErrorMatching.Cell;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>What is wrong with the draft, or doubtful. It is checked off the UI thread after each change.</summary>
internal sealed class DraftProblems
{
    private readonly Station _station;
    private readonly Func<MatingDraft> _draft;
    private readonly Action _shown;
    private readonly SynchronizationContext _screen = SynchronizationContext.Current!;
    private readonly Latest<DraftSnapshot> _checking;
    private IReadOnlyList<DraftProblem> _found = [];

    /// <summary>Knows nothing yet. Call it on the UI thread.</summary>
    /// <param name="station">The station.</param>
    /// <param name="draft">Returns the current draft.</param>
    /// <param name="shown">Called on the UI thread when the current draft was checked.</param>
    public DraftProblems(Station station, Func<MatingDraft> draft, Action shown)
    {
        (_station, _draft, _shown) = (station, draft, shown);
        _checking = new(LookThrough);
    }

    /// <summary>Known problems, including fields that need to be filled in.</summary>
    public IReadOnlyList<DraftProblem> All => Typed is { } typed ? [typed, .. _found] : _found;

    /// <summary>Known questions about valid but probably unintended input.</summary>
    public IReadOnlyList<DraftProblem> Doubts { get; private set; } = [];

    /// <summary>Problem with the last input that the draft cannot store.</summary>
    public DraftProblem? Typed { get; set; }

    /// <summary>True if they are those of the current draft.</summary>
    public bool IsChecked { get; private set; }

    public int MissingCount => All.Count(p => p.IsMissing);

    public int WrongCount => All.Count - MissingCount;

    /// <summary>Text with the numbers of errors and fields to fill in on each screen; empty if there are none.</summary>
    public string CountText => Texts.Current.Listed(All
        .GroupBy(p => (p.IsMissing, ProblemPlace.Of(_draft(), p.Field).ScreenKey))
        .OrderBy(g => g.Key.IsMissing).ThenBy(g => g.Key.ScreenKey == ScreenKeys.Points ? 0 : 1)
        .Select(g => Texts.Current.With(
            g.Key.IsMissing ? "Setup.MissingAt" : "Setup.WrongAt", g.Count(), Texts.Current["Screen." + g.Key.ScreenKey])));

    /// <summary>Completes when no check is running.</summary>
    public Task Running => _checking.Running;

    /// <summary>Text with the numbers of errors and fields to fill in; empty if there are none.</summary>
    public static string CountOf(int wrong, int missing) => string.Join(
        " · ",
        new[]
        {
            wrong > 0 ? Texts.Current.With("Setup.Problems", wrong) : "",
            missing > 0 ? Texts.Current.With("Setup.Missing", missing) : ""
        }.Where(t => t.Length > 0));

    /// <summary>Checks the current draft. Until then, the problems of the previous one are known.</summary>
    public void Check(DraftSnapshot snapshot)
    {
        IsChecked = false;
        _checking.Give(snapshot);
    }

    /// <summary>Forgets all, because another job is opened.</summary>
    public void Clear() => (_found, Doubts, Typed) = ([], [], null);

    private void LookThrough(DraftSnapshot snapshot)
    {
        var check = new JobEdits(_station.Settings, _station.Store, _station.Users).Check(snapshot.Job, snapshot.Draft);
        _screen.Post(
            _ =>
            {
                if (ReferenceEquals(snapshot.Draft, _draft()))
                {
                    (_found, Doubts, IsChecked) = (check.Problems, check.Doubts, true);
                    _shown();
                }
            },
            null);
    }
}
