namespace ErrorMatching.Hmi;

/// <summary>The current user's last choice on each screen, restored when the screen is opened again. Another user starts without
/// choices.</summary>
internal sealed class LastLooked
{
    /// <summary>The correction chosen in the on-line compensation; null if there is none. Sets <see cref="Piece"/>, too.</summary>
    public long? Correction
    {
        get;
        set => Piece = field = value;
    }

    /// <summary>The correction last selected automatically in the on-line compensation, as long as the user chose none; null if
    /// there is none. It stays selected while it waits, even if a longer-waiting one has arrived meanwhile.</summary>
    public long? Shown { get; set; }

    /// <summary>The mating chosen in the verification; null if there is none.</summary>
    public string? Mating { get; set; }

    /// <summary>The piece chosen in the verification, by the number of its correction or measured counterpart; null if there is
    /// none.</summary>
    public long? Piece { get; set; }

    /// <summary>The chosen free-form job; null if there is none.</summary>
    public string? SurfaceJob { get; set; }

    /// <summary>The chosen measured surface; null if there is none.</summary>
    public long? Surface { get; set; }

    /// <summary>The tab of the system set-up.</summary>
    public int SystemSide { get; set; }
}
