using System.Globalization;
using System.Text.Json;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary>The motions of the tool's center under cutter compensation.</summary>
internal sealed class NcCenterAnswer(string file, CompensatedPath center) : DocumentAnswer
{
    public override string Schema => "errormatch/nc-motion/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("file", file);
        json.WriteString("dialect", center.Path.Dialect.Name);
        json.WriteBoolean("compensated", true);
        json.WriteStartArray("motions");
        for (var i = 0; i < center.Motions.Count; i++)
        {
            json.WriteStartObject();
            new ShownMotion(center, i).Write(json);
            json.WriteNumber("programmed", center.Motions[i].Motion);
            json.WriteBoolean("inserted", center.Motions[i].IsInserted);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        ShownNotes.Write(json, (file, center.Path));
    }

    public override void WriteText(Page page)
    {
        page.Line(string.Join(',', ShownMotion.Fields) + ",programmed,inserted");
        for (var i = 0; i < center.Motions.Count; i++)
        {
            var motion = center.Motions[i];
            page.Line(string.Create(
                CultureInfo.InvariantCulture,
                $"{string.Join(',', new ShownMotion(center, i).Cells())},{motion.Motion},{(motion.IsInserted ? 1 : 0)}"));
        }
    }
}
