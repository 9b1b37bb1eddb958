using ErrorMatching.Cell;
using ErrorMatching.Mating;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>All that the store has about one correction, read once, for display.</summary>
/// <param name="Correction">The correction.</param>
/// <param name="Steps">Its history, step by step.</param>
/// <param name="Report">The report of the match; null if there is none, or if it is of another kind.</param>
/// <param name="Lines">The original program and the new one; a newly generated program, also one that sets offsets of the control, is its
/// own original. Null before it is computed.</param>
internal sealed record StoredCorrection(
    Correction Correction, IReadOnlyList<CorrectionStep> Steps, MatchReport? Report, ProgramLines? Lines)
{
    // Several corrections may have produced the same program, from identical pieces or a piece measured twice.
    private const int Looked = 100;

    public StoredSurface? Surface { get; init; }

    /// <summary>The correction whose program was in the slot before this one; null if there was no program, or none from a
    /// correction.</summary>
    public Correction? Before { get; init; }

    /// <summary>True if its program was generated and calls no tool.</summary>
    public bool LacksToolCall => Surface?.CallsTool == false;

    /// <summary>What the machine needs and its program lacks, in words; null if nothing.</summary>
    public string? Missing => LacksToolCall ? Texts.Current["Head.StopsWithoutTool"] : null;

    /// <summary>True if the slot still has this correction's program, so that the previous one can be restored.</summary>
    public bool IsInSlot { get; init; }

    /// <summary>Where the program is moved most, for a trial run; null if a step records it.</summary>
    public Statement? TriedAt { get; init; }

    /// <summary>The file of its job as it is now; null if the cell has none of this name.</summary>
    public string? JobFile { get; init; }

    /// <summary>The workpiece's name; null before it is recognized.</summary>
    public string? JobName => Report?.Job.Name ?? Surface?.JobName ?? Correction.Job;

    /// <summary>The workpiece, its number, and its serial number or file.</summary>
    public string Subject =>
        JobName is { Length: > 0 } name ? $"{name} · {CorrectionLabel.Of(Correction)}" : CorrectionLabel.Of(Correction);

    /// <summary>The same with the file of its job.</summary>
    public StoredCorrection With(CellSettings settings) =>
        this with { JobFile = settings.Jobs.FirstOrDefault(j => j.Name == Correction.Job && !j.IsFreeform)?.File };

    /// <summary>Reads it. Slow: do not call it on the UI thread.</summary>
    /// <param name="store">The store.</param>
    /// <param name="correction">The correction.</param>
    /// <exception cref="StoreException">The store cannot be read.</exception>
    /// <exception cref="InputException">Its report cannot be read.</exception>
    public static StoredCorrection Read(CellStore store, Correction correction)
    {
        ArgumentNullException.ThrowIfNull(store);
        ArgumentNullException.ThrowIfNull(correction);
        var stored = correction.ReportSha256 is { } sha ? StoredReport.Read(store.Content(sha)) : null;
        var (report, surface) = (stored?.Match, stored?.Surface);
        var program = correction.ProgramSha256 is { } made ? store.Content(made) : null;
        var lines = program is null ? null
            : correction.Offset is not null ? new ProgramLines(program, program, [])
            : correction.BaseSha256 is { } was
                ? new ProgramLines(store.Content(was), program, report?.Program.Blocks ?? [], (report?.Proof ?? surface?.Proof)?.Marker)
            : surface is not null ? new ProgramLines(program, program, [])
            : null;
        return new(correction, store.Corrections.StepsOf(correction.Id), report, lines)
        {
            Surface = surface,
            Before = correction.PreviousSha256 is { } previous
                ? store.Search(new() { Program = previous, Most = Looked }).FirstOrDefault(
                    c => c.ProgramSha256 == previous && c.Id < correction.Id)
                : null,
            IsInSlot = correction is { Machine: { } machine, Slot: { } slot, ProgramSha256: not null }
                && store.Slot(machine, slot) is var held
                && held.ProgramSha256 == correction.ProgramSha256
                && (held.Correction is null || held.Correction == correction.Id),
        };
    }
}
