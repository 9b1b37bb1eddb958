using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Whether a program may go to its slot by what the control would call it: it must be the slot's file by name and number, and
/// nothing else at the machine.</summary>
/// <param name="flow">State shared by the workers.</param>
/// <param name="place">The slot.</param>
/// <param name="jobs">The programs of the machine's jobs.</param>
internal sealed class SlotNames(CellFlow flow, SlotPlace place, JobPrograms jobs)
{
    /// <summary>Why a program must not be sent.</summary>
    /// <param name="approved">The correction to send.</param>
    /// <param name="found">The program in the slot; null if the slot is empty.</param>
    /// <param name="hash">Its SHA-256; null if the slot is empty.</param>
    /// <param name="cancellation">Cancels immediately.</param>
    /// <returns>A stable code and a sentence; null if it may be sent.</returns>
    /// <exception cref="TransportException">The machine's folder cannot be listed.</exception>
    public async Task<(string Code, Statement Why)?> WhyNotAsync(
        Correction approved, byte[]? found, string? hash, CancellationToken cancellation)
    {
        var program = MachinePrograms.Identify(place.Machine, place.Slot.Program, [flow.Store.Content(approved.ProgramSha256!)]);
        if (program.OtherHead is { } head)
            return (CellCodes.NamedOtherwise, Recorded.NamedOtherwise.With(place.Slot.Program, place.Machine.Name, head));

        // A person who was told so and approved again means it.
        if (found is not null && hash != approved.PreviousSha256
            && MachinePrograms.Identify(place.Machine, place.Slot.Program, [MachinePrograms.Content(found)])
                is { Heads: [var before, ..] } there
            && program.Heads is [var now, ..] && !there.Heads.Any(h => program.Heads.Any(p => ActiveProgram.IsSame(h, p))))
            return (CellCodes.NamedOtherwise, Recorded.NamedOtherwiseThere.With(place.Slot.Program, place.Machine.Name, before, now));
        return OfOthers(program) ?? await OfFilesAsync(program, cancellation);
    }

    private (string Code, Statement Why)? OfOthers(ProgramIdentity program)
    {
        foreach (var other in place.Machine.Slots.Where(s => s.Name != place.Slot.Name))
        {
            if (program.SharedWith(MachinePrograms.Identify(place.Machine, other.Program, [])) is { } name)
                return (CellCodes.NameTaken, Recorded.NameOfSlot.With(place.Slot.Program, place.Machine.Name, name, other.Name));
        }

        foreach (var other in jobs.Of(place.Machine).Where(j => j.Slot?.Name != place.Slot.Name))
        {
            if (program.SharedWith(other.Program) is { } name)
                return (CellCodes.NameTaken, other.Slot is { } taken
                    ? Recorded.NameOfSlot.With(place.Slot.Program, place.Machine.Name, name, taken.Name)
                    : Recorded.NameOfJob.With(place.Slot.Program, place.Machine.Name, name, other.Program.File, other.Job.Name));
        }

        return null;
    }

    private async Task<(string Code, Statement Why)?> OfFilesAsync(ProgramIdentity program, CancellationToken cancellation)
    {
        if (program.Naming == Nc.ProgramNaming.ByFile)
            return null;
        var names = await place.Folder.ListAsync(cancellation);
        if (MachinePrograms.OtherFile(place.Machine, program, names) is not { } file)
            return null;
        var name = program.Heads.Count > 0 ? program.Heads[0] : place.Slot.Program;
        return (CellCodes.NameTaken, Recorded.NameOfFile.With(place.Slot.Program, place.Machine.Name, name, file));
    }
}
