using System.Globalization;
using System.Text.Json;
using ErrorMatching.Cell;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary>All users of a cell.</summary>
internal sealed class UserListAnswer(IReadOnlyList<User> users) : DocumentAnswer
{
    public override string Schema => "errormatch/user-list/1";

    public override Failure? Failure => users.Any(u => u.Problem is not null)
        ? new(ExitCode.Refused, [.. users.Select(u => u.Problem).OfType<(PeopleError Error, string Message)>()
            .Select(p => new Refusal(CellCodes.Of(p.Error), p.Message))])
        : null;

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteStartArray("users");
        foreach (var user in users)
        {
            json.WriteStartObject();
            UserAnswer.WriteMembers(json, user);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    public override void WriteText(Page page)
    {
        if (users.Count == 0)
        {
            page.Line("This cell has no users yet.");
            return;
        }

        page.Table(
            ["name", "role", "added", "password of", "failed", ""],
            users.Select(u => (IReadOnlyList<string>)
            [
                u.Name, u.RoleWord, Day(u.AddedAt), Day(u.PasswordAt), u.Failures.ToString(CultureInfo.InvariantCulture),
                u.Problem is not null ? "may do nothing" : u.IsDisabled ? "disabled" : u.LockedUntil is { } until ? "locked until "
                    + UserAnswer.Time(until) : "",
            ]));
    }

    private static string Day(DateTimeOffset time) => time.UtcDateTime.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture);
}
