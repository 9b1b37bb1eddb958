using System.Globalization;
using System.Text.Json;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary>A user as a verb left it.</summary>
internal sealed class UserAnswer(string schema, User user, string sentence) : DocumentAnswer
{
    /// <inheritdoc/>
    public override string Schema => schema;

    /// <inheritdoc/>
    public override void WriteJson(Utf8JsonWriter json) => WriteMembers(json, user);

    /// <inheritdoc/>
    public override void WriteText(Page page) => page.Line(sentence);

    /// <summary>Writes what is known of a user into the object that is open.</summary>
    public static void WriteMembers(Utf8JsonWriter json, User user)
    {
        json.WriteString("name", user.Name);
        json.WriteString("role", user.RoleWord);
        json.WriteBoolean("isDisabled", user.IsDisabled);
        json.WriteString("addedAt", Time(user.AddedAt));
        json.WriteString("passwordAt", Time(user.PasswordAt));
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
            json.WriteString("code", FailureOfCell.CodeOf(error));
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
