namespace ErrorMatching.Hmi;

/// <summary>Tells that rows on the screen are about to change, while all of them still stand where they were. On the screen's thread.</summary>
internal static class RowsChange
{
    /// <summary>Said before rows of any list change.</summary>
    public static event Action? Coming;

    /// <summary>Says it.</summary>
    public static void Tell() => Coming?.Invoke();
}
