using System.Globalization;
using System.Text.Json;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary>A correction after a decision.</summary>
internal sealed class CellDecisionAnswer(string verb, Correction correction, string sentence) : DocumentAnswer
{
    public override string Schema => $"errormatch/cell-{verb}/1";

    public override void WriteJson(Utf8JsonWriter json) => CorrectionJson.WriteMembers(json, correction);

    public override void WriteText(Page page) =>
        page.Line($"Correction {correction.Id.ToString(CultureInfo.InvariantCulture)} ({correction.FileName}) {sentence}.");
}
