namespace ErrorMatching.Hmi;

/// <summary>All screens. A new screen needs a line here, a line in <c>Views</c>, its key, its texts and an icon.</summary>
public static class Screens
{
    /// <summary>The screens after the login, in the order of the navigation.</summary>
    public static IReadOnlyList<Screen> All { get; } =
    [
        new(
            ScreenKeys.Overview,
            shell => new OverviewViewModel(
                shell.Station,
                shell.Look,
                shell.LookAtPiece,
                () => shell.Go(ScreenKeys.Compensation),
                () => shell.Go(ScreenKeys.Messages))),
        new(ScreenKeys.Points, shell => new PointsViewModel(shell)),
        new(ScreenKeys.System, shell => new SystemViewModel(shell)),
        new(ScreenKeys.Compensation, shell => new CompensationViewModel(shell)),
        new(ScreenKeys.Verification, shell => new VerificationViewModel(shell)),
        new(ScreenKeys.Freeform, shell => new FreeformViewModel(shell)),
        new(ScreenKeys.History, shell => new HistoryViewModel(shell)),
        new(ScreenKeys.Messages, shell => new MessagesViewModel(shell)),
        new(ScreenKeys.Settings, shell => new SettingsViewModel(shell)),
    ];

    /// <summary>Creates the shell of a station, with all screens.</summary>
    public static ShellViewModel ShellOf(Station station) =>
        new(station, (lastName, unlock) => new LoginViewModel(station, lastName, unlock), All);
}
