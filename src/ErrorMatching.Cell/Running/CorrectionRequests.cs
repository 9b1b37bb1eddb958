using ErrorMatching.Jobs;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Builds the inputs of corrections from the store.</summary>
internal static class CorrectionRequests
{
    private const string ReportName = "report.json";

    /// <summary>The request of a recognized correction.</summary>
    /// <param name="flow">State shared by the workers.</param>
    /// <param name="correction">The correction, with its base program and the measurement that it is compared with.</param>
    /// <param name="job">Its job.</param>
    /// <param name="measurement">Its measurement.</param>
    public static CorrectionRequest Of(CellFlow flow, Correction correction, CellJobSettings job, byte[] measurement) => new()
    {
        Job = job,
        Piece = correction.Piece!,
        Measurement = new(correction.FileName, measurement),
        Part = correction.PartSha256 is { } part
            ? new(flow.Store.Corrections.OfMeasurement(part)[0].FileName, flow.Store.Content(part))
            : null,
        Base = job.Accumulates && !job.IsFreeform && correction.SumsSha256 is not null
            ? flow.Store.Content(correction.BaseSha256!)
            : default(ReadOnlyMemory<byte>?),
        Sums = job.Accumulates && correction.SumsSha256 is { } sums
            ? CorrectionSums.FromJson(flow.Store.Content(sums))
            : CorrectionSums.None,
        LastSent = job.IsFreeform ? LastSent(flow.Store, correction) : null,
        Previous = !job.Accumulates ? null
            : ReportOf(
                flow.Store,
                job.IsFreeform ? CutProgram.Of(flow.Store, correction).By : CutProgram.Before(flow.Store, correction)),
        ToolChanged = job.Accumulates && ChangesTool(flow, correction, job, measurement),
        SlotProgram = flow.Settings.Machines.FirstOrDefault(m => m.Name == job.Machine)?.Slots
                .FirstOrDefault(s => s.Name == job.Slot)?.Program,
        Identity = correction.Identity,
    };

    // As the patterns say that made the file this job's.
    private static bool ChangesTool(CellFlow flow, Correction correction, CellJobSettings job, byte[] measurement) => new JobPatterns(job)
        .Match(new(correction.FileName, measurement, flow.Settings.Gauges.FirstOrDefault(g => g.Name == correction.Gauge)?.Format))
        is { ToolChanged: true };

    // Until someone records whether the piece was cut before or after the last program was sent, that program may have cut it.
    private static StoredFile? LastSent(CellStore store, Correction correction)
    {
        var cut = CutProgram.Of(store, correction);
        return (cut.By ?? cut.Undecided) is { ProgramSha256: { } program } sent
            ? new(sent.Program ?? FinishedSurface.Name, store.Content(program))
            : null;
    }

    /// <summary>Asks for a computed correction once more, to see whether its measurement would give a different one now.</summary>
    /// <exception cref="StoreException">Its inputs are not in the store.</exception>
    public static CorrectionRequest OfRecalculation(CellStore store, Correction correction, CellJobSettings job) => new()
    {
        Job = job,
        Piece = correction.Piece!,
        Measurement = new(correction.FileName, store.Content(correction.MeasurementSha256)),
        Part = correction.PartSha256 is { } part ? new("", store.Content(part)) : null,
        Base = job.Accumulates && !job.IsFreeform && CutProgram.Before(store, correction) is { ProgramSha256: { } cut }
            ? store.Content(cut)
            : default(ReadOnlyMemory<byte>?),
        Previous = job.Accumulates && correction.ReportSha256 is { } report
            ? PreviousOf(store, report)
            : null,
    };

    private static StoredFile? ReportOf(CellStore store, Correction? cut) =>
        cut?.ReportSha256 is { } report ? new(ReportName, store.Content(report)) : null;

    // The report names the one that it went on from.
    private static StoredFile? PreviousOf(CellStore store, string reportSha256) =>
        ReportReader.Document(store.Content(reportSha256)).Inputs().FirstOrDefault(i => i.Role == PreviousReport.Role) is { } previous
            ? new(ReportName, store.Content(previous.Sha256))
            : null;
}
