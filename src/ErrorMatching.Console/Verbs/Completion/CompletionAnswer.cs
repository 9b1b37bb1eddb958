using System.Text.Json;

namespace ErrorMatching.Console;

/// <summary>The script of a shell.</summary>
internal sealed class CompletionAnswer(string shell) : DocumentAnswer
{
    public override string Schema => "errormatch/completion/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("shell", shell);
        json.WriteString("script", CompletionScript.Of(shell));
    }

    public override void WriteText(Page page) => page.Text(CompletionScript.Of(shell));
}
