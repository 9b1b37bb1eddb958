using System.CommandLine;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary><c>errormatch user list</c>.</summary>
internal sealed class UserList() : CellVerb("list", "Lists the users and what they may do.", "errormatch user list samples/cell/cell.json")
{
    protected override VerbResult Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation) =>
        WithExistingStore(settings, store => new UserListAnswer(new UserBook(store, TimeProvider.System).List()));
}
