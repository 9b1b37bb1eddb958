namespace ErrorMatching.Cell;

/// <summary>The state of an incoming file on its way to a program at a machine. <see cref="CorrectionSteps"/> defines the allowed
/// steps.</summary>
public enum CorrectionState
{
    /// <summary>The file is stored, by content, and not examined yet.</summary>
    Archived,

    /// <summary>Its piece and its job are known.</summary>
    Recognized,

    /// <summary>Program, proof and report are stored.</summary>
    Computed,

    /// <summary>It waits for approval.</summary>
    Proposed,

    /// <summary>It may go to the machine and waits in line for its slot.</summary>
    Approved,

    /// <summary>It has its slot, and the machine may hold the old program or the new one.</summary>
    Uploading,

    /// <summary>The machine holds the program: it was read back and is identical to the last bit. The slot is taken.</summary>
    Verified,

    /// <summary>The piece is cut and the slot is free. Only a revert can follow.</summary>
    Released,

    /// <summary>A newer measurement of the same piece replaced it before it was sent. Final.</summary>
    Superseded,

    /// <summary>Nothing is to be sent: the measurement is kept as evidence, such as a first article's. Final.</summary>
    Recorded,

    /// <summary>No program may be made from it; the reason says why. Final.</summary>
    Refused,

    /// <summary>A person decided against it. Final.</summary>
    Rejected,

    /// <summary>Something outside failed despite retries. A setter may approve it again.</summary>
    Failed,

    /// <summary>The machine holds its previous program again. Final.</summary>
    Reverted,
}
