using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>The result of checking every entry of an audit trail.</summary>
/// <param name="Entries">The number of entries.</param>
/// <param name="Hash">Hash of the last entry. A copy kept elsewhere proves later that everything up to here is unchanged.</param>
/// <param name="Fault">The first fault; null if there is none.</param>
/// <param name="IsSealChecked">False if the keys were missing, which is a fault.</param>
public sealed record AuditFinding(long Entries, string Hash, AuditFault? Fault, bool IsSealChecked)
{
    /// <summary>Number of contents in the store whose bytes have their hash.</summary>
    public long Contents { get; init; }

    /// <summary>Length of these contents, uncompressed.</summary>
    public long ContentBytes { get; init; }

    /// <summary>Number of pages that are drawn from their reports, and are checked whenever they are drawn.</summary>
    public long Pages { get; init; }

    /// <summary>The archives that the store refers to. Those that are there were checked, content by content; nothing is known of the
    /// others.</summary>
    public IReadOnlyList<ArchiveFinding> Archives { get; init; } = [];

    /// <summary>True if there is no fault.</summary>
    public bool Holds => Fault is null;

    /// <summary>The result, in a sentence or two.</summary>
    public string Message => Fault is not null ? Fault.Message : Trail + (Archives.Where(a => !a.IsThere).ToArray() is { Length: > 0 } away
        ? string.Create(
            CultureInfo.InvariantCulture,
            $" {away.Sum(a => a.Contents)} contents are in archives that are not here, and were not looked at: "
                + $"{string.Join(", ", away.Select(a => a.Name))}.")
        : "");

    private string Trail => Entries == 1
        ? "1 entry, and it is as it was written."
        : string.Create(CultureInfo.InvariantCulture, $"{Entries} entries, and all are as they were written.");
}
