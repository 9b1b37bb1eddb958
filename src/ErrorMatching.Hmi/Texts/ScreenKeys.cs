namespace ErrorMatching.Hmi;

/// <summary>The stable keys of the screens: each has the text <c>Screen.KEY</c> and the icon <c>Icon.KEY</c>.</summary>
public static class ScreenKeys
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
}
