using System.Globalization;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>The last seen end of the audit trail, stored next to the keys and not in the store. It reveals a store that was rolled back as
/// a whole, including its seal.</summary>
/// <param name="Seq">Number of the last entry.</param>
/// <param name="Hash">Its hash.</param>
internal sealed record AuditWitness(long Seq, string Hash)
{
    /// <summary>The file of <see cref="SecondWitness"/> that was written, too; null for none. From then on, it must be there.</summary>
    public string? Second { get; init; }

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

        return Read(new KeyFolder(keysFolder).Read(FileName), Path.Combine(keysFolder, FileName));
    }

    /// <summary>Reads what was remembered: a number and a hash, and in a second line the second file.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysUnusable"/>.</exception>
    public static AuditWitness Read(byte[] bytes, string file)
    {
        var lines = Encoding.UTF8.GetString(bytes).TrimEnd('\n').Split('\n', 2);
        return lines[0].Split(' ') is [var seq, { Length: 64 } hash]
            && long.TryParse(seq, NumberStyles.None, CultureInfo.InvariantCulture, out var number)
            ? new(number, hash) { Second = lines.Length > 1 ? lines[1] : null }
            : throw Unreadable(file);
    }

    /// <summary>The failure to read a file that has something else.</summary>
    public static PeopleException Unreadable(string file) => new(
        PeopleError.KeysUnusable, $"{file} is not what the cell wrote there: a number and a hash. Bring it back from a backup.");

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
    /// <param name="file">The file in which it is remembered.</param>
    public AuditFault? Fault(AuditHead head, IReadOnlyList<AuditEntry> seen, string file) =>
        Seq == 0 ? null :
        head.Seq < Seq ? new(AuditFaultKind.Removed, head.Seq + 1, string.Create(
            CultureInfo.InvariantCulture,
            $"Entries {head.Seq + 1} to {Seq} are missing: {file} says that the trail went to entry {Seq}, and the store ends with entry "
                + $"{head.Seq} of {head.At:yyyy-MM-dd HH:mm:ss} UTC. {WhatToDo}"))
        : seen is [var entry] && entry.Seq == Seq && entry.Hash == Hash ? null
        : new(
            AuditFaultKind.Changed,
            Seq,
            string.Create(
                CultureInfo.InvariantCulture,
                $"Entry {Seq}, or one before it with all that follow, is not what {file} says that it was. The store ends with entry "
                    + $"{head.Seq} of {head.At:yyyy-MM-dd HH:mm:ss} UTC. {WhatToDo}"));

    private const string WhatToDo =
        "The store was set back. If it was not you, bring the right store back. If a backup was brought back on purpose, whoever "
            + "administers the computer accepts it, on record: errormatch audit take-over CONFIG --reason WHY.";

    /// <summary>Saves it.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.KeysUnusable"/>.</exception>
    public void Keep(string keysFolder) => new KeyFolder(keysFolder).Write(FileName, Bytes(), overwrite: true);

    /// <summary>As it is stored.</summary>
    public byte[] Bytes() => Encoding.UTF8.GetBytes(string.Create(
        CultureInfo.InvariantCulture, $"{Seq} {Hash}\n{(Second is null ? "" : Second + "\n")}"));
}
