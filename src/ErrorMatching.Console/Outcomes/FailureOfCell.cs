using ErrorMatching.Cell;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary>Translates the cell's exceptions for the console's user. A separate class, so that a match does not load the cell.</summary>
internal static class FailureOfCell
{
    /// <summary>An act that a person may not do, or a failed operation on users or secrets.</summary>
    public static Failure People(PeopleException e) => new(ExitOf(e.Error), new Refusal(CodeOf(e.Error), e.Message));

    /// <summary>A failed store call.</summary>
    public static Failure Store(StoreException e) => new(ExitOf(e.Error), new Refusal(CodeOf(e.Error), e.Message));

    /// <summary>A decision that cannot be carried out. An unknown number is wrong input; everything else is a refusal.</summary>
    public static Failure Decision(DecisionException e) =>
        new(e.Code == DecisionException.UnknownCorrection ? ExitCode.WrongInput : ExitCode.Refused, new Refusal(e.Code, e.Message));

    /// <summary>A failed transfer to or from a machine.</summary>
    public static Failure Machine(TransportException e) => new(ExitCode.Outside, new Refusal(CellCodes.Of(e.Error), e.Message));

    /// <summary>A password that could not be read.</summary>
    public static Failure Secret(SecretInputException e) => new(ExitCode.WrongInput, new Refusal("no-password", e.Message));

    /// <summary>A machine that the configuration does not name.</summary>
    public static Failure UnknownMachine(CellSettings settings, string machine) => new(ExitCode.WrongInput, new Refusal(
        "unknown-machine",
        $"names no machine {machine}; it names {string.Join(", ", settings.Machines.Select(m => m.Name))}.",
        new() { File = settings.File, Path = "$.machines" }));

    /// <summary>An audit trail that differs from what was written.</summary>
    public static Failure Audit(AuditFault fault) => new(ExitCode.Refused, new Refusal(CodeOf(fault.Kind), fault.Message));

    /// <summary>The code of an error about users or secrets.</summary>
    public static string CodeOf(PeopleError error) => error switch
    {
        PeopleError.NoUsers => "no-users",
        PeopleError.SignInRefused => "sign-in-refused",
        PeopleError.LockedOut => "locked-out",
        PeopleError.UserDisabled => "user-disabled",
        PeopleError.UnknownRole => "unknown-role",
        PeopleError.Tampered => "user-tampered",
        PeopleError.NotAllowed => "not-allowed",
        PeopleError.NotSigned => "not-signed",
        PeopleError.BadUserName => "bad-user-name",
        PeopleError.WeakPassword => "weak-password",
        PeopleError.UserExists => "user-exists",
        PeopleError.UnknownUser => "unknown-user",
        PeopleError.LastAdministrator => "last-administrator",
        PeopleError.BadSecret => "bad-secret",
        PeopleError.SecretUnreadable => "secret-unreadable",
        PeopleError.KeysUnusable => "keys-unusable",
        PeopleError.KeysMissing => "keys-missing",
        _ => throw new ArgumentOutOfRangeException(nameof(error), error, "An error about people without a code."),
    };

    /// <summary>The code of a store error.</summary>
    public static string CodeOf(StoreError error) => error switch
    {
        StoreError.Conflict => "store-conflict",
        StoreError.Missing => "store-missing",
        StoreError.Damaged => "store-damaged",
        StoreError.Tampered => "store-tampered",
        StoreError.Foreign => "store-foreign",
        StoreError.TooNew => "store-too-new",
        StoreError.Locked => "store-locked",
        StoreError.Full => "store-full",
        StoreError.ReadOnly => "store-read-only",
        StoreError.Denied => "store-denied",
        StoreError.Disk => "store-disk",
        StoreError.Replaced => "store-replaced",
        StoreError.Redrawn => "store-redrawn",
        StoreError.Archived => "store-archived",
        StoreError.Away => "store-away",
        StoreError.NotSupported => "store-not-supported",
        StoreError.Unknown => "store-unknown",
        _ => throw new ArgumentOutOfRangeException(nameof(error), error, "An error of the store without a code."),
    };

    /// <summary>The code of an audit trail's fault.</summary>
    public static string CodeOf(AuditFaultKind error) => error switch
    {
        AuditFaultKind.Changed => "audit-changed",
        AuditFaultKind.Removed => "audit-removed",
        AuditFaultKind.Inserted => "audit-inserted",
        AuditFaultKind.Reordered => "audit-reordered",
        AuditFaultKind.NotAllowed => "audit-not-allowed",
        AuditFaultKind.RowDiffers => "audit-row-differs",
        AuditFaultKind.FormDiffers => "audit-form-differs",
        AuditFaultKind.Unsealed => "audit-unsealed",
        AuditFaultKind.KeysMissing => "keys-missing",
        AuditFaultKind.WitnessMissing => "audit-seen-missing",
        _ => throw new ArgumentOutOfRangeException(nameof(error), error, "A broken audit trail without a code."),
    };

    // Wrong input can be corrected by typing again; a refusal remains until someone changes the cause.
    private static ExitCode ExitOf(PeopleError error) => error switch
    {
        PeopleError.LockedOut or PeopleError.UserDisabled or PeopleError.UnknownRole or PeopleError.Tampered or PeopleError.KeysMissing
            or PeopleError.NotAllowed or PeopleError.NotSigned or PeopleError.LastAdministrator or PeopleError.SecretUnreadable =>
                ExitCode.Refused,
        PeopleError.KeysUnusable => ExitCode.Outside,
        _ => ExitCode.WrongInput,
    };

    private static ExitCode ExitOf(StoreError error) => error switch
    {
        StoreError.Conflict or StoreError.Tampered or StoreError.Replaced or StoreError.Redrawn => ExitCode.Refused,
        StoreError.Missing or StoreError.Foreign or StoreError.TooNew or StoreError.NotSupported => ExitCode.WrongInput,
        _ => ExitCode.Outside,
    };
}
