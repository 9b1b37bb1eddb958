using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>An abnormal situation of a cell that somebody must act on. What waits for a decision in normal operation, such as an approval,
/// is no alarm.</summary>
/// <param name="Kind">What it is about.</param>
/// <param name="Key">Its name, the same as long as it lasts and whenever it returns; printable, at most <see cref="MostCharacters"/>
/// characters.</param>
/// <param name="Priority">Its priority.</param>
/// <param name="Since">Since when; null if that is not known.</param>
public sealed record Alarm(AlarmKind Kind, string Key, AlarmPriority Priority, DateTimeOffset? Since)
{
    /// <summary>Maximum length of a key.</summary>
    public const int MostCharacters = 200;

    private static readonly HashSet<string> Doubtful = new(StringComparer.Ordinal)
    {
        CellCodes.ChangedAtMachine, CellCodes.StartedMeanwhile, CellCodes.Of(StoreError.Tampered), CellCodes.Of(StoreError.Damaged),
    };

    /// <summary>What prevents a part of the cell from working; null for other kinds.</summary>
    public CellTrouble? Trouble { get; init; }

    /// <summary>What was changed from outside; null for other kinds.</summary>
    public Statement? Tampered { get; init; }

    /// <summary>The correction that it is about; null if there is none.</summary>
    public Correction? Correction { get; init; }

    /// <summary>The corrections to decide first, in line order; empty for other kinds than <see cref="AlarmKind.HeldUp"/>.</summary>
    public IReadOnlyList<Correction> Behind { get; init; } = [];

    /// <summary>The slot that a correction waits for; null for other kinds than <see cref="AlarmKind.HeldUp"/>.</summary>
    public SlotStatus? Slot { get; init; }

    /// <summary>True if it may be shelved. What stops everything, or casts doubt on a program at a machine, stays in sight.</summary>
    public bool MayBeShelved => Priority < AlarmPriority.High;

    /// <summary>The alarms of a cell, but for measured counterparts outside their limits (<see cref="OfOutside"/>), whose reports this does
    /// not read.</summary>
    /// <param name="status">The status of the cell.</param>
    public static IEnumerable<Alarm> Of(CellStatus status)
    {
        ArgumentNullException.ThrowIfNull(status);
        if (!status.IsRunning)
        {
            yield return new(AlarmKind.NotRunning, "cell", AlarmPriority.High, status.Heartbeat?.At);

            // A running cell reports these itself.
            foreach (var tampered in status.Tampered)
            {
                yield return new(AlarmKind.Tampered, KeyOf("store: " + tampered.Sentence), AlarmPriority.High, null)
                {
                    Tampered = tampered,
                };
            }
        }
        else
        {
            foreach (var trouble in status.Heartbeat!.Troubles)
            {
                yield return new(
                    AlarmKind.Trouble,
                    KeyOf($"{trouble.Where}: {trouble.Code}"),
                    Doubtful.Contains(trouble.Code) ? AlarmPriority.High : AlarmPriority.Medium,
                    trouble.Since)
                {
                    Trouble = trouble,
                };
            }
        }

        foreach (var failed in status.Failed)
        {
            yield return OfCorrection(AlarmKind.Failed, "failed", AlarmPriority.Medium, failed);
        }

        foreach (var (slot, up) in status.Slots.SelectMany(s => s.HeldUp.Select(h => (s, h))))
        {
            yield return OfCorrection(AlarmKind.HeldUp, "held up", AlarmPriority.Low, up.Correction) with
            {
                Behind = up.Behind,
                Slot = slot
            };
        }
    }

    /// <summary>The alarm of a measured counterpart outside its limits.</summary>
    /// <param name="counterpart">The correction that its measurement arrived as.</param>
    public static Alarm OfOutside(Correction counterpart) => OfCorrection(AlarmKind.Outside, "outside", AlarmPriority.Low, counterpart);

    private static Alarm OfCorrection(AlarmKind kind, string word, AlarmPriority priority, Correction correction)
    {
        ArgumentNullException.ThrowIfNull(correction);
        return new(kind, FormattableString.Invariant($"correction {correction.Id}: {word}"), priority, correction.ChangedAt)
        {
            Correction = correction,
        };
    }

    // Names of machines and gauges may have any characters.
    private static string KeyOf(string text)
    {
        var printable = string.Concat(text.Select(c => char.IsControl(c) ? ' ' : c));
        return printable.Length <= MostCharacters ? printable : printable[..(MostCharacters - 1)] + "…";
    }
}

/// <summary>How soon somebody must act on an alarm (ISA-18.2: by the consequence of doing nothing).</summary>
public enum AlarmPriority
{
    /// <summary>A piece or a program waits for a decision that somebody may not know of.</summary>
    Low,

    /// <summary>A part of the cell, or one correction, stands still.</summary>
    Medium,

    /// <summary>Nothing works, or a machine may cut with a program that the cell did not send.</summary>
    High,
}

/// <summary>What an alarm is about.</summary>
public enum AlarmKind
{
    /// <summary>The cell does not run.</summary>
    NotRunning,

    /// <summary>A part of a running cell cannot work: see <see cref="Alarm.Trouble"/>.</summary>
    Trouble,

    /// <summary>The store was changed from outside the cell: see <see cref="Alarm.Tampered"/>.</summary>
    Tampered,

    /// <summary>A correction failed: see <see cref="Alarm.Correction"/>.</summary>
    Failed,

    /// <summary>A measured counterpart is outside its limits: see <see cref="Alarm.Correction"/>.</summary>
    Outside,

    /// <summary>An approved correction waits in line behind one that nobody has decided: see <see cref="Alarm.Correction"/>,
    /// <see cref="Alarm.Behind"/> and <see cref="Alarm.Slot"/>.</summary>
    HeldUp,
}
