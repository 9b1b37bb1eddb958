namespace ErrorMatching.Cell;

/// <summary>A person's decision that cannot be carried out. Nothing was changed.</summary>
/// <param name="code">Stable word: one of the constants.</param>
/// <param name="message">A sentence for the person: what stands in the way and what to do.</param>
public sealed class DecisionException(string code, string message) : Exception(message)
{
    /// <summary>The store has no correction of this number.</summary>
    public const string UnknownCorrection = "unknown-correction";

    /// <summary>From the correction's state no step leads to what was decided.</summary>
    public const string WrongState = "wrong-state";

    /// <summary>Somebody else decided first.</summary>
    public const string ChangedMeanwhile = "changed-meanwhile";

    /// <summary>There is no program to send.</summary>
    public const string NothingToSend = "nothing-to-send";

    /// <summary>It was made with the job as it is now: computed anew, it would be the same.</summary>
    public const string JobUnchanged = "job-unchanged";

    /// <summary>Its job cannot be used as it is now, or is not in the configuration any more.</summary>
    public const string JobUnusable = "job-unusable";

    /// <summary>Another correction was made of the same measurement with the job as it is now.</summary>
    public const string AlreadyKnown = CellCodes.AlreadyKnown;

    /// <summary>The slot held nothing before.</summary>
    public const string NothingBefore = "nothing-before";

    /// <summary>The slot has another correction, or is being sent to.</summary>
    public const string SlotTaken = "slot-taken";

    /// <summary>The slot's program is not the one that is to be taken back.</summary>
    public const string ChangedAtMachine = CellCodes.ChangedAtMachine;

    /// <summary>Stable word.</summary>
    public string Code => code;
}
