namespace ErrorMatching.Nc;

/// <summary>What the codes of the current block do with its axis words.</summary>
internal sealed class BlockIntent
{
    public AxisUse Use { get; set; }

    /// <summary>The code that makes them something other than a motion.</summary>
    public NcMeaning Code { get; set; }

    /// <summary>Distinguishes transformations that each have their own end code.</summary>
    public int Family { get; set; }

    /// <summary>The code that stores a place or moves to it (G28, G30); it stays until the next such code.</summary>
    public int Reference { get; set; }

    /// <summary>True if the block's motion is a probing move.</summary>
    public bool Probes { get; set; }

    /// <summary>True if the effect of a code of the block is unknown.</summary>
    public bool HasUnknownCode { get; set; }

    /// <summary>True if a word of the block names its motion.</summary>
    public bool NamesMotion { get; set; }

    /// <summary>True if the block's arc has no sense yet.</summary>
    public bool NeedsSense { get; set; }

    /// <summary>True if the block's end is polar, about the pole.</summary>
    public bool AboutPole { get; set; }

    /// <summary>True if the block calls a tool.</summary>
    public bool CallsTool { get; set; }

    /// <summary>What the call adds to the tool's radius, as programmed; null if it does not say, NaN if only the machine knows
    /// it.</summary>
    public double? Oversize { get; set; }

    /// <summary>Clears the intent of the previous block.</summary>
    public void Begin()
    {
        (Use, Code, Family, Probes, HasUnknownCode) = (AxisUse.Motion, NcMeaning.Unknown, 0, false, false);
        (NamesMotion, NeedsSense, AboutPole, CallsTool, Oversize) = (false, false, false, false, null);
    }
}

/// <summary>The purpose of a block's axis words.</summary>
internal enum AxisUse
{
    Motion,
    Nothing,
    Origin,
    Reference,
    MachineCoordinates,
    Cycle,
    Pole,
    Center,
    Corner,
}
