namespace ErrorMatching.Cell;

/// <summary>What people do to a cell. <see cref="Rights"/> defines who may do it.</summary>
public enum Act
{
    /// <summary>Viewing corrections, reports and the history.</summary>
    See,

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
