namespace ErrorMatching.Cell;

/// <summary>How far an incoming file has come on its way to a program at a machine. Which steps lead from where is said by <see cref="CorrectionSteps"/>.</summary>
public enum CorrectionState
{
    /// <summary>The file is kept, by content, and nobody has looked at it yet.</summary>
    Archived,

    /// <summary>It is known whose measurement it is and which job it belongs to.</summary>
    Recognized,

    /// <summary>Program, proof and report are kept.</summary>
    Computed,

    /// <summary>It waits for an approval.</summary>
    Proposed,

    /// <summary>It may go to the machine and waits in line for its slot.</summary>
    Approved,

    /// <summary>It has its slot, and the machine may hold the old program or the new one.</summary>
    Uploading,

    /// <summary>The machine holds the program: it was read back and is the same to the last bit. The slot is taken.</summary>
    Verified,

    /// <summary>The piece is cut, the slot is free. An end.</summary>
    Released,

    /// <summary>A newer measurement of the same piece took its place before it was sent. An end.</summary>
    Superseded,

    /// <summary>Nothing is to be sent: a measurement that is kept as evidence, such as a first article's. An end.</summary>
    Recorded,

    /// <summary>No program may be made of it; the reason says why. An end.</summary>
    Refused,

    /// <summary>A person decided against it. An end.</summary>
    Rejected,

    /// <summary>Something outside failed after its retries. A setter may approve it again.</summary>
    Failed,

    /// <summary>The machine holds the program that it held before. An end.</summary>
    Reverted,
}
