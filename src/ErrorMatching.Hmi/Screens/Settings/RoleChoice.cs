using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A role to choose.</summary>
/// <param name="Role">The role.</param>
/// <param name="Name">Its name.</param>
public sealed record RoleChoice(Role Role, string Name);
