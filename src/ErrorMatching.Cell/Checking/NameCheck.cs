using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <summary>Examines what the controls would call the programs of jobs: each must be the file of its slot by name and number, and nothing
/// else at its machine.</summary>
internal sealed class NameCheck(CellSettings settings, IReadOnlyList<CheckedMachine> machines)
{
    private readonly JobPrograms _programs = new(settings);

    /// <summary>Adds what is wrong with the names of a job's programs.</summary>
    public CheckedJob Of(CheckedJob job)
    {
        var machine = machines.First(m => m.Machine.Name == job.Job.Machine);
        Refusal[] wrong = [.. _programs.Of(machine.Machine, job.Job).SelectMany(p => Wrong(machine, job, p))];
        return wrong.Length == 0 ? job : job with { Problem = new([.. job.Problem?.Errors ?? [], .. wrong]) };
    }

    private IEnumerable<Refusal> Wrong(CheckedMachine machine, CheckedJob job, JobProgram program)
    {
        var (own, at) = (program.Program, program.File ?? job.Job.File);
        var place = program.Slot is { } slot ? $"{slot.Program}, the file of slot {slot.Name} of {machine.Machine.Name}" : own.File;
        if (own.OtherHead is { } head)
        {
            yield return Named(at, $"the program is {head} at its head, and goes to {place}: the control would call it {head}, whatever "
                + "the file is called. Give both the same name or number.");
        }
        else if (program.File is { } file && IsNumber(Path.GetFileName(file))
            && new ProgramIdentity(Path.GetFileName(file), own.Naming, own.Heads).OtherHead is { } other)
        {
            yield return Named(at, $"the file has the number of another program than {other} at its head. Give both the same number, or "
                + "the file a name without a number.");
        }

        foreach (var taken in _programs.Of(machine.Machine).Where(p => p.Program != own && !IsSameSlot(p, program)))
        {
            if (own.SharedWith(taken.Program) is { } name)
            {
                yield return Taken(at, $"the control would call the program for {place} by {name}, and so it calls "
                    + (taken.Slot is { } other ? $"the program of slot {other.Name}, {other.Program}" : $"the program {taken.Program.File}")
                    + $", of the job \"{taken.Job.Name}\". Give each program a name and a number of its own.");
            }
        }

        foreach (var other in machine.Machine.Slots.Where(s => s.Name != program.Slot?.Name))
        {
            if (own.SharedWith(new(other.Program, own.Naming)) is { } name)
            {
                yield return Taken(at, $"the control would call the program for {place} by {name}, which is the name of {other.Program}, "
                    + $"the file of slot {other.Name}. Give each program a name and a number of its own.");
            }
        }

        if (program.Slot is not null && own.Naming != ProgramNaming.ByFile && machine.Names is { } names
            && MachinePrograms.OtherFile(machine.Machine, own, names) is { } found)
        {
            var name = own.Heads.Count > 0 ? own.Heads[0] : own.File;
            yield return Taken(at, $"the control would call the program for {place} by {name}, and the file {found} at the machine has "
                + "that name, too. Look which of them is meant, and remove or rename the other.");
        }
    }

    // Several jobs may share a slot, and a slot with offsets has the program that cuts beside it.
    private static bool IsSameSlot(JobProgram one, JobProgram other) => one.Slot?.Name == other.Slot?.Name
        && (one.Slot is not null || CellPaths.AreSame(one.File!, other.File!));

    private static bool IsNumber(string file) => file.Length > 1 && file[0] is 'O' or 'o' && ActiveProgram.NumberOf(file).Length > 0;

    private static Refusal Named(string file, string message) => new(CellCodes.NamedOtherwise, message, new() { File = file });

    private static Refusal Taken(string file, string message) => new(CellCodes.NameTaken, message, new() { File = file });
}
