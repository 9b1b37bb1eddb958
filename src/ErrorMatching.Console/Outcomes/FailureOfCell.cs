using ErrorMatching.Cell;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary>Translates the cell's exceptions for the console's user. A separate class, so that a match does not load the cell.</summary>
internal static class FailureOfCell
{
    /// <summary>An act that a person may not do, or a failed operation on users or secrets.</summary>
    public static Failure People(PeopleException e) => new(ExitOf(e.Error), new Refusal(CellCodes.Of(e.Error), e.Message));

    /// <summary>A failed store call.</summary>
    public static Failure Store(StoreException e) => new(ExitOf(e.Error), new Refusal(CellCodes.Of(e.Error), e.Message));

    /// <summary>A decision that cannot be carried out. An unknown number is wrong input; everything else is a refusal.</summary>
    public static Failure Decision(DecisionException e) =>
        new(
            e.Code is DecisionException.UnknownCorrection or DecisionException.UnknownAlarm ? ExitCode.WrongInput : ExitCode.Refused,
            new Refusal(e.Code, e.Message));

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
    public static Failure Audit(AuditFault fault) => new(ExitCode.Refused, new Refusal(CellCodes.Of(fault.Kind), fault.Message));

    // Wrong input can be corrected by typing again; a refusal remains until someone changes the cause.
    private static ExitCode ExitOf(PeopleError error) => error switch
    {
        PeopleError.LockedOut or PeopleError.UserDisabled or PeopleError.UnknownRole or PeopleError.Tampered or PeopleError.KeysMissing
            or PeopleError.NotAllowed or PeopleError.NotSigned or PeopleError.LastAdministrator or PeopleError.SecretUnreadable
            or PeopleError.BadgeTaken or PeopleError.WayNotAllowed =>
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
