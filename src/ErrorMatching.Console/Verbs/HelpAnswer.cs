using System.Globalization;
using System.Text.Json;

namespace ErrorMatching.Console;

/// <summary>The help of a command.</summary>
/// <param name="words">The command's words.</param>
internal sealed class HelpAnswer(IReadOnlyList<string> words) : DocumentAnswer
{
    public override string Schema => "errormatch/help/1";

    public override void WriteJson(Utf8JsonWriter json) => json.WriteString("help", Text());

    public override void WriteText(Page page) => page.Text(Text());

    private string Text()
    {
        using var text = new StringWriter(CultureInfo.InvariantCulture) { NewLine = "\n" };
        CommandTree.WriteHelp(words, text);
        return text.ToString();
    }
}
