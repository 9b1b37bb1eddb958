using System.CommandLine;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary><c>errormatch user disable</c>.</summary>
internal sealed class UserDisable()
    : UserVerb(
        "disable",
        "Keeps a user from signing in. An administrator signs.",
        "errormatch user disable samples/cell/cell.json ben --user anna")
{
    protected override VerbResult Run(UserBook users, string name, ParseResult arguments) =>
        Answer(users.Disable(Sign(users, arguments), name), u => $"{u.Name} may not sign in any more.");
}
