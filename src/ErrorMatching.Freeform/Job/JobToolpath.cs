namespace ErrorMatching.Freeform;

/// <summary>How a surface is cut, in passes along one of its parameters.</summary>
public sealed record JobToolpath
{
    /// <summary>True if passes run along u, false if along v.</summary>
    public required bool AlongU { get; init; }

    /// <summary>True if passes alternate in direction, false if all have the same direction.</summary>
    public required bool Zigzag { get; init; }

    /// <summary>Largest height of the ridge between two passes.</summary>
    public required double ScallopMm { get; init; }

    /// <summary>Largest distance between the polyline and the exact curve.</summary>
    public required double ChordMm { get; init; }

    /// <summary>Travel height of the ball above the highest point of the surface with the stock that the stage leaves.</summary>
    public required double ClearanceMm { get; init; }

    /// <summary>True if the program moves the lowest point of the ball, false if its center.</summary>
    public required bool ProgramsTip { get; init; }

    /// <summary>Dialect of the program.</summary>
    public required string Dialect { get; init; }

    /// <summary>The shop's own template of the text around the moves, relative to the job; null for the dialect's.</summary>
    public string? Template { get; init; }

    /// <summary>The tool that the program calls; null if the job names none: the program then starts with a stop and an alarm.</summary>
    public ToolCall? Tool { get; init; }
}
