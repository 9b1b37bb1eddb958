namespace ErrorMatching.Cell;

/// <summary>The table of roles and acts. Whatever it does not allow does not happen.</summary>
public static class Rights
{
    private static readonly Dictionary<Act, (Role Least, bool IsSigned)> Table = new()
    {
        [Act.See] = (Role.Operator, false),
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

    /// <summary>The lowest role that may do it. Every higher one may as well.</summary>
    public static Role LeastFor(Act act) => Table[act].Least;

    /// <summary>True if the role may do it.</summary>
    public static bool Allows(Role role, Act act) => role >= Table[act].Least;

    /// <summary>True if it takes a password given for this very act, however recently the user signed in.</summary>
    public static bool IsSigned(Act act) => Table[act].IsSigned;
}
