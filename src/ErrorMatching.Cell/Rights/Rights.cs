namespace ErrorMatching.Cell;

/// <summary>The table of roles and acts. Anything that it does not allow is refused.</summary>
public static class Rights
{
    private static readonly Dictionary<Act, (Role Least, bool IsSigned)> Table = new()
    {
        [Act.See] = (Role.Operator, false),
        [Act.Acknowledge] = (Role.Operator, false),
        [Act.Shelve] = (Role.Setter, false),
        [Act.Release] = (Role.Operator, false),
        [Act.Reject] = (Role.Operator, false),
        [Act.Approve] = (Role.Setter, true),
        [Act.Revert] = (Role.Setter, true),
        [Act.EditJobs] = (Role.Setter, true),
        [Act.PrepareJobs] = (Role.Setter, false),
        [Act.ManageUsers] = (Role.Administrator, true),
        [Act.ManageMachines] = (Role.Administrator, true),
        [Act.ManagePolicy] = (Role.Administrator, true),
    };

    /// <summary>The role's name in the audit trail and in messages.</summary>
    internal static string Word(Role role) => role.ToString().ToLowerInvariant();

    /// <summary>The role for a word of the audit trail or the store; null if the word is not a role.</summary>
    internal static Role? RoleOf(string word) =>
        Enum.GetValues<Role>().Where(r => r.ToString().Equals(word, StringComparison.OrdinalIgnoreCase)).Select(r => (Role?)r)
        .FirstOrDefault();

    /// <summary>The lowest role with this right. Every higher one has it too.</summary>
    public static Role LeastFor(Act act) => Table[act].Least;

    /// <summary>True if the role has the right.</summary>
    public static bool Allows(Role role, Act act) => role >= Table[act].Least;

    /// <summary>True if the act requires its own password entry, however recently the user signed in.</summary>
    public static bool IsSigned(Act act) => Table[act].IsSigned;
}

/// <summary>A user's role. Each role includes the rights of those before it.</summary>
public enum Role
{
    /// <summary>Sees, acknowledges, releases and rejects.</summary>
    Operator,

    /// <summary>Approves, reverts, edits jobs and shelves alarms.</summary>
    Setter,

    /// <summary>Manages users, machines and policy.</summary>
    Administrator,
}

/// <summary>What people do to a cell. <see cref="Rights"/> defines who may do it.</summary>
public enum Act
{
    /// <summary>Viewing corrections, reports and the history.</summary>
    See,

    /// <summary>Acknowledging an alarm.</summary>
    Acknowledge,

    /// <summary>Taking an alarm out of sight for a while, and bringing it back.</summary>
    Shelve,

    /// <summary>Reporting that a piece is cut, which frees its slot.</summary>
    Release,

    /// <summary>Rejecting a correction.</summary>
    Reject,

    /// <summary>Approving a correction for its machine.</summary>
    Approve,

    /// <summary>Restoring the program that a slot held before.</summary>
    Revert,

    /// <summary>Changing jobs that are in use, and putting others in their place.</summary>
    EditJobs,

    /// <summary>Saving jobs that are not in use.</summary>
    PrepareJobs,

    /// <summary>Adding users, changing their roles and passwords, disabling them.</summary>
    ManageUsers,

    /// <summary>Changing machines and setting their passwords.</summary>
    ManageMachines,

    /// <summary>Changing who approves what, and the limits.</summary>
    ManagePolicy,
}
