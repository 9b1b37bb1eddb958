namespace ErrorMatching.Hmi;

/// <summary>All screens behind the login, in the order of the navigation. A new one takes a line here, a line in <c>Views</c>, its texts and an icon.</summary>
public static class Screens
{
    /// <summary>Key of the overview.</summary>
    public const string Overview = "overview";

    /// <summary>Key of the point set-up.</summary>
    public const string Points = "points";

    /// <summary>Key of the system set-up.</summary>
    public const string System = "system";

    /// <summary>Key of the on-line compensation.</summary>
    public const string Compensation = "compensation";

    /// <summary>Key of the verification.</summary>
    public const string Verification = "verification";

    /// <summary>Key of free-form surfaces.</summary>
    public const string Freeform = "freeform";

    /// <summary>Key of the history.</summary>
    public const string History = "history";

    /// <summary>Key of messages and audit trail.</summary>
    public const string Messages = "messages";

    /// <summary>Key of the settings.</summary>
    public const string Settings = "settings";

    /// <summary>The screens.</summary>
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
