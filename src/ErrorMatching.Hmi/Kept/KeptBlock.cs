using System.Text.Json;

namespace ErrorMatching.Hmi;

/// <summary>A changed block in a stored report. Texts have one character per byte.</summary>
/// <param name="Line">Its line in the original program, from 1.</param>
/// <param name="Original">Its text in the original program; empty for an inserted block.</param>
/// <param name="OriginalSpans">Replaced spans: start and length.</param>
/// <param name="ModifiedSpans">New spans: start and length.</param>
public sealed record KeptBlock(
    int Line, string Original, IReadOnlyList<(int Start, int Length)> OriginalSpans, IReadOnlyList<(int Start, int Length)> ModifiedSpans)
{
    internal static KeptBlock Read(JsonElement json) => new(
        json.GetProperty("line").GetInt32(),
        json.GetProperty("original").GetString()!,
        Spans(json, "originalSpans"),
        Spans(json, "modifiedSpans"));

    private static (int Start, int Length)[] Spans(JsonElement json, string name) =>
        [.. json.GetProperty(name).EnumerateArray().Select(s => (s.GetProperty("start").GetInt32(), s.GetProperty("length").GetInt32()))];
}
