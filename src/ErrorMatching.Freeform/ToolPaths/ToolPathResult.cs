using System.Diagnostics.CodeAnalysis;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>A tool path, or the reason for refusing it.</summary>
public sealed class ToolPathResult
{
    private ToolPathResult(ToolPath? path, Refusal? refusal) => (Path, Refusal) = (path, refusal);

    /// <summary>The path; null if refused.</summary>
    public ToolPath? Path { get; }

    /// <summary>The reason; null if there is a path.</summary>
    public Refusal? Refusal { get; }

    /// <summary>True if there is a path.</summary>
    [MemberNotNullWhen(true, nameof(Path))]
    [MemberNotNullWhen(false, nameof(Refusal))]
    public bool IsUsable => Path is not null;

    /// <summary>A path within its tolerances.</summary>
    public static implicit operator ToolPathResult(ToolPath path) => new(path, null);

    /// <summary>A refusal.</summary>
    public static implicit operator ToolPathResult(Refusal refusal) => new(null, refusal);
}
