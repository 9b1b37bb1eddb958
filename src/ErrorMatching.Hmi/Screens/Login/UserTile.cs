using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A user in the login list.</summary>
/// <param name="Name">The name.</param>
/// <param name="Role">The role.</param>
/// <param name="RoleName">The role in a word.</param>
public sealed record UserTile(string Name, Role Role, string RoleName)
{
    public string AutomationId => "login-user-" + Name;
}
