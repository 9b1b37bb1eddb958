using System.Text.Json;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary>The motions of a program.</summary>
internal sealed class NcMotionAnswer(string file, NcPath path) : DocumentAnswer
{
    public override string Schema => "errormatch/nc-motion/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("file", file);
        json.WriteString("dialect", path.Dialect.Name);
        var words = new CoordinateWords(path);
        json.WriteStartArray("motions");
        for (var i = 0; i < path.Motions.Length; i++)
        {
            json.WriteStartObject();
            new ShownMotion(path, i).Write(json);
            WriteWords(json, words, i);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        ShownNotes.Write(json, (file, path));
    }

    // The word and line for each coordinate of the end point.
    private static void WriteWords(Utf8JsonWriter json, CoordinateWords words, int motion)
    {
        json.WriteStartObject("words");
        foreach (var (axis, name) in new[] { ('X', "x"), ('Y', "y"), ('Z', "z") })
        {
            if (words.Behind(motion, axis) is { } word)
            {
                json.WriteStartObject(name);
                json.WriteNumber("line", word.Block + 1);
                json.WriteString("word", word.Text);
                json.WriteEndObject();
            }
        }

        json.WriteEndObject();
    }

    public override void WriteText(Page page)
    {
        page.Line(string.Join(',', ShownMotion.Fields));
        new MotionLines(path).WriteTo(page);
    }
}
