namespace ErrorMatching.Cell;

/// <summary>What a user may do. Each role may do what those before it may.</summary>
public enum Role
{
    /// <summary>Sees, releases and rejects.</summary>
    Operator,

    /// <summary>Approves, reverts and edits jobs.</summary>
    Setter,

    /// <summary>Manages users, machines and policy.</summary>
    Administrator,
}
