using System.Globalization;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>
/// How far the audit trail went when it was last looked at, beside the keys and not in the store. A store that was set back to an earlier state as a whole, seal and all, is found by it.
/// </summary>
/// <param name="Seq">Number of the last entry.</param>
/// <param name="Hash">Its hash.</param>
internal sealed record AuditWitness(long Seq, string Hash)
{
    /// <summary>The file's name in the folder of the keys.</summary>
    public const string FileName = "audit.seen";

    /// <summary>What was seen last; null if nothing was.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysUnusable"/>.</exception>
    public static AuditWitness? Find(string keysFolder)
    {
        if (!File.Exists(Path.Combine(keysFolder, FileName)))
        {
            return null;
        }

        var words = Encoding.UTF8.GetString(new KeyFolder(keysFolder).Read(FileName)).TrimEnd('\n').Split(' ');
        return words is [var seq, { Length: 64 } hash] && long.TryParse(seq, NumberStyles.None, CultureInfo.InvariantCulture, out var number)
            ? new(number, hash)
            : throw new PeopleException(PeopleError.KeysUnusable, $"{Path.Combine(keysFolder, FileName)} is not what the cell wrote there: a number and a hash. Bring it back from a backup.");
    }

    /// <summary>Begins with nothing seen, for a key that is being made. One that is there stays.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysUnusable"/>.</exception>
    public static void Begin(string keysFolder) => new KeyFolder(keysFolder).Write(FileName, new AuditWitness(0, AuditEntry.NoHash).Bytes(), overwrite: false);

    /// <summary>Says that it is not there.</summary>
    public static string Missing(string keysFolder) =>
        $"{Path.Combine(keysFolder, FileName)} is not there: whether the store was set back to an earlier state cannot be said. Bring it back from a backup of the keys' folder, or, if you are sure of the store, begin it again: errormatch audit take-over.";

    /// <summary>What is wrong with a trail that is whole in itself.</summary>
    /// <param name="head">Where it ends.</param>
    /// <param name="seen">The entry that was the last then, or nothing.</param>
    public AuditFault? Fault(AuditHead head, IReadOnlyList<AuditEntry> seen) =>
        Seq == 0 ? null :
        head.Seq < Seq ? new(AuditFaultKind.Removed, head.Seq + 1, string.Create(
            CultureInfo.InvariantCulture, $"Entries {head.Seq + 1} to {Seq} are missing: the trail went that far when it was last looked at."))
        : seen is [var entry] && entry.Seq == Seq && entry.Hash == Hash ? null
        : new(AuditFaultKind.Changed, Seq, string.Create(CultureInfo.InvariantCulture, $"Entry {Seq}, or one before it with all that follow, is not what it was when the trail was last looked at."));

    /// <summary>Keeps it.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysUnusable"/>.</exception>
    public void Keep(string keysFolder) => new KeyFolder(keysFolder).Write(FileName, Bytes(), overwrite: true);

    private byte[] Bytes() => Encoding.UTF8.GetBytes(string.Create(CultureInfo.InvariantCulture, $"{Seq} {Hash}\n"));
}
