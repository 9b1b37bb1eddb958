using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>The kinds of ways to a machine, by the name that the configuration gives them.</summary>
internal static class TransportKinds
{
    private static readonly Dictionary<string, Func<JsonItem, CellPaths, CellProblems, TransportSettings>> Readers = new(StringComparer.Ordinal)
    {
        ["folder"] = (item, paths, _) => new FolderSettings(paths.Of(item["folder"])),
        ["ftp"] = (item, _, problems) => FtpReader.Read(item, problems),
        ["sftp"] = SftpReader.Read,
    };

    /// <summary>The names, in order of the alphabet.</summary>
    public static IEnumerable<string> Names => Readers.Keys.Order(StringComparer.Ordinal);

    /// <summary>Reads the way to a machine. The schema lets only <see cref="Names"/> through.</summary>
    public static TransportSettings Read(JsonItem item, CellPaths paths, CellProblems problems) => Readers[item["kind"].Text](item, paths, problems);
}
