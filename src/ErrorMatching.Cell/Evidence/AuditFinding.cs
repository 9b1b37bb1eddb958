using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>What came of looking at every entry of an audit trail.</summary>
/// <param name="Entries">How many entries there are.</param>
/// <param name="Hash">Hash of the last one. Written down elsewhere, it proves later that all up to here is as it was.</param>
/// <param name="Fault">The first thing that is wrong; null if nothing is.</param>
/// <param name="IsSealChecked">False if the keys were not there, which is a fault.</param>
public sealed record AuditFinding(long Entries, string Hash, AuditFault? Fault, bool IsSealChecked)
{
    /// <summary>True if nothing is wrong.</summary>
    public bool Holds => Fault is null;

    /// <summary>What was found, in a sentence or two.</summary>
    public string Message => Fault is not null ? Fault.Message
        : Entries == 1 ? "1 entry, and it is as it was written."
        : string.Create(CultureInfo.InvariantCulture, $"{Entries} entries, and all are as they were written.");
}
