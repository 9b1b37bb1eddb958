using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Paths in a configuration: relative paths start at its folder.</summary>
internal sealed class CellPaths(string file)
{
    private static readonly StringComparison Comparison = OperatingSystem.IsWindows()
        ? StringComparison.OrdinalIgnoreCase
        : StringComparison.Ordinal;
    private readonly string _folder = Path.GetDirectoryName(Path.GetFullPath(file)) ?? Path.GetFullPath(file);

    /// <summary>The absolute path for a text.</summary>
    public string Of(JsonItem item) => Of(item.Text);

    /// <summary>The absolute path for a text.</summary>
    public string Of(string path) => Path.TrimEndingDirectorySeparator(Path.GetFullPath(Path.Combine(_folder, path)));

    /// <summary>True if two absolute paths are the same.</summary>
    public static bool AreSame(string a, string b) => string.Equals(a, b, Comparison);

    /// <summary>True if a path is the folder itself or anywhere inside it.</summary>
    public static bool IsInside(string path, string folder) =>
        AreSame(path, folder)
            || path.StartsWith(Path.EndsInDirectorySeparator(folder) ? folder : folder + Path.DirectorySeparatorChar, Comparison);
}
