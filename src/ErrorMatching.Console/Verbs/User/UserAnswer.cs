using System.Globalization;
using System.Text.Json;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary>A user after a change.</summary>
internal sealed class UserAnswer(string schema, User user, string sentence) : DocumentAnswer
{
    public override string Schema => schema;

    public override void WriteJson(Utf8JsonWriter json) => WriteMembers(json, user);

    public override void WriteText(Page page) => page.Line(sentence);

    /// <summary>Writes a user's data to the current object.</summary>
    public static void WriteMembers(Utf8JsonWriter json, User user)
    {
        json.WriteString("name", user.Name);
        json.WriteString("role", user.RoleWord);
        json.WriteBoolean("isDisabled", user.IsDisabled);
        json.WriteString("addedAt", Time(user.AddedAt));
        json.WriteString("passwordAt", Time(user.PasswordAt));
        json.WriteBoolean("hasPin", user.HasPin);
        json.WriteBoolean("hasBadge", user.HasBadge);
        json.WriteNumber("failures", user.Failures);
        if (user.LockedUntil is { } until)
        {
            json.WriteString("lockedUntil", Time(until));
        }
        else
        {
            json.WriteNull("lockedUntil");
        }

        json.WritePropertyName("problem");
        if (user.Problem is var (error, message))
        {
            json.WriteStartObject();
            json.WriteString("code", CellCodes.Of(error));
            json.WriteString("message", message);
            json.WriteEndObject();
        }
        else
        {
            json.WriteNullValue();
        }
    }

    /// <summary>A time in UTC by RFC 3339, to the second.</summary>
    public static string Time(DateTimeOffset time) => time.UtcDateTime.ToString("yyyy-MM-dd'T'HH:mm:ss'Z'", CultureInfo.InvariantCulture);
}
