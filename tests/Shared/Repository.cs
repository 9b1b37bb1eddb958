namespace ErrorMatching.Testing;

/// <summary>Locations in the checkout that tests read: samples, READMEs, public API snapshots.</summary>
internal static class Repository
{
    /// <summary>The folder with the solution file, searched upward from the test's own location.</summary>
    public static string Root { get; } = FindRoot();

    /// <summary>A path inside the checkout.</summary>
    public static string PathTo(params string[] parts) => Path.Combine([Root, .. parts]);

    private static string FindRoot()
    {
        for (var folder = new DirectoryInfo(AppContext.BaseDirectory); folder is not null; folder = folder.Parent)
        {
            if (File.Exists(Path.Combine(folder.FullName, "ErrorMatching.sln")))
            {
                return folder.FullName;
            }
        }

        throw new InvalidOperationException("These tests read files of the checkout and must run from inside it.");
    }
}
