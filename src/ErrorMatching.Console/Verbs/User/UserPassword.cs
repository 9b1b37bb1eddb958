using System.CommandLine;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary><c>errormatch user password</c>.</summary>
internal sealed class UserPassword() : UserVerb(
    "password",
    "Sets a password: one's own, or as an administrator anybody's.",
    "errormatch user password samples/cell/cell.json anna --user anna",
    "the password of who signs, then the new one")
{
    protected override VerbResult Run(UserBook users, string name, ParseResult arguments)
    {
        var by = Sign(users, arguments);
        return Answer(users.SetPassword(by, name, AskNew($"new password of {name}", arguments)), u => $"{u.Name} has a new password.");
    }
}
