using System.Text.Json;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary>A run of a cell that ended on request.</summary>
internal sealed class CellRunAnswer(CellSettings settings, DateTimeOffset since, DateTimeOffset until) : DocumentAnswer
{
    public override string Schema => "errormatch/cell-run/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("cell", settings.Name);
        json.WriteString("since", CorrectionJson.Time(since));
        json.WriteString("until", CorrectionJson.Time(until));
    }

    public override void WriteText(Page page) =>
        page.Line($"{settings.Name} was told to stop, and stopped. Whatever it had begun is kept: the next run goes on with it.");
}
