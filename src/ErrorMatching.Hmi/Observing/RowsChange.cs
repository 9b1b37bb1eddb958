namespace ErrorMatching.Hmi;

/// <summary>Announces that rows on the screen are about to change, while all are still in place. Use it on the UI thread only.</summary>
internal static class RowsChange
{
    /// <summary>Raised before the rows of any list change.</summary>
    public static event Action? Coming;

    public static void Report() => Coming?.Invoke();
}
