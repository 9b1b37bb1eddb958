using System.Globalization;
using System.Text.Json;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary>How much of a store was moved to archives, or would be.</summary>
internal sealed class CellThinAnswer(ThinPolicy policy, Thinned thinned, bool isRehearsed, string? folder) : DocumentAnswer
{
    public override string Schema => "errormatch/cell-thin/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteBoolean("dryRun", isRehearsed);
        json.WriteString("before", CorrectionJson.Time(policy.Before));
        json.WriteNumber("keepLast", policy.KeepLast);
        json.WriteNumber("contents", thinned.Contents);
        json.WriteNumber("bytes", thinned.Bytes);
        json.WriteString("folder", folder);
        json.WriteStartArray("archives");
        foreach (var name in thinned.Archives)
        {
            json.WriteStringValue(name);
        }

        json.WriteEndArray();
    }

    public override void WriteText(Page page)
    {
        var date = policy.Before.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture);
        page.Line(string.Create(
            CultureInfo.InvariantCulture,
            $"{thinned.Contents} contents with {thinned.Bytes} bytes of corrections from before {date}, without the last {policy.KeepLast} "
                + $"of each slot, {(isRehearsed ? "would be moved" : "were moved")} to "
                + $"{folder ?? "a folder that the configuration must name"}."));
        foreach (var name in thinned.Archives)
        {
            page.Line(name);
        }

        if (thinned.Archives.Count > 0)
        {
            page.Line("Back the archives up with the store and the keys.");
        }
    }
}
