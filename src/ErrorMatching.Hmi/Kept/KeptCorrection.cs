using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Everything that the store keeps of one correction, read once: for looking at it as it was, and as it is.</summary>
/// <param name="Correction">The correction.</param>
/// <param name="Steps">What became of it, step by step.</param>
/// <param name="Report">The report of the match; null if there is none, or it is of another kind.</param>
/// <param name="Lines">The original program and the new one, which is its own original where it was made anew; null before it is computed.</param>
public sealed record KeptCorrection(Correction Correction, IReadOnlyList<CorrectionStep> Steps, KeptReport? Report, ProgramLines? Lines)
{
    // A program may have been made several times: by pieces that were alike, or that were given again.
    private const int Looked = 100;

    // What stands before the first pass of a surface's program, in every dialect (Freeform's templates).
    private const int Head = 4096;

    private static ReadOnlySpan<byte> ToolCallBelongsHere => "put the tool call here"u8;

    /// <summary>The report of a surface; null if there is none.</summary>
    public KeptSurface? Surface { get; init; }

    /// <summary>The correction whose program the slot held before this one; null if it held none, or one that no correction made.</summary>
    public Correction? Before { get; init; }

    /// <summary>True if its program was made and calls no tool: its report says so, or in an old one a comment that marks where a call belongs.</summary>
    public bool LacksToolCall { get; init; }

    /// <summary>What its program does not have and the machine needs, in words; null if nothing.</summary>
    public string? Missing => !LacksToolCall ? null : Texts.Current[Surface?.CallsTool is null ? "Head.NoToolCall" : "Head.StopsWithoutTool"];

    /// <summary>True if the slot still holds the program of this correction, so that the one before can be brought back.</summary>
    public bool IsInSlot { get; init; }

    /// <summary>Where it moves its program most, as a step would record it; null where a step does, since it was not only tried.</summary>
    public string? TriedAt { get; init; }

    /// <summary>What people call the workpiece; null before it is recognized.</summary>
    public string? JobName => Report?.JobName ?? Surface?.JobName ?? Correction.Job;

    /// <summary>The workpiece, its number, and its serial number or file.</summary>
    public string Subject => JobName is { Length: > 0 } name ? $"{name} · {CorrectionLabel.Of(Correction)}" : CorrectionLabel.Of(Correction);

    /// <summary>Reads it. This takes its time: not to be called on the screen's thread.</summary>
    /// <param name="store">The store.</param>
    /// <param name="correction">The correction.</param>
    /// <exception cref="StoreException">The store cannot be read.</exception>
    public static KeptCorrection Read(CellStore store, Correction correction)
    {
        ArgumentNullException.ThrowIfNull(store);
        ArgumentNullException.ThrowIfNull(correction);
        var json = correction.ReportSha256 is { } sha ? store.Content(sha) : null;
        var (report, surface) = json is null ? (null, null) : (KeptReport.Read(json), KeptSurface.Read(json));
        var program = correction.ProgramSha256 is { } made ? store.Content(made) : null;
        var lines = program is null ? null
            : correction.BaseSha256 is { } was ? new ProgramLines(store.Content(was), program, report?.Blocks ?? [], (report?.Proof ?? surface?.Proof)?.Marker)
            : surface is not null ? new ProgramLines(program, program, [])
            : null;
        return new(correction, store.StepsOf(correction.Id), report, lines)
        {
            Surface = surface,
            LacksToolCall = surface is { CallsTool: var calls } && program is not null
                && !(calls ?? program.AsSpan(0, Math.Min(program.Length, Head)).IndexOf(ToolCallBelongsHere) < 0),
            Before = correction.PreviousSha256 is { } previous ? store.Search(new() { Program = previous, Most = Looked }).FirstOrDefault(c => c.ProgramSha256 == previous && c.Id < correction.Id) : null,
            IsInSlot = correction is { Machine: { } machine, Slot: { } slot, ProgramSha256: not null } && store.Slot(machine, slot) is var held && held.ProgramSha256 == correction.ProgramSha256 && (held.Correction is null || held.Correction == correction.Id),
        };
    }
}
