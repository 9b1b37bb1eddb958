namespace ErrorMatching.Hmi.Platform;

/// <summary>Finds font files in the folders where the system keeps them.</summary>
internal static class FontFolders
{
    /// <summary>Largest font file that is read.</summary>
    public const int MostBytes = 128 << 20;

    private const int MostFiles = 5_000, MostDepth = 8;
    private static readonly string[] Endings = [".ttf", ".otf", ".ttc", ".otc"];

    /// <summary>The folder of the fonts that the station brings along.</summary>
    public static string Own => Path.Combine(AppContext.BaseDirectory, "fonts");

    /// <summary>The folders of the system and of the user.</summary>
    public static IReadOnlyList<string> Usual
    {
        get
        {
            if (OperatingSystem.IsWindows())
            {
                return [
                    Folder(Environment.SpecialFolder.Fonts),
                    Path.Combine(Folder(Environment.SpecialFolder.LocalApplicationData), "Microsoft", "Windows", "Fonts"),
                ];
            }

            var home = Folder(Environment.SpecialFolder.UserProfile);
            var data = Environment.GetEnvironmentVariable("XDG_DATA_HOME");
            return [
                "/usr/share/fonts",
                "/usr/local/share/fonts",
                .. home.Length == 0 ? Array.Empty<string>() : [Path.Combine(home, ".fonts"), Path.Combine(home, ".local/share/fonts")],
                .. string.IsNullOrEmpty(data) ? Array.Empty<string>() : [Path.Combine(data, "fonts")],
            ];
        }
    }

    /// <summary>The font files below some folders, by name. Links, hidden and oversized files are left out, as is what cannot be
    /// read.</summary>
    public static IReadOnlyList<string> Files(IReadOnlyList<string> folders)
    {
        var options = new EnumerationOptions
        {
            RecurseSubdirectories = true,
            MaxRecursionDepth = MostDepth,
            IgnoreInaccessible = true,
            AttributesToSkip = FileAttributes.ReparsePoint | FileAttributes.Hidden | FileAttributes.System,
        };
        return [
            .. folders
                .Where(Directory.Exists)
                .SelectMany(f => new DirectoryInfo(f).EnumerateFiles("*", options))
                .Where(f => Endings.Contains(f.Extension, StringComparer.OrdinalIgnoreCase) && f.Length is > 0 and <= MostBytes)
                .Take(MostFiles)
                .Select(f => f.FullName)
                .Distinct(StringComparer.Ordinal)
                .Order(StringComparer.Ordinal),
        ];
    }

    private static string Folder(Environment.SpecialFolder folder) =>
        Environment.GetFolderPath(folder, Environment.SpecialFolderOption.DoNotVerify);
}
