using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>The kinds of transport, by their names in the configuration.</summary>
internal static class TransportKinds
{
    private static readonly Dictionary<string, Func<JsonItem, CellPaths, CellProblems, TransportSettings>> Readers = new(
        StringComparer.Ordinal)
    {
        ["folder"] = (item, paths, _) => new FolderSettings(paths.Of(item["folder"])),
        ["ftp"] = (item, _, problems) => FtpReader.Read(item, problems),
        ["sftp"] = SftpReader.Read,
    };

    /// <summary>The names, in alphabetical order.</summary>
    public static IEnumerable<string> Names => Readers.Keys.Order(StringComparer.Ordinal);

    /// <summary>Reads a transport's settings. The schema allows only <see cref="Names"/>.</summary>
    public static TransportSettings Read(JsonItem item, CellPaths paths, CellProblems problems) =>
        Readers[item["kind"].Text](item, paths, problems);
}
