namespace ErrorMatching.Cell;

/// <summary>A person's decision cannot be carried out. Nothing was changed.</summary>
/// <param name="code">Stable code: one of the constants.</param>
/// <param name="message">A sentence for the person: the obstacle and what to do.</param>
public sealed class DecisionException(string code, string message) : Exception(message)
{
    /// <summary>The store has no correction of this number.</summary>
    public const string UnknownCorrection = "unknown-correction";

    /// <summary>The correction's state does not allow the decision.</summary>
    public const string WrongState = "wrong-state";

    /// <summary>Someone else decided first.</summary>
    public const string ChangedMeanwhile = "changed-meanwhile";

    /// <summary>There is no program to send.</summary>
    public const string NothingToSend = "nothing-to-send";

    /// <summary>It was made with the job's current version: recalculated, it would be the same.</summary>
    public const string JobUnchanged = "job-unchanged";

    /// <summary>Its job is unusable, or no longer in the configuration.</summary>
    public const string JobUnusable = "job-unusable";

    /// <summary>Another correction was made from the same measurement with the job's current version.</summary>
    public const string AlreadyKnown = CellCodes.AlreadyKnown;

    /// <summary>There was no program in the slot before.</summary>
    public const string NothingBefore = "nothing-before";

    /// <summary>The slot has another correction, or a transfer to it is in progress.</summary>
    public const string SlotTaken = "slot-taken";

    /// <summary>The slot's program is not the one to be reverted.</summary>
    public const string ChangedAtMachine = CellCodes.ChangedAtMachine;

    /// <summary>The machine runs the program, or may run it.</summary>
    public const string MachineBusy = CellCodes.MachineBusy;

    /// <summary>The machine started the program while it was being replaced.</summary>
    public const string StartedMeanwhile = CellCodes.StartedMeanwhile;

    /// <summary>Stable code.</summary>
    public string Code => code;
}
