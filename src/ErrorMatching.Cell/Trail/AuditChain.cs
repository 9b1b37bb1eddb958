using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>Verifies an audit trail: every entry is as written and in its place, and none is missing.</summary>
internal static class AuditChain
{
    private const long MostMissing = 1_000_000;

    /// <summary>Verifies a whole trail.</summary>
    /// <param name="entries">All its entries in stored order; enumerated a second time if something is wrong.</param>
    /// <param name="head">The end of the trail.</param>
    /// <param name="key">The key that seals the end; null for none. Without a key, anyone who can write to the store can rewrite the whole
    /// trail.</param>
    /// <param name="each">Called with each entry that is as written and in its place, in order, while a second core reads ahead; null for
    /// nothing.</param>
    /// <returns>The first fault; null if there is none.</returns>
    public static AuditFault? Verify(IEnumerable<AuditEntry> entries, AuditHead head, byte[]? key, Action<AuditEntry>? each = null)
    {
        ArgumentNullException.ThrowIfNull(entries);
        ArgumentNullException.ThrowIfNull(head);
        var (seq, hash, ends) = Walk(entries, each);
        if (!ends) return Explain([.. entries], (int)seq, hash, head.Seq);
        if (head.Seq > seq) return Fault(AuditFaultKind.Removed, seq + 1, $"Entries {seq + 1} to {head.Seq} are missing at the end.");
        if (head.Seq < seq)
            return Fault(AuditFaultKind.Inserted, head.Seq + 1, $"Entry {head.Seq + 1} stands after the last that was written.");
        if (head.Hash != hash) return Fault(AuditFaultKind.Changed, seq, $"Entry {seq} is not the one that was written last.");
        return key is not null && !head.IsSealedBy(key)
            ? Fault(
                AuditFaultKind.Unsealed,
                seq,
                $"The end, entry {seq}, is not sealed by the cell's key: something else wrote to the trail, or the key has changed.")
            : null;
    }

    // The last correct entry, and whether the trail ends there.
    private static (long Seq, string Hash, bool Ends) Walk(IEnumerable<AuditEntry> entries, Action<AuditEntry>? each)
    {
        var (seq, hash) = (0L, AuditEntry.NoHash);
        foreach (var (entry, isAsWritten) in ReadAhead.Of(entries.Select(Looked)))
        {
            if (entry.Seq != seq + 1 || entry.Previous != hash || !isAsWritten) return (seq, hash, false);
            (seq, hash) = (entry.Seq, entry.Hash);
            each?.Invoke(entry);
        }

        return (seq, hash, true);
    }

    /// <summary>Whether an entry is as written; reads what it is about, too, so that a second core does both.</summary>
    public static (AuditEntry Entry, bool IsAsWritten) Looked(AuditEntry entry)
    {
        _ = entry.Subject?.Code;
        return (entry, entry.IsWrittenAs(entry.Seq));
    }

    // Everything before "at" is linked correctly; the entry at "at" is not the next one.
    private static AuditFault Explain(List<AuditEntry> entries, int at, string hash, long last)
    {
        var (entry, expected) = (entries[at], at + 1L);
        var written = WrittenAs(entry, entries.Count, last);
        var next = entries.FindIndex(at, e => e.Previous == hash && e.IsWrittenAs(expected));
        if (next > at)
        {
            return written > expected
                ? Fault(AuditFaultKind.Reordered, expected, $"Entry {written} stands where entry {expected} should, which comes later.")
                : Fault(
                    AuditFaultKind.Inserted,
                    expected,
                    $"The entry that stands as number {expected} was not written there; the one that was comes later.");
        }

        // Only its number was changed.
        if (next == at || written is null) return Changed(expected);
        if (written > expected) return Fault(AuditFaultKind.Removed, expected, $"Entries {expected} to {written - 1} are missing.");
        if (written == expected) return Changed(at > 0 ? expected - 1 : expected);

        // It has the same predecessor as the entry before it, so that one was inserted.
        return at > 0 && written == expected - 1 && entry.Previous == entries[at - 1].Previous && entry.Hash != entries[at - 1].Hash
            ? Fault(
                AuditFaultKind.Inserted,
                expected - 1,
                $"The entry that stands as number {expected - 1} was not written there; the one that was comes after it.")
            : Fault(AuditFaultKind.Inserted, expected, $"Entry {written} stands a second time, as number {expected}.");
    }

    private static AuditFault Changed(long seq) => Fault(AuditFaultKind.Changed, seq, $"Entry {seq} is not what was written.");

    // The number that an entry was written with: its own, or another for which its hash is correct; null if none.
    private static long? WrittenAs(AuditEntry entry, int count, long last)
    {
        if (entry.IsWrittenAs(entry.Seq)) return entry.Seq;
        var most = Math.Clamp(last, count, count + MostMissing);
        for (var seq = 1L; seq <= most; seq++)
        {
            if (entry.IsWrittenAs(seq)) return seq;
        }

        return null;
    }

    private static AuditFault Fault(AuditFaultKind kind, long seq, FormattableString message) =>
        new(kind, seq, message.ToString(CultureInfo.InvariantCulture));
}
