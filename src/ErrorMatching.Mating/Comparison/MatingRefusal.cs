namespace ErrorMatching.Mating;

/// <summary>Why a job that can be read must not lead to a program. A normal outcome, not an error.</summary>
/// <param name="Code">A stable word for scripts.</param>
/// <param name="Message">The reason in a setter's words: what was found, and what is allowed.</param>
/// <param name="Feature">Name of the feature concerned; null if none is.</param>
/// <param name="Point">Label of the point concerned; null if none is.</param>
public sealed record MatingRefusal(string Code, string Message, string? Feature = null, string? Point = null);
