using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi;

/// <summary>Saves the edited job, all off the UI thread: a job in use with a signature, a new job as a prepared one, which is put in
/// the place of the job in use later.</summary>
internal sealed class JobSaving
{
    private readonly JobEditing _editing;
    private readonly JobEdits _edits;
    private readonly Func<SignedIn?> _who;
    private readonly Action<JobReplacement> _ask;
    private SignedIn? _signed;

    // Hash of the job in use when the user was asked: the signature applies to replacing exactly this version.
    private string _replacedSha256 = "";

    /// <summary>Saves nothing yet.</summary>
    /// <param name="editing">The edited job.</param>
    /// <param name="edits">Replaces the job's files.</param>
    /// <param name="who">Returns the signed-in user.</param>
    /// <param name="ask">Asks for the signature, which comes with <see cref="Sign"/>.</param>
    public JobSaving(JobEditing editing, JobEdits edits, Func<SignedIn?> who, Action<JobReplacement> ask)
    {
        (_editing, _edits, _who, _ask) = (editing, edits, who, ask);
        Save = new(_ => SaveAsync(), () => editing.CanEdit && editing.IsChanged);
        PutInUse = new(_ => PutInUseAsync(), () => editing.CanEdit && editing.IsBeside && !editing.IsChanged);
    }

    /// <summary>Saves the draft (<see cref="JobEditing.Save"/>).</summary>
    public LongCommand Save { get; }

    /// <summary>Replaces the job in use (<see cref="JobEditing.PutInUse"/>).</summary>
    public LongCommand PutInUse { get; }

    /// <summary>Goes on with the requested signature.</summary>
    public void Sign(SignedIn by)
    {
        _signed = by;
        (_editing.IsBeside ? PutInUse : Save).Execute(null);
    }

    private async Task SaveAsync()
    {
        var (job, draft, sha256, signed) = (_editing.Job!, _editing.Draft, _editing.BaseSha256, _signed);
        _signed = null;
        if (await HasProblemsAsync())
        {
            return;
        }

        // A new job leaves the previous one unchanged.
        if (draft.IsBegunAnew)
        {
            await SaveBesideAsync(job, draft);
            return;
        }

        // Changing a job in use needs a signature.
        var before = _editing.Base;
        if ((_editing.IsBeside ? _who() : signed) is not { } by)
        {
            var undecided = 0;
            if (await _editing.TryAsync(() => undecided = _editing.Earlier.Undecided(job).Count))
            {
                _ask(new(job, draft.Name.Trim(), before.Name.Trim(), undecided, _editing.HasComments, IsNew: false));
            }

            return;
        }

        var (saved, isOtherProgram) = ("", false);
        if (await _editing.TryAsync(() =>
        {
            isOtherProgram = IsOtherProgram(job, before, draft);
            saved = _edits.Save(job, draft, sha256, by);
        }))
        {
            _editing.TakeSaved(draft, saved);
            await _editing.Recovery.Running;
            var isForgotten = await _editing.TryAsync(() => _editing.Recovery.Forget(job));
            if (_editing.IsBeside)
            {
                _editing.Note(SavedBeside(job));
            }
            else if (isForgotten)
            {
                await TellSavedAsync(job, isOtherProgram);
            }

            await _editing.ShowSavedAsync(job);
        }

        _editing.Refresh();
    }

    private async Task SaveBesideAsync(CellJobSettings job, MatingDraft draft)
    {
        var by = _who()!;
        CellJobSettings? prepared = null;
        if (await _editing.TryAsync(() => prepared = _edits.Prepare(job, draft, by)))
        {
            await _editing.Recovery.Running;
            await _editing.ReadJobsAsync();
            _editing.Choose(prepared);
            await _editing.Loading;
            await _editing.TryAsync(() => _editing.Recovery.Forget(job));
            _editing.Note(SavedBeside(prepared!));
        }

        _editing.Refresh();
    }

