using ErrorMatching.Json;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Why a valid job must not produce a program. A normal outcome, not an error.</summary>
/// <param name="Code">A stable code for scripts.</param>
/// <param name="Message">The reason in the setter's terms: what was found, and what is allowed.</param>
/// <param name="Feature">Name of the feature concerned, or null.</param>
/// <param name="Point">Label of the point concerned, or null.</param>
/// <param name="Block">The block concerned, as the setter knows it, or null.</param>
/// <param name="Line">Its line in the program, from 1, or 0.</param>
public sealed record MatingRefusal(
    string Code, string Message, string? Feature = null, string? Point = null, string? Block = null, int Line = 0)
{
    /// <summary>Distance of the point from the path, mm; null for other reasons.</summary>
    public double? DistanceMm { get; init; }

    /// <summary>JSON path of the job's value at fault, such as <c>$.features[0].toleranceMm</c>, or null.</summary>
    public string? Path { get; init; }

    /// <summary>Position of that value in the job, or null.</summary>
    public JsonPlace? Place { get; init; }

    /// <summary>Why a program could not be interpreted to its end, or null.</summary>
    internal static MatingRefusal? OfPath(NcPath path) => path.Refusal is { } refusal ? Of(refusal) : null;

    /// <summary>Converts a program's refusal to a job's.</summary>
    /// <param name="refusal">The refusal.</param>
    /// <param name="feature">Name of the feature concerned, or null.</param>
    public static MatingRefusal Of(NcRefusal refusal, string? feature = null) => new(
        refusal.Code,
        feature is null ? refusal.Message : $"{feature}: {refusal.Message}",
        feature,
        Block: refusal.Block.Length > 0 ? refusal.Block : null,
        Line: refusal.Line);
}
