using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A user in the list of users.</summary>
/// <param name="Name">The name.</param>
/// <param name="Role">The role.</param>
/// <param name="RoleName">The role in a word.</param>
/// <param name="IsDisabled">True if the user may not sign in.</param>
/// <param name="Standing">Disabled or locked, in words; empty if neither.</param>
internal sealed record UserRow(string Name, Role Role, string RoleName, bool IsDisabled, string Standing)
{
    public string AutomationId => "user-row-" + Name;
}
