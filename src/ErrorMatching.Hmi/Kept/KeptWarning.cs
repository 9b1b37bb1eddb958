using System.Text.Json;

namespace ErrorMatching.Hmi;

/// <summary>What the user should know before using a program.</summary>
/// <param name="Message">The report's English sentence.</param>
/// <param name="Code">Its stable code; null in reports older than warning codes.</param>
/// <param name="Values">The values of the code.</param>
public sealed record KeptWarning(string Message, string? Code, IReadOnlyList<string> Values)
{
    /// <summary>The warning in the display language if the station knows its code; otherwise the report's sentence.</summary>
    public string Text =>
        Code is not null && Texts.Current.Or("Warning." + Code, "") is { Length: > 0 }
            ? Texts.Current.With("Warning." + Code, [.. Values])
            : Message;

    public static IReadOnlyList<KeptWarning> Read(JsonElement report)
    {
        var codes = report.TryGetProperty("warningCodes", out var known) ? [.. known.EnumerateArray()] : Array.Empty<JsonElement>();
        return [.. report.GetProperty("warnings").EnumerateArray().Select((w, i) => i < codes.Length
            ? new KeptWarning(
                w.GetString()!,
                codes[i].GetProperty("code").GetString(),
                [.. codes[i].GetProperty("values").EnumerateArray().Select(v => v.GetString()!)])
            : new KeptWarning(w.GetString()!, null, []))];
    }
}
