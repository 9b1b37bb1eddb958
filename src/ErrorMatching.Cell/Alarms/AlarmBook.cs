using System.Globalization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Who acknowledged which alarm, and who shelved it until when. The audit trail is where this is stored, and nowhere else. One
/// thread at a time may read.</summary>
/// <param name="store">The store.</param>
/// <param name="clock">The clock.</param>
public sealed class AlarmBook(CellStore store, TimeProvider clock)
{
    /// <summary>The word of the audit trail for acknowledging an alarm.</summary>
    public const string Acknowledged = "alarm-acknowledged";

    /// <summary>The word of the audit trail for shelving an alarm.</summary>
    public const string Shelved = "alarm-shelved";

    /// <summary>The word of the audit trail for bringing a shelved alarm back.</summary>
    public const string Unshelved = "alarm-unshelved";

    private readonly Dictionary<string, AlarmMark> _marks = new(StringComparer.Ordinal);
    private Dictionary<string, AlarmMark> _read = new(StringComparer.Ordinal);
    private long _seen;

    /// <summary>The longest time that an alarm may be shelved.</summary>
    public static TimeSpan MostShelved { get; } = TimeSpan.FromHours(24);

    /// <summary>The words of the audit trail's entries about alarms: what raised and ended them, and what people did about them.</summary>
    public static IReadOnlyList<string> Words { get; } =
    [
        Acknowledged, Shelved, Unshelved, "failed", "started", "stopped", AuditLedger.Tampered, CellCodes.ChangedAtMachine,
        CellCodes.HeldAgain, CellCodes.NoAnswer, CellCodes.AnswersAgain, CellCodes.WaitsTooLong, CellCodes.ReadBackUnseen,
    ];

    /// <summary>What people did, by the alarms' keys. The first call reads the trail once; later ones read what is new.</summary>
    /// <exception cref="StoreException">The store cannot be read.</exception>
    public IReadOnlyDictionary<string, AlarmMark> Read()
    {
        var head = store.ChangeCount();
        if (head < _seen)
        {
            // A backup was restored.
            _marks.Clear();
            _seen = 0;
        }

        if (head > _seen)
        {
            var acts = store.SearchTrail(new() { What = [Acknowledged, Shelved, Unshelved], After = _seen, Most = int.MaxValue });
            foreach (var entry in acts.Reverse())
            {
                if (KeyOf(entry) is { } key) _marks[key] = After(entry, _marks.GetValueOrDefault(key, AlarmMark.None));
            }

            _seen = head;
            if (acts.Count > 0 || _read.Count != _marks.Count)
            {
                _read = new(_marks, StringComparer.Ordinal);
            }
        }

        return _read;
    }

    /// <summary>Records that somebody knows of an alarm. The caller must check the person's rights.</summary>
    /// <param name="alarm">The alarm.</param>
    /// <param name="by">The user's name.</param>
    public void Acknowledge(Alarm alarm, string by)
    {
        ArgumentNullException.ThrowIfNull(alarm);
        store.Audit(
            by,
            Acknowledged,
            alarm.Since is { } since ? RecordedAlarm.SinceUtc.With(since) : RecordedAlarm.SinceUnknown.With(),
            RecordedAlarm.Subject.With(alarm.Key));
    }

    /// <summary>Takes an alarm out of sight for a while. It returns by itself. The caller must check the person's rights.</summary>
    /// <param name="alarm">The alarm.</param>
    /// <param name="time">How long; more than zero, and at most <see cref="MostShelved"/>.</param>
    /// <param name="by">The user's name.</param>
    /// <exception cref="DecisionException">It must stay in sight.</exception>
    public void Shelve(Alarm alarm, TimeSpan time, string by)
    {
        ArgumentNullException.ThrowIfNull(alarm);
        ArgumentOutOfRangeException.ThrowIfLessThanOrEqual(time, TimeSpan.Zero);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(time, MostShelved);
        if (!alarm.MayBeShelved)
        {
            throw new DecisionException(
                DecisionException.StaysInSight,
                $"The alarm \"{alarm.Key}\" has high priority: it stays in sight until its cause is gone. Acknowledge it instead.");
        }

        store.Audit(by, Shelved, RecordedAlarm.UntilUtc.With(clock.GetUtcNow() + time), RecordedAlarm.Subject.With(alarm.Key));
    }

    /// <summary>Brings a shelved alarm back into sight. The caller must check the person's rights.</summary>
    /// <param name="alarm">The alarm.</param>
    /// <param name="by">The user's name.</param>
    public void Unshelve(Alarm alarm, string by)
    {
        ArgumentNullException.ThrowIfNull(alarm);
        store.Audit(by, Unshelved, "", RecordedAlarm.Subject.With(alarm.Key));
    }

    private static string? KeyOf(AuditEntry entry) =>
        entry.Subject is { } subject && subject.Is(RecordedAlarm.Subject) ? subject.Values[0].Words : null;

    // Of two people who acknowledge the same, the first one did.
    private static AlarmMark After(AuditEntry entry, AlarmMark before) => entry.What switch
    {
        Acknowledged when before.AcknowledgedBy is null || before.Since != TimeOf(entry.Basis, RecordedAlarm.SinceUtc) =>
            before with { Since = TimeOf(entry.Basis, RecordedAlarm.SinceUtc), AcknowledgedBy = entry.Who, AcknowledgedAt = entry.At },
        Shelved => before with { ShelvedBy = entry.Who, ShelvedUntil = TimeOf(entry.Basis, RecordedAlarm.UntilUtc) },
        Unshelved => before with { ShelvedBy = null, ShelvedUntil = null },
        _ => before,
    };

    private static DateTimeOffset? TimeOf(Statement basis, SentenceForm form) =>
        basis.Is(form) && DateTimeOffset.TryParseExact(
            basis.Values[0].Words, "O", CultureInfo.InvariantCulture, DateTimeStyles.None, out var time) ? time : null;
}

/// <summary>What people did about an alarm.</summary>
/// <param name="Since">Since when the acknowledged alarm lasted: if it ends and returns, it is to be acknowledged again. Null if that is
/// not known, or it was never acknowledged.</param>
/// <param name="AcknowledgedBy">Who acknowledged it; null if nobody did.</param>
/// <param name="AcknowledgedAt">When; null if nobody did.</param>
/// <param name="ShelvedBy">Who shelved it; null if nobody did, or it was brought back.</param>
/// <param name="ShelvedUntil">Until when; null if nobody did, or it was brought back.</param>
public sealed record AlarmMark(
    DateTimeOffset? Since, string? AcknowledgedBy, DateTimeOffset? AcknowledgedAt, string? ShelvedBy, DateTimeOffset? ShelvedUntil)
{
    /// <summary>No one did anything.</summary>
    public static AlarmMark None { get; } = new(null, null, null, null, null);

    /// <summary>True if somebody acknowledged this occurrence of the alarm.</summary>
    public bool IsAcknowledged(Alarm alarm) => AcknowledgedBy is not null && Since == alarm?.Since;

    /// <summary>True if the alarm is shelved now. One that must stay in sight is not, whatever was recorded while it mattered
    /// less.</summary>
    public bool IsShelved(Alarm alarm, DateTimeOffset now) => alarm is { MayBeShelved: true } && ShelvedUntil > now;
}
