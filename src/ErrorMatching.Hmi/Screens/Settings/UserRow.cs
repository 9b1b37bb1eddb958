using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A user in the list of users.</summary>
/// <param name="Name">The name.</param>
/// <param name="Role">What the user may do.</param>
/// <param name="RoleName">That in a word.</param>
/// <param name="IsDisabled">True if the user may not sign in.</param>
/// <param name="Standing">Disabled or locked, in words; empty for the ordinary course.</param>
public sealed record UserRow(string Name, Role Role, string RoleName, bool IsDisabled, string Standing)
{
    /// <summary>Identifies the row.</summary>
    public string AutomationId => "user-row-" + Name;
}
