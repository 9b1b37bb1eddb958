using ErrorMatching.Jobs;

namespace ErrorMatching.Cell;

/// <summary>What corrections are computed from, as the store keeps it.</summary>
internal static class CorrectionRequests
{
    /// <summary>The request of a recognized correction.</summary>
    /// <param name="flow">What workers share.</param>
    /// <param name="correction">The correction, with what it starts from and is compared with.</param>
    /// <param name="job">Its job.</param>
    /// <param name="measurement">Its measurement.</param>
    public static CorrectionRequest Of(CellFlow flow, Correction correction, CellJobSettings job, byte[] measurement) => new()
    {
        Job = job,
        Piece = correction.Piece!,
        Measurement = new(correction.FileName, measurement),
        Part = correction.PartSha256 is { } part ? new(flow.Store.OfMeasurement(part)[0].FileName, flow.Store.Content(part)) : null,
        Base = job.Accumulates && correction.SumsSha256 is not null ? flow.Store.Content(correction.BaseSha256!) : default(ReadOnlyMemory<byte>?),
        Sums = job.Accumulates && correction.SumsSha256 is { } sums ? CorrectionSums.FromJson(flow.Store.Content(sums)) : CorrectionSums.None,
        LastSent = job.IsFreeform ? LastSent(flow.Store, correction) : null,
        Identity = correction.Identity,
    };

    // While nobody has said whether the piece was cut before or behind the last program, it may have been cut by that.
    private static KeptFile? LastSent(CellStore store, Correction correction)
    {
        var cut = CutProgram.Of(store, correction);
        return (cut.By ?? cut.Undecided) is { ProgramSha256: { } program } sent ? new(sent.Program ?? FinishedSurface.Name, store.Content(program)) : null;
    }

    /// <summary>The request of a correction that was computed, to tell whether another one would be made of its measurement now.</summary>
    /// <param name="store">The store.</param>
    /// <param name="correction">The correction.</param>
    /// <param name="job">Its job.</param>
    /// <exception cref="StoreException">What it was computed from is not kept.</exception>
    public static CorrectionRequest Again(CellStore store, Correction correction, CellJobSettings job) => new()
    {
        Job = job,
        Piece = correction.Piece!,
        Measurement = new(correction.FileName, store.Content(correction.MeasurementSha256)),
        Part = correction.PartSha256 is { } part ? new("", store.Content(part)) : null,
        Base = job.Accumulates && CutProgram.Before(store, correction) is { ProgramSha256: { } cut } ? store.Content(cut) : default(ReadOnlyMemory<byte>?),
    };
}
