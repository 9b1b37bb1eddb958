namespace ErrorMatching.Cell;

/// <summary>What the audit trail says of a user.</summary>
/// <param name="Name">The name.</param>
/// <param name="Role">The user's role.</param>
/// <param name="IsDisabled">True if the user may not sign in.</param>
/// <param name="Seq">Number of the entry that says so.</param>
internal sealed record RecordedPerson(string Name, Role Role, bool IsDisabled, long Seq)
{
    /// <summary>True if the user has the right.</summary>
    public bool May(Act act) => !IsDisabled && Rights.Allows(Role, act);
}
