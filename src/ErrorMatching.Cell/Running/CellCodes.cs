namespace ErrorMatching.Cell;

/// <summary>Stable words for why a running cell refuses a file, or cannot work.</summary>
public static class CellCodes
{
    /// <summary>The same measurement, job and original program were there before.</summary>
    public const string AlreadyKnown = "already-known";

    /// <summary>A newer measurement of the same piece took its place.</summary>
    public const string Superseded = "superseded";

    /// <summary>Its job was changed, and its measurement is computed anew.</summary>
    public const string ComputedAnew = "computed-anew";

    /// <summary>Corrections shall add up to a program whose sums nobody knows.</summary>
    public const string SumsUnknown = "sums-unknown";

    /// <summary>Corrections shall add up, and nobody has said which program cut the measured piece.</summary>
    public const string NotReleased = "not-released";

    /// <summary>The program that a correction adds to was reverted.</summary>
    public const string BaseReverted = "base-reverted";

    /// <summary>Something waits for a gauge, job or slot that the configuration does not have any more.</summary>
    public const string NotConfigured = "not-configured";

    /// <summary>Files cannot be taken out of a gauge's folder.</summary>
    public const string GaugeDenied = "gauge-denied";

    /// <summary>A gauge's folder cannot be looked into.</summary>
    public const string GaugeAway = "gauge-away";

    /// <summary>A file lies in a gauge's folder and cannot be taken.</summary>
    public const string FileLeft = "file-left";

    /// <summary>The sign of life or the end of the audit trail cannot be kept beside the store.</summary>
    public const string NotKept = "not-kept";

    /// <summary>A defect of the program.</summary>
    public const string Defect = "internal-error";

    /// <summary>The slot's file is none that the cell knows.</summary>
    public const string ChangedAtMachine = "changed-at-machine";

    /// <summary>In the audit trail: the slot's file, which was changed, is the verified one again.</summary>
    public const string HeldAgain = "held-again";

    /// <summary>In the audit trail: a machine or a gauge does not answer, or not as it must.</summary>
    public const string NoAnswer = "no-answer";

    /// <summary>In the audit trail: a machine or a gauge that did not answer answers again.</summary>
    public const string AnswersAgain = "answers-again";

    /// <summary>What the store could not do.</summary>
    public static string Of(StoreError error) => "store-" + Words(error.ToString());

    /// <summary>What a machine did not let happen.</summary>
    public static string Of(TransportError error) => "machine-" + Words(error.ToString());

    // ReadOnly becomes read-only.
    private static string Words(string name) => string.Concat(name.Select((c, i) => char.IsAsciiLetterUpper(c) ? (i > 0 ? "-" : "") + char.ToLowerInvariant(c) : c.ToString()));
}
