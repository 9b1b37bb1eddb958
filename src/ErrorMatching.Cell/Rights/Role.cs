namespace ErrorMatching.Cell;

/// <summary>A user's role. Each role includes the rights of those before it.</summary>
public enum Role
{
    /// <summary>Sees, releases and rejects.</summary>
    Operator,

    /// <summary>Approves, reverts and edits jobs.</summary>
    Setter,

    /// <summary>Manages users, machines and policy.</summary>
    Administrator,
}
