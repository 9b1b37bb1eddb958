using ErrorMatching.Json;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <summary>Reads the gauges of a configuration.</summary>
internal sealed class GaugeReader(JsonItem list, CellPaths paths, CellProblems problems)
{
    public const string ProbingLog = "probing-log";

    public IReadOnlyList<(JsonItem Item, GaugeSettings Settings)> Read()
    {
        Names.RefuseTwins(list.Items, "name", "duplicate-name", "gauge", problems);
        return [.. list.Items.Select(i => (i, Read(i)))];
    }

    private GaugeSettings Read(JsonItem item)
    {
        var (incoming, machine) = (item.Find("incoming"), item.Find("machine"));
        if (incoming is null && machine is null)
        {
            problems.Refuse(item, "source-missing", "neither a folder nor a machine", "the key \"incoming\" or the key \"machine\"");
        }
        else if (incoming is not null && machine is not null)
        {
            problems.Refuse(machine, "source-twice", "a machine beside a folder", "\"incoming\" or \"machine\", not both");
        }

        if (item.Find("keep") is { } keep && machine is null)
        {
            problems.Refuse(
                keep,
                "keep-without-machine",
                "\"keep\" for a folder",
                "no such key: what arrives in a folder is always taken from it once it is archived");
        }

        var format = ReadFormat(item.Find("format"));
        return new()
        {
            Name = item["name"].Text,
            Incoming = incoming is null ? null : paths.Of(incoming),
            Machine = machine?.Text,
            Files = item["files"].Text,
            Finished = ReadFinished(item.Find("finished"), machine is not null, format is null),
            Format = format,
            MostBytes = (long)((item.Find("mostMB")?.Number ?? 16) * 1e6),
            Every = TimeSpan.FromMilliseconds(item.Find("everyMs")?.Number ?? (machine is null ? 200 : 2000)),
            WaitLimit = TimeSpan.FromMinutes(item.Find("waitLimitMin")?.Number ?? 10),
            KeepsFile = item.Find("keep")?.Flag ?? true,
        };
    }

    private FinishedRule ReadFinished(JsonItem? item, bool isAtMachine, bool isLog)
    {
        if (item is null)
        {
            // A control takes longer from one point to the next than a file must be at rest.
            return isAtMachine && isLog ? new FinishedByEndMark("END") : new FinishedAtRest(TimeSpan.FromSeconds(2));
        }

        if (item.Kind == JsonItemKind.Text)
        {
            if (isAtMachine)
            {
                problems.Refuse(
                    item,
                    "finished-at-machine",
                    "\"rename\" for a machine's log",
                    "{ \"atRestS\": ... } or { \"endMark\": ... }: a control writes its log under the log's own name");
            }

            return new FinishedByRename();
        }

        if (item.Members.Count != 1)
        {
            problems.Refuse(
                item,
                "finished-rules",
                item.Members.Count == 0 ? "no rule" : $"{item.Members.Count} rules",
                "one of \"marker\", \"atRestS\" and \"endMark\"");
            return new FinishedByRename();
        }

        var (name, value) = (item.Members[0].Name, item.Members[0].Value);
        if (name == "marker" && isAtMachine)
        {
            problems.Refuse(value, "finished-at-machine", "a marker for a machine's log", "{ \"atRestS\": ... } or { \"endMark\": ... }");
        }

        if (name == "endMark" && value.Text.Trim() != value.Text)
        {
            problems.Refuse(
                value, "end-mark-spaces", "a mark with spaces around it", "the mark alone: spaces around the last line do not count");
        }

        return name switch
        {
            "marker" => new FinishedByMarker(value.Text),
            "endMark" => new FinishedByEndMark(value.Text),
            _ => new FinishedAtRest(TimeSpan.FromSeconds(value.Number)),
        };
    }

    private MeasurementFormat? ReadFormat(JsonItem? item)
    {
        if (item is null)
        {
            return MeasurementFormat.Points;
        }

        if (item.Kind == JsonItemKind.Text && item.Text == ProbingLog)
        {
            return null;
        }

        var found = new List<Refusal>();
        var format = MeasurementFormat.Read(item, found);
        problems.AddRange(item.Kind == JsonItemKind.Text ? found.Select(NameOfFormat) : found);
        return format ?? MeasurementFormat.Points;

        // A cell also reads the log of a probing program, which is no table.
        Refusal NameOfFormat(Refusal problem) => JsonRefusal.At(
            item,
            problem.Code,
            problem.Found,
            "\"points\", \"feature-table\", \"grid\", \"recognized\", \"probing-log\", or an object that describes a table");
    }
}
