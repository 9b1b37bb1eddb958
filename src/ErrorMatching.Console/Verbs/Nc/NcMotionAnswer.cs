using System.Text.Json;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary>The motions of a program.</summary>
internal sealed class NcMotionAnswer(string file, NcPath path) : DocumentAnswer
{
    /// <inheritdoc/>
    public override string Schema => "errormatch/nc-motion/1";

    /// <inheritdoc/>
    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("file", file);
        json.WriteString("dialect", path.Dialect.Name);
        json.WriteStartArray("motions");
        for (var i = 0; i < path.Motions.Length; i++)
        {
            json.WriteStartObject();
            new ShownMotion(path, i).Write(json);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        ShownNotes.Write(json, (file, path));
    }

    /// <inheritdoc/>
    public override void WriteText(Page page)
    {
        page.Line(string.Join(',', ShownMotion.Fields));
        for (var i = 0; i < path.Motions.Length; i++)
        {
            page.Line(string.Join(',', new ShownMotion(path, i).Cells()));
        }
    }
}
