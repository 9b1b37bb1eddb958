using System.Globalization;
using System.Text.Json;
using ErrorMatching.Nc;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>The blocks that selectors name.</summary>
internal sealed class NcLocateAnswer(string file, NcPath path, IReadOnlyList<int> blocks) : DocumentAnswer
{
    public override string Schema => "errormatch/nc-locate/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("file", file);
        json.WriteString("dialect", path.Dialect.Name);
        json.WriteStartArray("blocks");
        foreach (var index in blocks)
        {
            var block = path.Program[index];
            json.WriteStartObject();
            json.WriteNumber("line", block.Line);
            json.WriteString("block", path.Program.NumberOf(block));
            json.WriteString("text", path.Program.TextOf(block));
            json.WriteStartArray("motions");
            foreach (var i in path.MotionsOf(index))
            {
                json.WriteNumberValue(i);
            }

            json.WriteEndArray();
            if (MotionOf(index) is { } motion)
            {
                json.WriteStartObject("motion");
                motion.Write(json);
                json.WriteEndObject();
            }
            else
            {
                json.WriteNull("motion");
            }

            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    public override void WriteText(Page page)
    {
        page.Heading(string.Create(CultureInfo.InvariantCulture, $"{ReportNumber.Count(blocks.Count, "block")} of {file}"));
        page.Line();
        page.Table(
            ["line", "block", "text", "motion", "x", "y", "z"],
            blocks.Select(b => (path.Program[b], MotionOf(b))).Select(b => (IReadOnlyList<string>)
            [
                b.Item1.Line.ToString(CultureInfo.InvariantCulture), path.Program.NumberOf(b.Item1), path.Program.TextOf(b.Item1),
                Runs(b.Item1.Index) + (b.Item2?.Kind ?? "none"), ShownMotion.Text(b.Item2?.End.X), ShownMotion.Text(b.Item2?.End.Y),
                ShownMotion.Text(b.Item2?.End.Z),
            ]));
    }

    private string Runs(int block) =>
        path.MotionsOf(block).Length is > 1 and var runs ? string.Create(CultureInfo.InvariantCulture, $"{runs} x ") : "";

    private ShownMotion? MotionOf(int block) => path.MotionOf(block) is >= 0 and var motion ? new(path, motion) : null;
}
