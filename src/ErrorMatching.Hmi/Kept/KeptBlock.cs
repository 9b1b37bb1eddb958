using System.Text.Json;

namespace ErrorMatching.Hmi;

/// <summary>A block that differs, in a kept report. Texts have one character a byte.</summary>
/// <param name="Line">Its line in the original program, from 1.</param>
/// <param name="Original">Its text in the original program; empty for an inserted one.</param>
/// <param name="OriginalSpans">What was replaced: start and length.</param>
/// <param name="ModifiedSpans">What stands there now: start and length.</param>
public sealed record KeptBlock(int Line, string Original, IReadOnlyList<(int Start, int Length)> OriginalSpans, IReadOnlyList<(int Start, int Length)> ModifiedSpans)
{
    /// <summary>Reads a block.</summary>
    internal static KeptBlock Read(JsonElement json) => new(json.GetProperty("line").GetInt32(), json.GetProperty("original").GetString()!, Spans(json, "originalSpans"), Spans(json, "modifiedSpans"));

    private static (int Start, int Length)[] Spans(JsonElement json, string name) =>
        [.. json.GetProperty(name).EnumerateArray().Select(s => (s.GetProperty("start").GetInt32(), s.GetProperty("length").GetInt32()))];
}
