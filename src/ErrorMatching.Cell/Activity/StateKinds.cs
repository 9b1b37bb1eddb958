using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>The kinds of sources of a machine's state, by their names in the configuration.</summary>
internal static class StateKinds
{
    private static readonly Dictionary<string, Func<JsonItem, CellPaths, CellProblems, StateSettings>> Readers = new(
        StringComparer.Ordinal)
    {
        ["file"] = (item, paths, _) => StateFileSettings.Read(item, paths),
        ["linuxcnc"] = (item, _, _) => LinuxCncSettings.Read(item),
        ["mtconnect"] = (item, _, problems) => MtConnectSettings.Read(item, problems),
    };

    /// <summary>The names, in alphabetical order.</summary>
    public static IEnumerable<string> Names => Readers.Keys.Order(StringComparer.Ordinal);

    /// <summary>Reads a source's settings. The schema allows only <see cref="Names"/>.</summary>
    public static StateSettings Read(JsonItem item, CellPaths paths, CellProblems problems)
    {
        var settings = Readers[item["kind"].Text](item, paths, problems);
        return settings with
        {
            Timeout = TimeSpan.FromSeconds(item.Find("timeoutS")?.Number ?? settings.Timeout.TotalSeconds),
            WaitLimit = TimeSpan.FromMinutes(item.Find("waitLimitMin")?.Number ?? settings.WaitLimit.TotalMinutes),
            OnlyIdle = item.Find("replaceWhile")?.Text == "idle",
        };
    }
}
