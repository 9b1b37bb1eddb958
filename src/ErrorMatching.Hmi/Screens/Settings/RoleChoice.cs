using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A role to choose. It stays the same in another language, so that what is chosen stays chosen.</summary>
/// <param name="role">The role.</param>
public sealed class RoleChoice(Role role) : Observable
{
    /// <summary>The role.</summary>
    public Role Role { get; } = role;

    /// <summary>Its name.</summary>
    public string Name => Texts.Current.Word(Role);

    /// <summary>Says that the language is another one.</summary>
    internal void Rename() => Say(nameof(Name));
}
