namespace ErrorMatching.Hmi;

/// <summary>All screens after the login, in the order of the navigation. A new screen needs a line here, a line in <c>Views</c>,
/// its texts and an icon.</summary>
public static class Screens
{
    public const string Overview = "overview";

    public const string Points = "points";

    public const string System = "system";

    public const string Compensation = "compensation";

    public const string Verification = "verification";

    public const string Freeform = "freeform";

    public const string History = "history";

    /// <summary>Messages and audit trail.</summary>
    public const string Messages = "messages";

    public const string Settings = "settings";

    public static IReadOnlyList<Screen> All { get; } =
    [
        new(Overview, shell => new OverviewViewModel(shell.Station, shell.Look, shell.LookAtPiece)),
        new(Points, shell => new PointsViewModel(shell)),
        new(System, shell => new SystemViewModel(shell)),
        new(Compensation, shell => new CompensationViewModel(shell)),
        new(Verification, shell => new VerificationViewModel(shell)),
        new(Freeform, shell => new FreeformViewModel(shell)),
        new(History, shell => new HistoryViewModel(shell)),
        new(Messages, shell => new MessagesViewModel(shell.Station, shell.Look, shell.LookAtPiece)),
        new(Settings, shell => new SettingsViewModel(shell)),
    ];
}
