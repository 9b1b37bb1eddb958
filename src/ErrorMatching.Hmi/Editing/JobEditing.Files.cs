using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi;

/// <content>Opening, storing and saving, all off the UI thread.</content>
public sealed partial class JobEditing
{
    private SignedIn? _signed;

    private async Task LoadAsync(CellJobSettings job)
    {
        var (sha256, draft, hasComments, kept, isBroken, message) = await Task.Run(() => Open(job));
        if (job != Job)
        {
            return;
        }

        (_baseSha256, _base, Kept, IsKeptBroken, _isLoaded, _isTold, HasComments) = (
            sha256, draft ?? new(), kept, isBroken, draft is not null, false, hasComments);
        Message = message;
        _history.Begin(_base);
        IsChecked = false;
        _checking.Give(new(job, _base, _base, sha256, "", default));
        Changed?.Invoke();
        Refresh();
        await ReadJobsAsync();
        await ReadVersionsAsync(job);
    }

    private (
        string Sha256, MatingDraft? Draft, bool HasComments, KeptDraft? Kept, bool IsKeptBroken, string? Message) Open(CellJobSettings job)
    {
        KeptDraft? kept = null;
        var (isBroken, message) = (false, (string?)null);
        try
        {
            kept = NamesOf(job).Select(_drafts.Find).FirstOrDefault(k => k is not null);
        }
        catch (InputException e)
        {
            (isBroken, message) = (true, Texts.Current.With("Setup.KeptBroken", Failures.Of(e, _station.Clock)));
        }

        try
        {
            var sha256 = JobEdits.Sha256Of(job);
            var draft = MatingDraftFiles.Open(job.File);
            return (
                sha256,
                draft,
                MatingDraftFiles.HasComments(InputFile.Bytes(job.File, JsonLimits.Default.MaxBytes)),
                kept is { } k && k.BaseSha256 == sha256 && k.Draft.IsSame(draft) ? null : kept,
                isBroken,
                message);
        }
        catch (Exception e) when (e is InputException or DraftException)
        {
            return ("", null, false, null, isBroken, Texts.Current.With("Setup.NotOpened", Failures.Of(e, _station.Clock)));
        }
    }

    private void TakeKept()
    {
        if (Kept is { } kept)
        {
            Kept = null;

            // Saving reports a change made in the meantime.
            _baseSha256 = kept.BaseSha256;
            _history.Begin(_base);
            _history.Change(kept.Draft, "");
            Follow();
        }
    }

    // Changes may be stored under the name of another job of the cell with the same file.
    private IEnumerable<string> NamesOf(CellJobSettings job) =>
        _station.Settings.Jobs.Where(j => j.File == job.File).Select(j => j.Name).Prepend(job.Name).Distinct(StringComparer.Ordinal);

    private void Forget(CellJobSettings job)
    {
        foreach (var name in NamesOf(job))
        {
            _drafts.Forget(name);
        }
    }

    private async Task ForgetKeptAsync()
    {
        var job = Job!;
        if (await TryAsync(() => Forget(job)))
        {
            (Kept, IsKeptBroken) = (null, false);
            Refresh();
        }
    }

    /// <summary>Saves it with the requested signature (<see cref="Asked"/>).</summary>
    internal void SaveSigned(SignedIn by)
    {
        _signed = by;
        (IsBeside ? PutInUse : Save).Execute(null);
    }

    private async Task SaveAsync()
    {
        var (job, draft, sha256, signed) = (Job!, Draft, _baseSha256, _signed);
        _signed = null;
        await _checking.Running;
        await Task.Yield();
        if (Problems.Count > 0)
        {
            // This may open the other screen and clear all notices, so show the notice afterward.
            Tell();
            Note(() => Problems.Count > 0 ? Texts.Current.With("Setup.NotSaved", CountText) : "");
            return;
        }

        // A new job leaves the previous one unchanged.
        if (draft.IsBegunAnew)
        {
            await SaveBesideAsync(job, draft);
            return;
        }

        // Changing a job in use needs a signature.
        if ((IsBeside ? _who() : signed) is not { } by)
        {
            var undecided = 0;
            if (await TryAsync(() => undecided = Undecided(job).Length))
            {
                Asked?.Invoke(new(job, draft.Name.Trim(), _base.Name.Trim(), undecided, HasComments, IsNew: false));
            }

            return;
        }

        var (saved, isOtherProgram) = ("", false);
        if (await TryAsync(() =>
        {
            isOtherProgram = IsOtherProgram(job, draft);
            saved = Edits.Save(job, draft, sha256, by);
        }))
        {
            // The imported program is now the job's own.
            (_base, _baseSha256, HasComments) = (draft with { Program = null }, saved, false);
            _history.Begin(_base);
            await _keeping.Running;
            var isForgotten = await TryAsync(() => Forget(job));
            if (IsBeside)
            {
                Note(SavedBeside(job));
            }
            else if (isForgotten)
            {
                await TellSavedAsync(job, isOtherProgram);
            }

            Changed?.Invoke();
            await ReadVersionsAsync(job);
        }

        Refresh();
    }

    private async Task TellSavedAsync(CellJobSettings job, bool isOtherProgram)
    {
        IReadOnlyList<Correction> waiting = [];
        await TryAsync(() => waiting = MadeBefore(job));
        (_waiting, _first) = (waiting, waiting is [var first, ..] ? first.Id : null);
        _notice = () => Sentence.Joined(
            Texts.Current["Setup.Saved"],
            isOtherProgram ? Texts.Current["Setup.SavedProgram"] : "",
            waiting.Count > 0 ? Texts.Current.With("Setup.SavedWaiting", waiting.Count) : "");
    }

    // Compare bytes: importing the same program again is not a change.
    private bool IsOtherProgram(CellJobSettings job, MatingDraft draft)
    {
        if (draft.Program is not { } imported)
        {
            return draft.Counterpart.Program != _base.Counterpart.Program;
        }

        var before = Path.GetFullPath(Path.Combine(Path.GetDirectoryName(job.File)!, _base.Counterpart.Program));
        return !File.Exists(before) || !InputFile.Program(before).Span.SequenceEqual(imported.Bytes.Span);
    }

    private async Task<bool> TryAsync(Action work)
    {
        Message = null;
        if (await Failures.OfAsync(work, _station.Clock) is not { } failure)
        {
            return true;
        }

        Message = failure;
        return false;
    }
}
