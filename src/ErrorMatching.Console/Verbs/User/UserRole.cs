using System.CommandLine;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary><c>errormatch user role</c>.</summary>
internal sealed class UserRole : UserVerb
{
    private readonly RoleOption _role = new();

    public UserRole()
        : base(
            "role",
            "Gives a user another role. An administrator signs.",
            "errormatch user role samples/cell/cell.json ben --role setter --user anna") =>
            Options.Add(_role);

    protected override VerbResult Run(UserBook users, string name, ParseResult arguments) =>
        Answer(users.SetRole(Sign(users, arguments), name, _role.Of(arguments)), u => $"{u.Name} is {RoleOption.Word(u.Role)} now.");
}
