using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi;

/// <content>Prepared jobs: edited without affecting the job in use, and put in its place with a signature.</content>
public sealed partial class JobEditing
{
    // Hash of the job in use when the user was asked: the signature applies to replacing exactly this version.
    private string _replacedSha256 = "";

    /// <summary>True while a prepared job is edited.</summary>
    public bool IsBeside => Job is { } job && !Edits.IsInUse(job);

    /// <summary>The cell's job that the edited job belongs to or may replace; null before one is chosen.</summary>
    public CellJobSettings? Place => Job is { } job ? Edits.PlaceOf(job) : null;

    /// <summary>Replaces the job in use with this one, once all changes are saved.</summary>
    public LongCommand PutInUse { get; }

    // If several jobs share a file, as for part and counterpart, use the first that is not the counterpart's.
    private static IEnumerable<CellJobSettings> InUse(CellSettings settings) => settings.Jobs.Where(j => !j.IsFreeform)
        .GroupBy(j => j.File, StringComparer.Ordinal).Select(g => g.FirstOrDefault(j => j.Piece != "counterpart") ?? g.First());

    // If the prepared jobs cannot be listed, report it and keep the list.
    private async Task ReadJobsAsync()
    {
        IReadOnlyList<CellJobSettings> jobs = [];
        var read = () => { jobs = [.. InUse(_station.Settings).SelectMany(j => Edits.PreparedFor(j).Prepend(j))]; };
        if (await Failures.OfAsync(read, _station.Clock) is { } failure)
        {
            Message = failure;
            return;
        }

        Jobs.Show(jobs);
    }

    private async Task SaveBesideAsync(CellJobSettings job, MatingDraft draft)
    {
        var by = _who()!;
        CellJobSettings? prepared = null;
        if (await TryAsync(() => prepared = Edits.Prepare(job, draft, by)))
        {
            await _keeping.Running;
            await ReadJobsAsync();
            Choose(prepared);
            await Loading;
            await TryAsync(() => Forget(job));
            Note(SavedBeside(prepared!));
        }

        Refresh();
    }

    private Func<string> SavedBeside(CellJobSettings prepared)
    {
        var place = Edits.PlaceOf(prepared);
        return () => Texts.Current.With("Setup.SavedBeside", prepared.Name, place.Name, place.Machine, place.Slot);
    }

    private async Task PutInUseAsync()
    {
        var (job, place, draft, signed) = (Job!, Place!, Draft, _signed);
        _signed = null;
        await _checking.Running;
        await Task.Yield();
        if (Problems.Count > 0)
        {
            Tell();
            Note(() => Problems.Count > 0 ? Texts.Current.With("Setup.NotSaved", CountText) : "");
            return;
        }

        if (signed is not { } by)
        {
            JobReplacement? replacement = null;
            if (await TryAsync(() => replacement = Replacing(place, draft)))
            {
                Asked?.Invoke(replacement!);
            }

            return;
        }

        var isOtherProgram = false;
        if (await TryAsync(() =>
        {
            isOtherProgram = IsOtherProgram(Running(place), InputFile.Program(PathOf(job, draft.Counterpart.Program)));
            Edits.PutInUse(job, draft, _replacedSha256, by);
        }))
        {
            Choose(place);
            await Loading;
            await TellSavedAsync(place, isOtherProgram);
        }

        Refresh();
    }

    private JobReplacement Replacing(CellJobSettings place, MatingDraft draft)
    {
        _replacedSha256 = JobEdits.Sha256Of(place);
        var hasComments = _replacedSha256.Length > 0
            && MatingDraftFiles.HasComments(InputFile.Bytes(place.File, JsonLimits.Default.MaxBytes));
        return new(place, draft.Name.Trim(), Running(place)?.Name ?? "", Undecided(place).Length, hasComments, IsNew: true);
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

    private static string PathOf(CellJobSettings job, string name) =>
        Path.GetFullPath(Path.Combine(Path.GetDirectoryName(job.File)!, name));
}
