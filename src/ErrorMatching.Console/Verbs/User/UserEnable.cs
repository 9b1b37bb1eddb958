using System.CommandLine;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary><c>errormatch user enable</c>.</summary>
internal sealed class UserEnable()
    : UserVerb(
        "enable",
        "Lets a user sign in again, and unlocks the name. An administrator signs.",
        "errormatch user enable samples/cell/cell.json ben --user anna")
{
    protected override VerbResult Run(UserBook users, string name, ParseResult arguments) =>
        Answer(users.Enable(Sign(users, arguments), name), u => $"{u.Name} may sign in.");
}
