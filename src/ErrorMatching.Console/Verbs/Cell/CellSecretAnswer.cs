using System.Text.Json;

namespace ErrorMatching.Console;

/// <summary>The result of setting or removing a machine's password.</summary>
internal sealed class CellSecretAnswer(string machine, bool isSet, bool isChanged) : DocumentAnswer
{
    public override string Schema => "errormatch/cell-secret/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("machine", machine);
        json.WriteBoolean("isSet", isSet);
        json.WriteBoolean("isChanged", isChanged);
    }

    public override void WriteText(Page page) => page.Line(
        isSet
            ? $"The cell signs in to {machine} with the new password from now on."
            : isChanged
            ? $"The password of {machine} is removed."
            : $"{machine} had no password.");
}
