namespace ErrorMatching.Cell;

/// <summary>Stable words for why a running cell refuses a file, or cannot work.</summary>
public static class CellCodes
{
    /// <summary>The same measurement, job and original program were there before.</summary>
    public const string AlreadyKnown = "already-known";

    /// <summary>A newer measurement of the same piece took its place.</summary>
    public const string Superseded = "superseded";

    /// <summary>Corrections shall add up to a program whose sums nobody knows.</summary>
    public const string SumsUnknown = "sums-unknown";

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

    /// <summary>What the store could not do.</summary>
    public static string Of(StoreError error) => "store-" + Words(error.ToString());

    /// <summary>What a machine did not let happen.</summary>
    public static string Of(TransportError error) => "machine-" + Words(error.ToString());

    // ReadOnly becomes read-only.
    private static string Words(string name) => string.Concat(name.Select((c, i) => char.IsAsciiLetterUpper(c) ? (i > 0 ? "-" : "") + char.ToLowerInvariant(c) : c.ToString()));
}
