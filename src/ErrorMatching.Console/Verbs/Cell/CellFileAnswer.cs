using System.Text.Json;

namespace ErrorMatching.Console;

/// <summary>A file that a verb for the store wrote or read.</summary>
internal sealed class CellFileAnswer(string verb, string file, string sentence) : DocumentAnswer
{
    public override string Schema => $"errormatch/cell-{verb}/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("file", file);
        json.WriteNumber("bytes", new FileInfo(file).Length);
    }

    public override void WriteText(Page page) => page.Line(sentence);
}
