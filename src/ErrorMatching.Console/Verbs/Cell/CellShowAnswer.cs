using System.Globalization;
using System.Text.Json;
using ErrorMatching.Cell;
using ErrorMatching.Jobs;

namespace ErrorMatching.Console;

/// <summary>The history of one file.</summary>
internal sealed class CellShowAnswer(
    Correction correction, IReadOnlyList<CorrectionStep> steps, IReadOnlyList<string> files, IReadOnlyList<string> notices)
    : DocumentAnswer
{
    public override string Schema => "errormatch/cell-correction/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        CorrectionJson.WriteMembers(json, correction);
        json.WriteStartArray("steps");
        foreach (var step in steps)
        {
            json.WriteStartObject();
            json.WriteString("from", step.From is { } from ? CorrectionJson.Word(from) : null);
            json.WriteString("to", CorrectionJson.Word(step.To));
            json.WriteString("at", CorrectionJson.Time(step.At));
            json.WriteString("by", step.By);
            json.WriteString("basis", step.Basis.Sentence);
            CorrectionJson.Write(json, "basisStatement", step.Basis);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteStartArray("files");
        foreach (var file in files)
        {
            json.WriteStringValue(file);
        }

        json.WriteEndArray();
        if (notices.Count > 0)
        {
            json.WriteStartArray("notices");
            foreach (var notice in notices)
            {
                json.WriteStringValue(notice);
            }

            json.WriteEndArray();
        }
    }

    public override void WriteText(Page page)
    {
        page.Heading(PrintedText.OneLine(
            $"Correction {correction.Id.ToString(CultureInfo.InvariantCulture)}: {correction.FileName} from {correction.Gauge} is "
                + $"{CorrectionJson.Word(correction.State)}"));
        if (correction.Code is { } code)
        {
            page.Line(PrintedText.OneLine($"{code}: {correction.Reason}"));
        }

        page.Line();
        page.Facts([.. Facts()]);
        page.Line();
        page.Table(
            ["at", "state", "by", "basis"],
            steps.Select(s => (IReadOnlyList<string>)[CorrectionJson.Time(s.At), CorrectionJson.Word(s.To), s.By, s.Basis.Sentence]));
        if (files.Count > 0)
        {
            page.Line();
            page.Line("Written: " + string.Join(", ", files));
            foreach (var notice in notices)
            {
                page.Line(PrintedText.OneLine(notice));
            }
        }
    }

    private IEnumerable<(string Name, string Value)> Facts() => new (string Name, string? Value)[]
    {
        ("job", correction.Job),
        ("piece", correction.Piece),
        ("serial", correction.Serial),
        ("work order", correction.WorkOrder),
        ("slot", correction.Machine is null ? null : $"{correction.Machine}/{correction.Slot}"),
        ("program", correction.Program),
        ("offset", correction.Offset?.Sentence),
        ("largest displacement", correction.LargestMm is { } mm ? Show.Mm(mm) + " mm" : null),
        ("sum since the original", correction.SumMm is { } sum ? Show.Mm(sum) + " mm" : null),
        ("measurement SHA-256", correction.MeasurementSha256),
        ("program SHA-256", correction.ProgramSha256),
        ("found in the slot", correction.PreviousSha256),
    }.Where(f => f.Value is not null).Select(f => (f.Name, f.Value!));
}
