using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <summary>Reads the machines of a configuration.</summary>
internal sealed class MachineReader(JsonItem list, CellPaths paths, CellProblems problems)
{
    public IReadOnlyList<(JsonItem Item, MachineSettings Settings)> Read()
    {
        Names.RefuseTwins(list.Items, "name", "duplicate-name", "machine", problems);
        return [.. list.Items.Select(i => (i, Read(i)))];
    }

    private MachineSettings Read(JsonItem item) => new()
    {
        Name = item["name"].Text,
        Dialect = ReadDialect(item["dialect"]),
        Transport = TransportKinds.Read(item["transport"], paths, problems),
        Slots = ReadSlots(item["slots"], NamingOf(item["dialect"].Text)),
        Timeout = TimeSpan.FromSeconds(item.Find("timeoutS")?.Number ?? 30),
        State = item.Find("state") is { } state ? StateKinds.Read(state, paths, problems) : null,
        Attempts = (int)(item.Find("attempts")?.Number ?? 3),
    };

    private string ReadDialect(JsonItem item)
    {
        if (!NcDialects.IsFile(item.Text))
        {
            if (!NcDialects.IsName(item.Text))
            {
                problems.Refuse(
                    item,
                    "unknown-dialect",
                    $"the dialect \"{item.Text}\"",
                    NcDialects.ExpectedInsteadOf(item.Text));
            }

            return item.Text;
        }

        var file = paths.Of(item);
        try
        {
            _ = NcDialects.Read(file);
        }
        catch (InputException e)
        {
            problems.AddRange(FileProblems.Of(item, e.Refusals));
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            problems.AddRange([FileProblems.Unreadable(item, "dialect-missing", file, e)]);
        }

        return file;
    }

    // A dialect that cannot be read is reported by itself.
    private ProgramNaming NamingOf(string dialect)
    {
        try
        {
            return InputFile.Dialect(NcDialects.IsFile(dialect) ? paths.Of(dialect) : dialect).ProgramNaming;
        }
        catch (InputException)
        {
            return ProgramNaming.ByFile;
        }
    }

    private List<SlotSettings> ReadSlots(JsonItem slots, ProgramNaming naming)
    {
        Names.RefuseTwins(slots.Items, "name", "duplicate-name", "slot", problems);
        Names.RefuseTwins(slots.Items, "program", "program-of-two-slots", "program", problems);
        Names.RefuseTwins(slots.Items, "readyFile", "ready-file-of-two-slots", "ready file", problems);
        RefuseSameNumbers([.. slots.Items.Select(s => s["program"])], naming);
        var programs = slots.Items.Select(s => s["program"].Text).ToHashSet(StringComparer.OrdinalIgnoreCase);
        foreach (var slot in slots.Items)
        {
            RefuseBadName(slot["program"]);
            if (slot.Find("readyFile") is not { } ready)
            {
                continue;
            }

            RefuseBadName(ready);
            if (programs.Contains(ready.Text))
            {
                problems.Refuse(
                    ready,
                    "ready-file-is-program",
                    $"the program \"{ready.Text}\" as a ready file",
                    "a name that no slot's program has: the cell deletes a ready file");
            }
        }

        return [.. slots.Items.Select(s => new SlotSettings(s["name"].Text, s["program"].Text, s.Find("readyFile")?.Text))];
    }

    // To the control, O100.NC and 0100.NC are one program.
    private void RefuseSameNumbers(JsonItem[] programs, ProgramNaming naming)
    {
        for (var i = 1; i < programs.Length; i++)
        {
            if (programs.Take(i).FirstOrDefault(
                p => !p.Text.Equals(programs[i].Text, StringComparison.OrdinalIgnoreCase)
                    && new ProgramIdentity(p.Text, naming).SharedWith(new(programs[i].Text, naming)) is not null) is { } before)
            {
                problems.Refuse(
                    programs[i],
                    "program-of-two-slots",
                    $"the program \"{programs[i].Text}\", which the control cannot tell from \"{before.Text}\" of another slot",
                    "a name or number that no other has");
            }
        }
    }

    private void RefuseBadName(JsonItem item)
    {
        if (!ProgramNames.Allows(item.Text))
        {
            problems.Refuse(item, "bad-program-name", $"the name \"{item.Text}\"", ProgramNames.Rule);
        }
    }
}
