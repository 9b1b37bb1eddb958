namespace ErrorMatching.Cell;

/// <summary>Stable codes for why a running cell refuses a file, or cannot work, and for errors of its store, its users and its audit
/// trail.</summary>
public static class CellCodes
{
    /// <summary>The same measurement, job and original program have already been used.</summary>
    public const string AlreadyKnown = "already-known";

    /// <summary>A newer measurement of the same piece replaced it.</summary>
    public const string Superseded = "superseded";

    /// <summary>Its job was changed, and its measurement is recalculated.</summary>
    public const string Recalculated = ArrivalWriter.Recalculated;

    /// <summary>Corrections must accumulate on a program whose sums are unknown.</summary>
    public const string SumsUnknown = "sums-unknown";

    /// <summary>Corrections accumulate, but it is not recorded which program cut the measured piece.</summary>
    public const string NotReleased = "not-released";

    /// <summary>The program that a correction adds to was reverted.</summary>
    public const string BaseReverted = "base-reverted";

    /// <summary>Something waits for a gauge, job or slot that is no longer in the configuration.</summary>
    public const string NotConfigured = "not-configured";

    /// <summary>Files cannot be moved out of a gauge's folder.</summary>
    public const string GaugeDenied = "gauge-denied";

    /// <summary>A gauge's folder cannot be read.</summary>
    public const string GaugeAway = "gauge-away";

    /// <summary>A file in a gauge's folder cannot be taken.</summary>
    public const string FileLeft = "file-left";

    /// <summary>The heartbeat or the end of the audit trail cannot be saved outside the store.</summary>
    public const string NotKept = "not-kept";

    /// <summary>A defect of the program.</summary>
    public const string Defect = "internal-error";

    /// <summary>The cell does not know the program in the slot.</summary>
    public const string ChangedAtMachine = "changed-at-machine";

    /// <summary>The control would call a program otherwise than its slot's file, or than the program that is there.</summary>
    public const string NamedOtherwise = "program-named-otherwise";

    /// <summary>Another program of the machine has the name or number by which the control would call a program.</summary>
    public const string NameTaken = "program-name-taken";

    /// <summary>A program waits for its machine longer than the limit.</summary>
    public const string WaitsTooLong = "waits-too-long";

    /// <summary>What waits at a gauge has grown for a minute: more arrives than the cell computes.</summary>
    public const string BacklogGrows = "backlog-grows";

    /// <summary>A measured piece waits at a gauge longer than the limit.</summary>
    public const string PieceWaits = "piece-waits";

    /// <summary>A program must not be replaced, because its machine runs it or may run it.</summary>
    public const string MachineBusy = "machine-busy";

    /// <summary>A machine started a program while it was being replaced.</summary>
    public const string StartedMeanwhile = "started-meanwhile";

    /// <summary>In the audit trail: whether a machine started a program while it was reverted is not known.</summary>
    public const string ReadBackUnseen = "read-back-unseen";

    /// <summary>In the audit trail: the slot again holds the verified program after a change.</summary>
    public const string HeldAgain = "held-again";

    /// <summary>In the audit trail: a machine or a gauge does not respond, or responds incorrectly.</summary>
    public const string NoAnswer = "no-answer";

    /// <summary>In the audit trail: a machine or a gauge responds again.</summary>
    public const string AnswersAgain = "answers-again";

    /// <summary>The code for a failed store call.</summary>
    public static string Of(StoreError error) => "store-" + Words(error.ToString());

    /// <summary>The code for a failed transfer.</summary>
    public static string Of(TransportError error) => "machine-" + Words(error.ToString());

    /// <summary>The code for a broker that does not take messages.</summary>
    public static string Of(BrokerError error) => "broker-" + Words(error.ToString());

    /// <summary>The code for an error about users or secrets.</summary>
    public static string Of(PeopleError error) =>
        error == PeopleError.Tampered ? "user-tampered" : Words(error.ToString());

    /// <summary>The code for a fault of the audit trail.</summary>
    public static string Of(AuditFaultKind kind) => kind switch
    {
        AuditFaultKind.KeysMissing => Of(PeopleError.KeysMissing),
        AuditFaultKind.WitnessMissing => "audit-seen-missing",
        _ => "audit-" + Words(kind.ToString()),
    };

    // ReadOnly becomes read-only.
    private static string Words(string name) =>
        string.Concat(name.Select((c, i) => char.IsAsciiLetterUpper(c) ? (i > 0 ? "-" : "") + char.ToLowerInvariant(c) : c.ToString()));
}
