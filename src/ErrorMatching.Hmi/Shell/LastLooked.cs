namespace ErrorMatching.Hmi;

/// <summary>What the person who sits here chose last on each screen, so that it is there again when they come back to it. Somebody else begins anew.</summary>
internal sealed class LastLooked
{
    /// <summary>The correction of the on-line compensation; null if none was chosen. What is chosen there is the <see cref="Piece"/> as well.</summary>
    public long? Correction
    {
        get;
        set => Piece = field = value;
    }

    /// <summary>The correction that the on-line compensation showed last by itself, as long as none was chosen: it stays while it waits, also where one that waits longer came meanwhile; null if none was shown.</summary>
    public long? Shown { get; set; }

    /// <summary>The mating of the verification; null if none was chosen.</summary>
    public string? Mating { get; set; }

    /// <summary>The piece of the verification, by the number of its correction or of its measured counterpart; null if none was chosen.</summary>
    public long? Piece { get; set; }

    /// <summary>The job of the free-form surfaces; null if none was chosen.</summary>
    public string? SurfaceJob { get; set; }

    /// <summary>The measured surface; null if none was chosen.</summary>
    public long? Surface { get; set; }

    /// <summary>The side of the system set-up.</summary>
    public int SystemSide { get; set; }
}