    private async Task PutInUseAsync()
    {
        var (job, place, draft, signed) = (_editing.Job!, _editing.Place!, _editing.Draft, _signed);
        _signed = null;
        if (await HasProblemsAsync())
        {
            return;
        }

        if (signed is not { } by)
        {
            JobReplacement? replacement = null;
            if (await _editing.TryAsync(() => replacement = Replacing(place, draft)))
            {
                _ask(replacement!);
            }

            return;
        }

        var isOtherProgram = false;
        if (await _editing.TryAsync(() =>
        {
            isOtherProgram = IsOtherProgram(Running(place), InputFile.Program(PathOf(job, draft[DraftPaths.Program])));
            _edits.PutInUse(job, draft, _replacedSha256, by);
        }))
        {
            _editing.Choose(place);
            await _editing.Loading;
            await TellSavedAsync(place, isOtherProgram);
        }

        _editing.Refresh();
    }

    // Goes to the problems and tells how many there are.
    private async Task<bool> HasProblemsAsync()
    {
        await _editing.Checking;
        await Task.Yield();
        if (_editing.Problems.Count == 0)
        {
            return false;
        }

        // This may open the other screen and clear all notices, so show the notice afterward.
        _editing.Report();
        _editing.Note(() => _editing.Problems.Count > 0 ? Texts.Current.With("Setup.NotSaved", _editing.CountText) : "");
        return true;
    }

    private Func<string> SavedBeside(CellJobSettings prepared)
    {
        var place = _edits.PlaceOf(prepared);
        return () => Texts.Current.With("Setup.SavedBeside", prepared.Name, place.Name, place.Machine, place.Slot);
    }

    private async Task TellSavedAsync(CellJobSettings job, bool isOtherProgram)
    {
        IReadOnlyList<Correction> waiting = [];
        await _editing.TryAsync(() => waiting = _editing.Earlier.MadeBefore(job));
        _editing.Note(
            () => Sentence.Joined(
                Texts.Current["Setup.Saved"],
                isOtherProgram ? Texts.Current["Setup.SavedProgram"] : "",
                waiting.Count > 0 ? Texts.Current.With("Setup.SavedWaiting", waiting.Count) : ""),
            waiting);
    }

    private JobReplacement Replacing(CellJobSettings place, MatingDraft draft)
    {
        _replacedSha256 = JobEdits.Sha256Of(place);
        var hasComments = _replacedSha256.Length > 0
            && MatingDraftFiles.HasComments(InputFile.Bytes(place.File, JsonLimits.Default.MaxBytes));
        return new(
            place, draft.Name.Trim(), Running(place)?.Name ?? "", _editing.Earlier.Undecided(place).Count, hasComments, IsNew: true);
    }

    // Null if the job in use is unusable; it can be replaced all the same.
    private static MatingJob? Running(CellJobSettings place)
    {
        try
        {
            return InputFile.Job(place.File);
        }
        catch (InputException)
        {
            return null;
        }
    }

    private static bool IsOtherProgram(MatingJob? before, ReadOnlyMemory<byte> program) =>
        before?.PathOf(before.Counterpart.Program) is not { } file || !File.Exists(file)
        || !InputFile.Program(file).Span.SequenceEqual(program.Span);

    // Compare bytes: importing the same program again is not a change.
    private static bool IsOtherProgram(CellJobSettings job, MatingDraft before, MatingDraft draft)
    {
        if (draft.Program is not { } imported)
        {
            return draft[DraftPaths.Program] != before[DraftPaths.Program];
        }

        var file = PathOf(job, before[DraftPaths.Program]);
        return !File.Exists(file) || !InputFile.Program(file).Span.SequenceEqual(imported.Bytes.Span);
    }

    private static string PathOf(CellJobSettings job, string name) =>
        Path.GetFullPath(Path.Combine(Path.GetDirectoryName(job.File)!, name));
}
