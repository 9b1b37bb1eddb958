using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <summary>Checks the jobs whose corrections are offsets of the control. Their slots get programs that set offsets, and nothing
/// else.</summary>
internal sealed class OffsetJobs(CellProblems problems)
{
    /// <summary>Checks a job that allows an offset.</summary>
    /// <param name="item">Its part of the configuration.</param>
    /// <param name="settings">Its settings.</param>
    /// <param name="job">Its file.</param>
    /// <param name="machine">Its machine; null if unknown.</param>
    /// <param name="problems">Receives the problems.</param>
    public static void Check(JsonItem item, CellJobSettings settings, NamedJob job, MachineSettings? machine, CellProblems problems)
    {
        if (job.Mating!.Correction.Allows(CorrectionKind.Blocks))
        {
            problems.Refuse(
                item["job"],
                "offsets-in-cell",
                "a job whose correction may be an offset of the control or blocks, as each piece needs it",
                "\"allow\" with offsets alone or with blocks alone: a slot gets one kind of program");
        }

        if (job.IsFeedback && !settings.Accumulates)
        {
            problems.Refuse(
                item["job"],
                "offsets-accumulate",
                "a job in feedback by offsets that does not accumulate",
                "\"accumulates\": true, because the control keeps the offset that cut the piece, and the next one adds to it");
        }

        var slot = machine?.Slots.FirstOrDefault(s => s.Name == settings.Slot);
        if (slot is not null && string.Equals(slot.Program, Path.GetFileName(job.Program), StringComparison.OrdinalIgnoreCase))
        {
            problems.Refuse(
                item["slot"],
                "offsets-over-program",
                $"the slot \"{slot.Name}\", whose program {slot.Program} has the name of the program that cuts",
                "a slot with another program name: it gets the program of the offsets, and the one that cuts stays as it is");
        }

        if (slot is not null && DialectOf(job) is { } dialect && OffsetProgram.FileToCall(dialect, slot.Program) is { } wanted
            && wanted != slot.Program)
        {
            problems.Warn(
                item["slot"],
                "offsets-not-callable",
                $"the slot \"{slot.Name}\" with the program {slot.Program}, which another program of this control cannot call",
                $"the name {wanted}, unless the operator runs the program of the offsets by itself");
        }
    }

    /// <summary>Checks which slots and variables of a control several jobs share.</summary>
    /// <param name="jobs">All jobs, in order.</param>
    public void Check(IReadOnlyList<(JsonItem Item, CellJobSettings Settings, NamedJob? Job)> jobs)
    {
        for (var i = 0; i < jobs.Count; i++)
        {
            var (item, settings, job) = jobs[i];
            foreach (var (_, before, other) in jobs.Take(i).Where(j => j.Settings.Machine == settings.Machine))
            {
                if (job is null || other is null)
                {
                    continue;
                }

                if (before.Slot == settings.Slot && IsByOffset(job) != IsByOffset(other))
                {
                    problems.Refuse(
                        item["slot"],
                        "slot-of-both",
                        $"the slot \"{settings.Slot}\" for programs that set offsets and, by \"{before.Name}\", for programs that cut",
                        "a slot of its own for each of the two kinds");
                }

                if (IsByOffset(job) && IsByOffset(other) && before.File != settings.File)
                {
                    CheckVariables(item, before.Name, job.Mating!.Correction.FirstVariable, other.Mating!.Correction.FirstVariable);
                }
            }
        }
    }

    private void CheckVariables(JsonItem item, string before, int first, int other)
    {
        if (first != other && Math.Abs(first - other) < OffsetProgram.Variables)
        {
            problems.Refuse(
                item["job"],
                "offset-variables-overlap",
                $"variables of the control from {first} on, which overlap those of \"{before}\" from {other} on",
                $"the same \"firstVariable\" if both correct the same offset, or one at least {OffsetProgram.Variables} away");
        }
        else
        {
            problems.Warn(
                item["job"],
                "offsets-of-one-control",
                $"offsets of a control that \"{before}\" sets, too, with {(first == other ? "the same" : "other")} variables",
                first == other
                    ? "the same variables only if both jobs correct the same offset"
                    : "other variables only if the jobs correct different offsets: otherwise a correction of one stays in for the other");
        }
    }

    // A dialect that cannot be read is reported at its machine.
    private static NcDialect? DialectOf(NamedJob job)
    {
        try
        {
            return NcDialects.IsFile(job.Dialect) ? NcDialects.Read(job.Dialect) : NcDialects.Named(job.Dialect);
        }
        catch (Exception e) when (e is InputException or IOException or UnauthorizedAccessException)
        {
            return null;
        }
    }

    private static bool IsByOffset(NamedJob job) => job.Mating is { Correction.AllowsOffsets: true };
}
