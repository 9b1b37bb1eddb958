namespace ErrorMatching.Cell;

/// <summary>What came of looking at every entry of an audit trail.</summary>
/// <param name="Entries">How many entries there are.</param>
/// <param name="Hash">Hash of the last one. Written down elsewhere, it proves later that all up to here is as it was.</param>
/// <param name="Break">What is wrong; null if nothing is.</param>
/// <param name="Entry">Number of the first entry that it is wrong with; null if nothing is wrong.</param>
/// <param name="Message">What was found, in a sentence.</param>
/// <param name="IsSealChecked">False if the keys were not there: then a trail that was cut off or rewritten together with the row that says where it ends is not told from a whole one.</param>
public sealed record AuditFinding(long Entries, string Hash, AuditBreak? Break, long? Entry, string Message, bool IsSealChecked)
{
    /// <summary>True if nothing is wrong.</summary>
    public bool Holds => Break is null;
}
