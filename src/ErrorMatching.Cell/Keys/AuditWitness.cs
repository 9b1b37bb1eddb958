using System.Globalization;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>The last seen end of the audit trail, stored next to the keys and not in the store. It reveals a store that was rolled back as
/// a whole, including its seal.</summary>
/// <param name="Seq">Number of the last entry.</param>
/// <param name="Hash">Its hash.</param>
internal sealed record AuditWitness(long Seq, string Hash)
{
    /// <summary>The file's name in the key folder.</summary>
    public const string FileName = "audit.seen";

    /// <summary>The last seen end; null if there is none.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysUnusable"/>.</exception>
    public static AuditWitness? Find(string keysFolder)
    {
        if (!File.Exists(Path.Combine(keysFolder, FileName)))
        {
            return null;
        }

        var words = Encoding.UTF8.GetString(new KeyFolder(keysFolder).Read(FileName)).TrimEnd('\n').Split(' ');
        return words is [var seq, { Length: 64 } hash]
            && long.TryParse(seq, NumberStyles.None, CultureInfo.InvariantCulture, out var number)
            ? new(number, hash)
            : throw new PeopleException(
                PeopleError.KeysUnusable,
                $"{Path.Combine(keysFolder, FileName)} is not what the cell wrote there: a number and a hash. Bring it back from a "
                    + $"backup.");
    }

    /// <summary>Starts an empty record for a key that is being created. An existing record is kept.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysUnusable"/>.</exception>
    public static void Begin(string keysFolder) =>
        new KeyFolder(keysFolder).Write(FileName, new AuditWitness(0, AuditEntry.NoHash).Bytes(), overwrite: false);

    /// <summary>The message that the record is missing.</summary>
    public static string Missing(string keysFolder) =>
        $"{Path.Combine(keysFolder, FileName)} is not there: whether the store was set back to an earlier state cannot be said. Bring it "
            + $"back from a backup of the keys' folder, or, if you are sure of the store, begin it again: errormatch audit take-over.";

    /// <summary>The fault of a trail that is intact in itself; null if there is none.</summary>
    /// <param name="head">The end of the trail.</param>
    /// <param name="seen">The entry with the remembered number, or none.</param>
    public AuditFault? Fault(AuditHead head, IReadOnlyList<AuditEntry> seen) =>
        Seq == 0 ? null :
        head.Seq < Seq ? new(AuditFaultKind.Removed, head.Seq + 1, string.Create(
            CultureInfo.InvariantCulture,
            $"Entries {head.Seq + 1} to {Seq} are missing: the trail went that far when it was last looked at."))
        : seen is [var entry] && entry.Seq == Seq && entry.Hash == Hash ? null
        : new(
            AuditFaultKind.Changed,
            Seq,
            string.Create(
                CultureInfo.InvariantCulture,
                $"Entry {Seq}, or one before it with all that follow, is not what it was when the trail was last looked at."));

    /// <summary>Saves it.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysUnusable"/>.</exception>
    public void Keep(string keysFolder) => new KeyFolder(keysFolder).Write(FileName, Bytes(), overwrite: true);

    private byte[] Bytes() => Encoding.UTF8.GetBytes(string.Create(CultureInfo.InvariantCulture, $"{Seq} {Hash}\n"));
}
