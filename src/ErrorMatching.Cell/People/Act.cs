namespace ErrorMatching.Cell;

/// <summary>What people do to a cell. Who may do which is said by <see cref="Rights"/>.</summary>
public enum Act
{
    /// <summary>Looking at corrections, reports and the history.</summary>
    See,

    /// <summary>Saying that a piece is cut, which frees its slot.</summary>
    Release,

    /// <summary>Deciding against a correction.</summary>
    Reject,

    /// <summary>Letting a correction go to its machine.</summary>
    Approve,

    /// <summary>Bringing back the program that a slot held before.</summary>
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
