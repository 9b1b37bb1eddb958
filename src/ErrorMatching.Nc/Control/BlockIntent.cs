namespace ErrorMatching.Nc;

/// <summary>What the codes of the present block ask of its axis words.</summary>
internal sealed class BlockIntent
{
    public AxisUse Use { get; set; }

    /// <summary>The code that makes them anything but a motion.</summary>
    public NcMeaning Code { get; set; }

    /// <summary>Tells transformations apart that have an end of their own.</summary>
    public int Family { get; set; }

    /// <summary>The code that stores a place or goes to it (G28, G30); it holds on until another one comes.</summary>
    public int Reference { get; set; }

    /// <summary>True if the motion of the block probes.</summary>
    public bool Probes { get; set; }

    /// <summary>True if nobody knows what a code of the block does.</summary>
    public bool HasUnknownCode { get; set; }

    /// <summary>Forgets what the block before asked.</summary>
    public void Begin() => (Use, Code, Family, Probes, HasUnknownCode) = (AxisUse.Motion, NcMeaning.Unknown, 0, false, false);
}
