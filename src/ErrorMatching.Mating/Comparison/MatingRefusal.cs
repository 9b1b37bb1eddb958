using ErrorMatching.Json;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Why a job that can be read must not lead to a program. A normal outcome, not an error.</summary>
/// <param name="Code">A stable word for scripts.</param>
/// <param name="Message">The reason in a setter's words: what was found, and what is allowed.</param>
/// <param name="Feature">Name of the feature concerned; null if none is.</param>
/// <param name="Point">Label of the point concerned; null if none is.</param>
/// <param name="Block">The block concerned as the setter knows it; null if none is.</param>
/// <param name="Line">Its line in the program, from 1; 0 if none is.</param>
public sealed record MatingRefusal(
    string Code, string Message, string? Feature = null, string? Point = null, string? Block = null, int Line = 0)
{
    /// <summary>How far the point lies from the path, mm; null where the reason is another one.</summary>
    public double? DistanceMm { get; init; }

    /// <summary>JSON path of the job's value that is to blame, such as <c>$.features[0].toleranceMm</c>; null if none is.</summary>
    public string? Path { get; init; }

    /// <summary>Where that value is in the job; null if none is to blame.</summary>
    public JsonPlace? Place { get; init; }

    /// <summary>Why a program could not be followed to its end, or null.</summary>
    internal static MatingRefusal? OfPath(NcPath path) => path.Refusal is { } refusal ? Of(refusal) : null;

    /// <summary>A program's refusal as that of a job.</summary>
    /// <param name="refusal">The refusal.</param>
    /// <param name="feature">Name of the feature concerned; null if none is.</param>
    public static MatingRefusal Of(NcRefusal refusal, string? feature = null) => new(
        refusal.Code,
        feature is null ? refusal.Message : $"{feature}: {refusal.Message}",
        feature,
        Block: refusal.Block.Length > 0 ? refusal.Block : null,
        Line: refusal.Line);
}
