using System.Globalization;
using System.Text.Json;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary>The corrections that a search found.</summary>
internal sealed class CellHistoryAnswer(IReadOnlyList<Correction> corrections, long all) : DocumentAnswer
{
    public override string Schema => "errormatch/cell-history/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteNumber("found", all);
        json.WriteStartArray("corrections");
        foreach (var correction in corrections)
        {
            CorrectionJson.Write(json, correction);
        }

        json.WriteEndArray();
    }

    public override void WriteText(Page page)
    {
        if (corrections.Count == 0)
        {
            page.Line("Nothing found.");
            return;
        }

        page.Table(
            ["id", "arrived", "file", "job", "serial", "work order", "state", "largest mm", "why"],
            corrections.Select(c => (IReadOnlyList<string>)
            [
                c.Id.ToString(CultureInfo.InvariantCulture), c.ArrivedAt.ToString("yyyy-MM-dd HH:mm:ss'Z'", CultureInfo.InvariantCulture),
                c.FileName, c.Job ?? "", c.Serial ?? "", c.WorkOrder ?? "",
                CorrectionJson.Word(c.State), c.LargestMm is { } mm ? Show.Mm(mm) : "",
                c.Code is null ? c.Offset?.Sentence ?? "" : $"{c.Code}: {c.Reason}",
            ]));
        if (all > corrections.Count)
        {
            page.Line(string.Create(
                CultureInfo.InvariantCulture, $"The latest {corrections.Count} of {all}. Narrow the search, or list more with --most."));
        }
    }
}
