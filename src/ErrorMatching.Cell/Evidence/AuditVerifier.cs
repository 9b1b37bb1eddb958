using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>Looks at every entry of an audit trail: its own hash, the hash of the one before, its number, the end.</summary>
/// <param name="entries">The entries in the order of their numbers, from the start each time it is called. What cannot be read as an entry is null.</param>
/// <param name="head">Where the store says that the trail ends.</param>
/// <param name="key">The key that sealed the end; null if it is not there.</param>
/// <param name="witness">How far the trail went when it was last looked at; null if nobody did.</param>
internal sealed class AuditVerifier(Func<IEnumerable<(long Seq, AuditEntry? Entry)>> entries, AuditHead head, byte[]? key, AuditWitness? witness)
{
    /// <summary>The first thing that is wrong, or that nothing is.</summary>
    public AuditFinding Verify()
    {
        var (last, previous, count) = (0L, AuditEntry.NoHash, 0L);
        (long Seq, AuditEntry? Entry, long Last, string Previous)? broken = null;
        foreach (var (seq, entry) in entries())
        {
            count++;
            if (broken is null && !Follows(seq, entry, last, previous))
            {
                broken = (seq, entry, last, previous);
            }

            (last, previous) = (seq, entry?.Hash ?? previous);
        }

        var found = broken is { } at ? Named(at.Seq, at.Entry, at.Last) : End(last, previous);
        return (found ?? new(0, "", null, null, Sentence(count), key is not null)) with { Entries = count, Hash = previous };
    }

    private bool Follows(long seq, AuditEntry? entry, long last, string previous) =>
        seq == last + 1 && entry is not null && entry.Previous == previous && entry.HashAs(seq) == entry.Hash && (witness?.Seq != seq || witness.Hash == entry.Hash);

    // What is wrong with the first entry that does not follow: only now are the others looked at again.
    private AuditFinding Named(long seq, AuditEntry? entry, long last)
    {
        var expected = last + 1;
        if (seq < expected)
        {
            return Broken(AuditBreak.Inserted, seq, $"Entry {seq} was put in: the first entry is number 1.");
        }

        if (seq > expected)
        {
            return Elsewhere(expected) is { } place
                ? Broken(AuditBreak.Reordered, expected, $"Entry {expected} stands in the place of entry {place}.")
                : Broken(AuditBreak.Removed, expected, seq == expected + 1 ? $"Entry {expected} was removed." : $"Entries {expected} to {seq - 1} were removed.");
        }

        if (entry is null)
        {
            return Broken(AuditBreak.Changed, seq, $"Entry {seq} was changed: it cannot be read as an entry any more.");
        }

        if (entry.HashAs(seq) != entry.Hash)
        {
            return OwnHash(seq, entry);
        }

        return witness?.Seq == seq && witness.Hash != entry.Hash ? Witnessed(seq) : Link(seq, entry);
    }

    // The entry is not what its hash says. Under another number it may be: then it was moved.
    private AuditFinding OwnHash(long seq, AuditEntry entry)
    {
        if (NumberOf(entry) is not { } number)
        {
            return Broken(AuditBreak.Changed, seq, $"Entry {seq} was changed: its hash is not that of what it says.");
        }

        if (Elsewhere(seq) is { } place)
        {
            return Broken(AuditBreak.Reordered, seq, $"Entry {seq} stands in the place of entry {place}, and in its own stands entry {number}.");
        }

        return number > seq
            ? Broken(AuditBreak.Removed, seq, $"Entry {seq} was removed, and entry {number} moved to its place.")
            : Broken(AuditBreak.Inserted, number, $"Entry {number} was put in, and the one that was there moved to number {seq}.");
    }

    // The entry is what its hash says, and follows another one than the one that is before it.
    private AuditFinding Link(long seq, AuditEntry entry) => FollowedBy(entry) switch
    {
        { } before when before < seq => Broken(AuditBreak.Inserted, before + 1, $"Entry {before + 1} was put in: entry {seq} follows entry {before}."),
        _ when seq == 1 => Broken(AuditBreak.Changed, 1, "Entry 1 was changed and hashed again: it follows an entry, and is the first."),
        _ => Broken(AuditBreak.Changed, seq - 1, $"Entry {seq - 1} was changed and hashed again, or one between it and entry {seq} was removed: entry {seq} follows another one."),
    };

    private AuditFinding? End(long last, string hash)
    {
        if (witness is { } seen && seen.Seq > last)
        {
            return Broken(AuditBreak.Removed, last + 1, $"{Entries(last + 1, seen.Seq)} removed: the trail went to entry {seen.Seq} when it was last looked at. If an older backup was restored on purpose, this is its gap.");
        }

        if (head.Seq > last)
        {
            return Broken(AuditBreak.Removed, last + 1, $"{Entries(last + 1, head.Seq)} removed: the store says that the trail ends with entry {head.Seq}.");
        }

        if (head.Seq < last)
        {
            return Broken(AuditBreak.Inserted, head.Seq + 1, $"Entry {head.Seq + 1} was put in: the store says that the trail ends with entry {head.Seq}.");
        }

        if (head.Hash != hash)
        {
            return Broken(AuditBreak.Changed, last, $"Entry {last} was changed and hashed again, or one before it and all that follow: the store has another hash for the end.");
        }

        if (key is not null && !head.IsSealedBy(key))
        {
            return Broken(AuditBreak.Resealed, last, head.Seal is null
                ? $"The end at entry {last} has no seal: entries were removed or written without the keys of this cell."
                : $"The end at entry {last} was not sealed with the keys of this cell: entries were removed or rewritten by somebody without them, or the keys are not those that the trail began with.");
        }

        return null;
    }

    private AuditFinding Witnessed(long seq) =>
        Broken(AuditBreak.Changed, seq, $"Entry {seq} was changed and hashed again, or one before it and all that follow: it had another hash when the trail was last looked at.");

    private string Sentence(long count) =>
        (count == 1 ? "1 entry, and it is" : string.Create(CultureInfo.InvariantCulture, $"{count} entries, and all are")) + " as written." +
        (key is not null ? "" : " The keys are not here: whether the end was cut off, or everything rewritten, cannot be said.");

    private AuditFinding Broken(AuditBreak what, long entry, string message) => new(0, "", what, entry, message, key is not null);

    // The place where the entry of a number stands; null if it is nowhere.
    private long? Elsewhere(long number) => entries().Where(e => e.Seq != number && e.Entry is { } entry && entry.HashAs(number) == entry.Hash).Select(e => (long?)e.Seq).FirstOrDefault();

    // The number under which the entry has the hash that it has; null if there is none.
    private long? NumberOf(AuditEntry entry)
    {
        for (var number = 1L; number <= Math.Max(head.Seq, entry.Seq) + 1; number++)
        {
            if (entry.HashAs(number) == entry.Hash)
            {
                return number;
            }
        }

        return null;
    }

    // The number of the entry that this one says it follows; null if there is none.
    private long? FollowedBy(AuditEntry entry) =>
        entry.Previous == AuditEntry.NoHash ? 0 : entries().Where(e => e.Entry is { } other && other.Hash == entry.Previous).Select(e => (long?)e.Seq).FirstOrDefault();

    private static string Entries(long first, long last) => first == last ? string.Create(CultureInfo.InvariantCulture, $"Entry {first} was") : string.Create(CultureInfo.InvariantCulture, $"Entries {first} to {last} were");
}
