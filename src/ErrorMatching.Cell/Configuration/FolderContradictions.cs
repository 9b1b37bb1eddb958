using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Finds folders and files that the cell would use for conflicting purposes: to take from, write to or delete in.</summary>
internal sealed class FolderContradictions(JsonItem root, CellSettings settings, CellProblems problems)
{
    private const StringComparison NoCase = StringComparison.OrdinalIgnoreCase;

    /// <summary>Finds them all.</summary>
    /// <param name="own">The absolute path of the configuration.</param>
    /// <param name="jobs">The jobs and the files that they name.</param>
    public void Find(string own, IReadOnlyList<(JsonItem Item, CellJobSettings Settings, NamedJob? Job)> jobs)
    {
        CheckGauges();
        CheckMachines();
        CheckOwn();
        CheckTaken(root, "the configuration", own);
        foreach (var (item, job, named) in jobs)
        {
            string?[] files = [job.File, job.Program, .. named?.Files ?? []];
            foreach (var file in files.OfType<string>().Distinct(StringComparer.Ordinal))
            {
                CheckTaken(item["job"], $"the file {file} of the job \"{job.Name}\"", file);
            }

            CheckBase(item.Find("program") ?? item["job"], job.Program ?? named?.Program);
        }
    }

    private IEnumerable<(JsonItem Item, MachineSettings Machine, string Folder)> FoldersOfMachines =>
        settings.Machines.Select(
            (m, i) => (Item: root["machines"].Items[i], Machine: m, Folder: m.Transport.LocalFolder)).Where(m => m.Folder is not null)!;

    private void CheckGauges()
    {
        for (var i = 0; i < settings.Gauges.Count; i++)
        {
            var (item, gauge) = (root["gauges"].Items[i], settings.Gauges[i]);
            if (settings.Gauges.Take(i).FirstOrDefault(
                g => IsSameSource(g, gauge) && FileNamePattern.Overlap(g.Files, gauge.Files)) is { } other)
            {
                problems.Refuse(
                    item["files"],
                    "overlapping-files",
                    $"\"{gauge.Files}\" beside \"{other.Files}\" of \"{other.Name}\" in one folder",
                    "patterns that no file's name fits both");
            }

            if (gauge.Machine is not null)
            {
                CheckLog(item, gauge);
            }
        }
    }

    private void CheckLog(JsonItem item, GaugeSettings gauge)
    {
        if (settings.Machines.FirstOrDefault(m => m.Name == gauge.Machine) is not { } machine)
        {
            problems.Refuse(
                item["machine"], "unknown-machine", $"the machine \"{gauge.Machine}\"", Names.Of(settings.Machines.Select(m => m.Name)));
        }
        else if (machine.Slots.SelectMany(
            s => new[] { s.Program, s.ReadyFile }.OfType<string>()).FirstOrDefault(n => FileNamePattern.Fits(gauge.Files, n)) is { } taken)
        {
            problems.Refuse(
                item["files"],
                "files-of-slot",
                $"\"{gauge.Files}\", which the slots' file {taken} fits",
                "a pattern that no slot's program or ready file fits");
        }
    }

    private void CheckMachines()
    {
        for (var i = 0; i < settings.Machines.Count; i++)
        {
            var machine = settings.Machines[i];
            if (settings.Machines.Take(i).FirstOrDefault(m => m.Transport.IsSamePlace(machine.Transport)) is { } other)
            {
                problems.Refuse(
                    root["machines"].Items[i]["transport"],
                    "folder-of-two-machines",
                    $"the folder of {other.Name} again",
                    "a folder of this machine alone");
            }
        }

        foreach (var (item, machine, folder) in FoldersOfMachines)
        {
            for (var g = 0; g < settings.Gauges.Count; g++)
            {
                if (settings.Gauges[g].Incoming is { } incoming
                    && (CellPaths.IsInside(incoming, folder) || CellPaths.IsInside(folder, incoming)))
                {
                    problems.Refuse(
                        root["gauges"].Items[g]["incoming"],
                        "incoming-at-machine",
                        $"{incoming} beside {folder} of {machine.Name}",
                        "two folders of which none lies in the other");
                }
            }
        }
    }

    private void CheckOwn()
    {
        Check(root["store"].Find("file") ?? root["store"], "the store", (settings.Store as SqliteSettings)?.File);
        Check(
            root["store"].Find("passwordFile") ?? root["store"], "the password's file", (settings.Store as PostgresSettings)?.PasswordFile);
        Check(root.Find("events")?.Find("passwordFile") ?? root, "the broker's password", settings.Events?.PasswordFile);
        Check(root.Find("events")?.Find("caFile") ?? root, "the broker's authorities", settings.Events?.AuthorityFile);
        Check(root.Find("keys") ?? root, "the folder of keys", settings.KeysFolder);
        Check(root["store"].Find("archives") ?? root["store"], "the folder of archives", settings.Store.Archives);
        Check(root.Find("logs") ?? root, "the folder of logs", settings.LogFolder);
        for (var i = 0; i < settings.Machines.Count; i++)
        {
            Check(
                root["machines"].Items[i]["transport"].Find("keyFile") ?? root,
                "the login's key",
                settings.Machines[i].Transport.SignInKey);
            Check(
                root["machines"].Items[i].Find("state")?.Find("file") ?? root,
                "the file with the machine's state",
                settings.Machines[i].State?.LocalFile);
        }
    }

    private void Check(JsonItem item, string what, string? path)
    {
        if (path is null)
        {
            return;
        }

        if (settings.Gauges.FirstOrDefault(g => g.Incoming is { } incoming && CellPaths.IsInside(path, incoming)) is { } gauge)
        {
            problems.Refuse(
                item, "inside-incoming", $"{what} in {gauge.Incoming}, where files of \"{gauge.Name}\" arrive", "a place outside of it");
        }

        if (FoldersOfMachines.FirstOrDefault(m => CellPaths.IsInside(path, m.Folder)) is { Machine: { } machine, Folder: { } folder })
        {
            problems.Refuse(item, "inside-machine", $"{what} in {folder}, the programs' folder of {machine.Name}", "a place outside of it");
        }
    }

    private void CheckTaken(JsonItem item, string what, string file)
    {
        if (settings.Gauges.FirstOrDefault(
            g => g.Incoming is { } incoming
                && CellPaths.AreSame(incoming, Path.GetDirectoryName(file) ?? "")
                && FileNamePattern.Fits(g.Files, Path.GetFileName(file))) is { } gauge)
        {
            problems.Refuse(
                item,
                "input-taken",
                $"{what}, which \"{gauge.Name}\" would take as a measurement",
                "another folder, or a pattern of the gauge that its name does not fit");
        }
    }

    private void CheckBase(JsonItem item, string? program)
    {
        if (program is not null
            && FoldersOfMachines.FirstOrDefault(
                m => CellPaths.AreSame(Path.GetDirectoryName(program) ?? "", m.Folder)
                    && m.Machine.Slots.Any(s => s.Program.Equals(Path.GetFileName(program), NoCase))).Machine is { } machine)
        {
            problems.Refuse(
                item,
                "original-at-machine",
                $"{program} as the original, which the cell would overwrite at {machine.Name}",
                "the original in a folder of its own: every correction starts from it");
        }
    }

    private static bool IsSameSource(GaugeSettings a, GaugeSettings b) =>
        a.Incoming is { } x && b.Incoming is { } y ? CellPaths.AreSame(x, y) : a.Machine is not null && a.Machine == b.Machine;
}
