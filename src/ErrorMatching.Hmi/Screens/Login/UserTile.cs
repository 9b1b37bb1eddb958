using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A user in the list of the login.</summary>
/// <param name="Name">The name.</param>
/// <param name="Role">What the user may do.</param>
/// <param name="RoleName">That in a word.</param>
public sealed record UserTile(string Name, Role Role, string RoleName)
{
    /// <summary>Identifies the tile.</summary>
    public string AutomationId => "login-user-" + Name;
}
