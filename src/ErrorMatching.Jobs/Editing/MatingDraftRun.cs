using ErrorMatching.Mating;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Runs a draft on a measurement without saving it, in the same way as its files would run.</summary>
public static class MatingDraftRun
{
    /// <summary>Runs a draft.</summary>
    /// <param name="draft">The draft.</param>
    /// <param name="file">The job's file, for relative paths.</param>
    /// <param name="request">The run's request; theoretical points and an imported program come from the draft.</param>
    /// <param name="cancellation">Checked between reading and calculating.</param>
    /// <exception cref="InputException">The draft has problems. A file cannot be opened. A measurement or the points cannot be
    /// used. A measurement is of the other piece. The job's own dialect cannot be used. The dialect, a selector or the program
    /// cannot be read. The measured points determine no result.</exception>
    /// <exception cref="OperationCanceledException">Cancelled.</exception>
    public static Outcome<MatchedProgram> Run(MatingDraft draft, string file, MatingRequest request, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(draft);
        ArgumentNullException.ThrowIfNull(request);
        var job = MatingJob.Parse(MatingDraftFiles.Job(draft), file);
        return MatingRun.Run(
            new(job),
            request with
            {
                Theoretical = new(job.Part.Theoretical, MatingDraftFiles.Theoretical(draft)),
                Program = draft.Program is { } program ? new(job.PathOf(job.Counterpart.Program), program.Bytes) : request.Program,
            },
            cancellation);
    }
}
