namespace ErrorMatching.Json;

/// <summary>Paths as reports and messages state them: with <c>/</c> between folders on every system, so that the same inputs make the same
/// report, byte for byte. Windows opens such paths as well.</summary>
public static class PathText
{
    /// <summary>A path as it is stated. Only on Windows a backslash separates folders; elsewhere it is part of a name.</summary>
    public static string Of(string path) => Of(path, OperatingSystem.IsWindows());

    /// <summary>The stated path of a name in a folder.</summary>
    /// <param name="folder">The folder; null or empty for the current one.</param>
    /// <param name="name">A name or a path from there. An absolute path stays as it is.</param>
    public static string In(string? folder, string name) => Of(Path.Combine(folder ?? "", name));

    /// <summary>The stated path of a name in the folder of a file.</summary>
    /// <param name="file">The file.</param>
    /// <param name="name">A name or a path from there. An absolute path stays as it is.</param>
    public static string Beside(string file, string name) => In(Path.GetDirectoryName(file), name);

    internal static string Of(string path, bool isWindows)
    {
        ArgumentNullException.ThrowIfNull(path);
        return isWindows ? path.Replace('\\', '/') : path;
    }
}
