using ErrorMatching.Json;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <summary>Reads the jobs of a configuration, with the files that they name.</summary>
internal sealed class CellJobReader(
    JsonItem list,
    CellPaths paths,
    CellProblems problems,
    IReadOnlyList<(JsonItem Item, GaugeSettings Settings)> gauges,
    IReadOnlyList<(JsonItem Item, MachineSettings Settings)> machines)
{
    public IReadOnlyList<(JsonItem Item, CellJobSettings Settings, NamedJob? Job)> Read(
        PolicySettings cell, Func<JsonItem, PolicySettings> policy)
    {
        Names.RefuseTwins(list.Items, "name", "duplicate-name", "job", problems);
        (JsonItem Item, CellJobSettings Settings, NamedJob? Job)[] jobs = [.. list.Items.Select(i => Read(i, cell, policy))];
        new OffsetJobs(problems).Check(jobs);
        return jobs;
    }

    private (JsonItem Item, CellJobSettings Settings, NamedJob? Job) Read(
        JsonItem item, PolicySettings cell, Func<JsonItem, PolicySettings> policy)
    {
        var file = paths.Of(item["job"]);
        var job = ReadJob(item["job"], file);
        var patterns = new RecognitionReader(item["recognize"], problems);
        var settings = new CellJobSettings
        {
            Name = item["name"].Text,
            File = file,
            IsFreeform = job?.Freeform is not null,
            Piece = item.Find("piece")?.Text
                ?? (job is null || job.Decides ? null : job.Freeform is not null ? PieceWords.Surface
                    : job.IsFeedback ? PieceWords.Counterpart : PieceWords.Part),
            Gauges = [.. item["gauges"].Items.Select(g => g.Text).Distinct(StringComparer.Ordinal)],
            Recognize = patterns.Read(),
            Machine = item["machine"].Text,
            Slot = item["slot"].Text,
            InOrderOfSerial = item.Find("order")?.Text == "serial",
            Accumulates = item.Find("accumulates")?.Flag ?? false,
            Program = item.Find("program") is { } program ? paths.Of(program) : null,
            Policy = item.Find("policy") is { } own ? policy(own) : null,
        };
        CheckNames(item);
        if (settings.InOrderOfSerial && !patterns.HasSerial)
        {
            problems.Refuse(
                item["order"],
                "serial-missing",
                "pieces in order of serial numbers that no pattern reads",
                "a group (?<serial>...) in one of the patterns, or \"arrival\"");
        }

        if (job is not null)
        {
            CheckKind(item, settings, job);
            CheckSums(item, settings, job, settings.Policy ?? cell);
        }

        return (item, settings, job);
    }

    private NamedJob? ReadJob(JsonItem item, string file)
    {
        try
        {
            return NamedJob.Read(file);
        }
        catch (InputException e)
        {
            problems.AddRange(FileProblems.Of(item, e.Refusals));
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            problems.AddRange([FileProblems.Unreadable(item, "job-missing", file, e)]);
        }

        return null;
    }

    private void CheckNames(JsonItem item)
    {
        foreach (var name in item["gauges"].Items.Where(n => gauges.All(g => g.Settings.Name != n.Text)))
        {
            problems.Refuse(name, "unknown-gauge", $"the gauge \"{name.Text}\"", Names.Of(gauges.Select(g => g.Settings.Name)));
        }

        var (machineName, slot) = (item["machine"], item["slot"]);
        if (machines.FirstOrDefault(m => m.Settings.Name == machineName.Text).Settings is not { } machine)
        {
            problems.Refuse(
                machineName, "unknown-machine", $"the machine \"{machineName.Text}\"", Names.Of(machines.Select(m => m.Settings.Name)));
        }
        else if (machine.Slots.All(s => s.Name != slot.Text))
        {
            problems.Refuse(
                slot,
                "unknown-slot",
                $"the slot \"{slot.Text}\"",
                $"a slot of {machine.Name}: {Names.Of(machine.Slots.Select(s => s.Name))}");
        }
    }

    private void CheckKind(JsonItem item, CellJobSettings settings, NamedJob job)
    {
        var machine = machines.FirstOrDefault(m => m.Settings.Name == settings.Machine).Settings;
        if (machine is not null && IsKnown(machine.Dialect) && !CellPaths.AreSame(machine.Dialect, job.Dialect))
        {
            problems.Refuse(
                item["job"],
                "other-dialect",
                $"a job for the dialect {job.Dialect}",
                $"one for {machine.Dialect}, which {machine.Name} has");
        }

        if (job.Mating is { Correction.AllowsOffsets: true })
        {
            OffsetJobs.Check(item, settings, job, machine, problems);
        }

        if (item.Find("piece") is { } piece)
        {
            CheckPiece(piece, job);
        }

        foreach (var (name, gauge) in item["gauges"].Items.Select(
            n => (n, gauges.FirstOrDefault(g => g.Settings.Name == n.Text).Settings)).Where(g => g.Settings is not null))
        {
            if (job.Mating is not null && gauge.Format is null)
            {
                problems.Refuse(
                    name, "log-for-mating", $"the probing logs of \"{gauge.Name}\" for a mating job", "a gauge whose files are tables");
            }

            CheckPatterns(item["recognize"], gauge);
            if (gauge.Machine is not null && gauge.Machine != settings.Machine)
            {
                problems.Warn(
                    name,
                    "other-machine",
                    $"a log of {gauge.Machine} for a program of {settings.Machine}",
                    "a piece that stays on the machine that measured it, unless it is moved on purpose");
            }
        }

        if (item.Find("program") is { } program && job.Mating is not null)
        {
            problems.Refuse(
                program, "program-for-mating", "a program for a mating job", "no such key: a mating job names its program itself");
        }
    }

    // An unknown dialect is reported once, at its machine.
    private static bool IsKnown(string dialect) => NcDialects.IsFile(dialect) || NcDialects.Names.Contains(dialect, StringComparer.Ordinal);

    // A pattern for something that a gauge's files do not have would never match.
    private void CheckPatterns(JsonItem recognize, GaugeSettings gauge)
    {
        if (recognize.Find("column") is { } column && gauge.Format is null)
        {
            problems.Refuse(
                column, "column-of-log", $"a column of the probing logs of \"{gauge.Name}\"", "\"headerField\": a log has no columns");
        }

        if (recognize.Find("headerField") is { } field && gauge.Format is { SkipLines: 0 })
        {
            problems.Refuse(
                field,
                "no-header-fields",
                $"a header field of \"{gauge.Name}\", whose format has no lines above the table",
                "a format with \"skipLines\"");
        }
    }

    private void CheckPiece(JsonItem piece, NamedJob job)
    {
        if (piece.Text == PieceWords.Surface != job.Freeform is not null)
        {
            problems.Refuse(
                piece,
                "piece-of-other-kind",
                $"\"{piece.Text}\" for a {(job.Freeform is not null ? "free-form" : "mating")} job",
                job.Freeform is not null ? "\"surface\"" : "\"part\" or \"counterpart\"");
        }
        else if (job.Decides)
        {
            problems.Refuse(
                piece,
                "piece-decided-twice",
                "a piece beside the job's own rules, which say whose each file is",
                "no such key, or a job without the key \"recognition\"");
        }
    }

    private void CheckSums(JsonItem item, CellJobSettings settings, NamedJob job, PolicySettings policy)
    {
        if (!settings.Accumulates)
        {
            return;
        }

        if (!job.IsFeedback && job.Freeform is null)
        {
            problems.Refuse(
                item["accumulates"],
                "accumulates-without-feedback",
                "corrections that add up in a job without feedback",
                "a mating job whose compensation comes from the counterpart, a free-form job, or false");
        }
        else if (policy.SumLimitMm is null)
        {
            problems.Refuse(
                item["accumulates"],
                "sum-limit-missing",
                "corrections that add up without a limit",
                "\"sumLimitMm\" in the policy of the job or of the cell");
        }
    }
}
