using ErrorMatching.Mating;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>How far a program of offsets changes the control beyond what the slot's present program sets. In feed-forward, each correction
/// is computed from the uncorrected offset, so two that are within a step of it may be further than a step from each other.</summary>
internal static class OffsetStep
{
    private const int MostAlike = 100;

    /// <summary>Why the program must not follow the one that the slot has, and would stop at the machine; null if it may.</summary>
    /// <param name="store">The store.</param>
    /// <param name="approved">The correction to send.</param>
    /// <exception cref="StoreException">A content is missing.</exception>
    public static Statement? TooLarge(CellStore store, Correction approved)
    {
        if (approved is not { Offset: { } offset, JobSha256: { } job, Machine: { } machine, Slot: { } slot }
            || store.Slot(machine, slot).ProgramSha256 is not { } held
            || store.Search(new() { Program = held, Most = MostAlike }).FirstOrDefault(c =>
                c.ProgramSha256 == held && c.Offset is not null) is not { Offset: { } set } before) return null;
        var limits = MatingJob.Parse(store.Content(job), approved.Job ?? "").Correction.Limits;
        var now = RecordedOffset.Totals(set).ToDictionary(t => t.Name, t => t.Total, StringComparer.Ordinal);
        foreach (var (name, total, isAngle) in RecordedOffset.Totals(offset))
        {
            var limit = isAngle ? limits.StepDegrees : limits.StepMm;
            if (now.TryGetValue(name, out var from) && Math.Abs(total - from) > limit)
            {
                return isAngle ? RecordedOffset.TurnTooLarge.With(from, total, limit, before.Id)
                    : RecordedOffset.StepTooLarge.With(from, total, limit, before.Id);
            }
        }

        return null;
    }
}
