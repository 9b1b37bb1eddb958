namespace ErrorMatching.Freeform;

/// <summary>How a surface is cut: passes along one of its parameters.</summary>
public sealed record JobToolpath
{
    /// <summary>True if passes run along u, false if along v.</summary>
    public required bool AlongU { get; init; }

    /// <summary>True if passes go to and fro, false if all go the same way.</summary>
    public required bool Zigzag { get; init; }

    /// <summary>Largest height of the ridge that is left between two passes.</summary>
    public required double ScallopMm { get; init; }

    /// <summary>Largest distance between the polyline and the curve it stands for.</summary>
    public required double ChordMm { get; init; }

    /// <summary>Height over the highest point of the surface at which the tool travels.</summary>
    public required double ClearanceMm { get; init; }

    /// <summary>True if the program moves the lowest point of the ball, false if its center.</summary>
    public required bool ProgramsTip { get; init; }

    /// <summary>Dialect of the program.</summary>
    public required string Dialect { get; init; }

    /// <summary>The shop's own template of what stands around the moves, relative to the job; null for the dialect's.</summary>
    public string? Template { get; init; }

    /// <summary>The tool that the program calls; null if the job does not say, so that the program begins with a stop and an alarm.</summary>
    public ToolCall? Tool { get; init; }
}
