using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>A role to choose. The object stays the same in another language, so that it stays selected.</summary>
/// <param name="role">The role.</param>
internal sealed class RoleChoice(Role role) : Observable
{
    public Role Role { get; } = role;

    public string Name => Texts.Current.Word(Role);

    /// <summary>Updates the name after a change of language.</summary>
    internal void Rename() => OnPropertyChanged(nameof(Name));
}
