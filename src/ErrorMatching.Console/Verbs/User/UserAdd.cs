using System.CommandLine;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary><c>errormatch user add</c>.</summary>
internal sealed class UserAdd : UserVerb
{
    private readonly RoleOption _role = new();

    public UserAdd()
        : base(
            "add",
            "Adds a user. An administrator signs; the first user is an administrator and needs nobody's signature.",
            "errormatch user add samples/cell/cell.json anna --role administrator",
            "the password of who signs (not for the first user), then the new user's") => Options.Add(_role);

    protected override bool MayBeFirst => true;

    protected override VerbResult Run(UserBook users, string name, ParseResult arguments)
    {
        var role = _role.Of(arguments);
        if (!users.IsEmpty)
        {
            var by = Sign(users, arguments);
            return Answer(
                users.Add(by, name, role, AskNew($"new password of {name}", arguments)),
                u => $"{u.Name} is a user now, as {RoleOption.Word(u.Role)}.");
        }

        return role == Role.Administrator
            ? Answer(
                users.AddFirst(name, AskNew($"new password of {name}", arguments)),
                u => $"{u.Name} is the first administrator. Add a second one soon: a lost password is set by another administrator.")
            : throw new PeopleException(
                PeopleError.NoUsers, $"The first user of a cell is an administrator: name --role {RoleOption.Word(Role.Administrator)}.");
    }
}
