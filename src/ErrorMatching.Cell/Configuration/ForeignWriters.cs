using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Finds what others could change behind the cell's back: the configuration, jobs, programs and the store. What everybody may
/// write is refused. What a group may write is a warning: many systems give each account a group of its own.</summary>
internal sealed class ForeignWriters(JsonItem root, CellSettings settings, CellProblems problems)
{
    // A folder is named once, not again for each file in it.
    private readonly HashSet<string> _said = new(StringComparer.Ordinal);

    /// <summary>Finds them all.</summary>
    /// <param name="own">The absolute path of the configuration.</param>
    /// <param name="jobs">The jobs and the files that they name.</param>
    public void Find(string own, IReadOnlyList<(JsonItem Item, CellJobSettings Settings, NamedJob? Job)> jobs)
    {
        Check(root, "the configuration", own);
        foreach (var (item, job, named) in jobs)
        {
            string?[] files = [job.File, job.Program, .. named?.Files ?? []];
            foreach (var file in files.OfType<string>().Distinct(StringComparer.Ordinal))
                Check(item["job"], $"the job \"{job.Name}\"", file);
        }

        for (var i = 0; i < settings.Machines.Count; i++)
        {
            if (Nc.NcDialects.IsFile(settings.Machines[i].Dialect))
                Check(root["machines"].Items[i]["dialect"], "the dialect", settings.Machines[i].Dialect);
        }

        if (settings.Store is SqliteSettings { File: var store } && Path.GetDirectoryName(store) is { } folder)
        {
            var item = root["store"].Find("file") ?? root["store"];
            foreach (var file in new[] { store, store + "-wal" }.Where(File.Exists))
                Check(item, "the store", file);
            Refuse(item, "the store", WriteRights.OfEverybodyInside(Existing(folder)));
            Warn(item, "the store", WriteRights.OfGroup(Existing(folder)));
        }

        if (settings.Store is PostgresSettings { PasswordFile: { } secret })
            Check(root["store"].Find("passwordFile") ?? root["store"], "the store's password", secret);
    }

    private void Check(JsonItem item, string what, string path)
    {
        Refuse(item, what, WriteRights.OfEverybody(path));
        Warn(item, what, WriteRights.OfGroup(path));
    }

    private void Refuse(JsonItem item, string what, string? path)
    {
        if (path is not null && _said.Add(path))
            problems.Refuse(
                item,
                "writable-by-everybody",
                $"{path}, which everybody on this computer may write, and by it change {what}",
                $"a file and folders that nobody else may write: chmod o-w {path}");
    }

    private void Warn(JsonItem item, string what, string? path)
    {
        if (path is not null && _said.Add(path))
            problems.Warn(
                item,
                "writable-by-group",
                $"{path}, which a group may write, and by it change {what}",
                $"a group whose members may all decide what is cut, or: chmod g-w {path}");
    }

    // A folder that is not there yet is made with the rights of the one that it is made in.
    private static string Existing(string folder)
    {
        while (!Directory.Exists(folder) && Path.GetDirectoryName(folder) is { } outer)
            folder = outer;
        return folder;
    }
}
