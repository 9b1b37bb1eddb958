using System.Collections.Concurrent;
using ErrorMatching.Jobs;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <summary>What the control of a machine will call the programs of its jobs, as far as their files say it.</summary>
/// <remarks>A file is read again when it has changed.</remarks>
internal sealed class JobPrograms(CellSettings settings)
{
    private readonly ConcurrentDictionary<string, (string Stamp, JobProgram[] Programs)> _known = new(StringComparer.Ordinal);

    /// <summary>The programs of the jobs of a machine. Jobs that cannot be read have none; their own measurements report it.</summary>
    public IEnumerable<JobProgram> Of(MachineSettings machine) =>
        settings.Jobs.Where(j => j.Machine == machine.Name).SelectMany(j => Of(machine, j));

    /// <summary>The programs of a job: the one in its slot, and the one that cuts if the slot has offsets for it.</summary>
    public IReadOnlyList<JobProgram> Of(MachineSettings machine, CellJobSettings job)
    {
        try
        {
            var named = NamedJob.Read(job.File);
            var program = job.Program ?? named.Program;
            var stamp = $"{Stamp(job.File)} {program} {(program is null ? "" : Stamp(program))}";
            return _known.TryGetValue(job.Name, out var known) && known.Stamp == stamp
                ? known.Programs
                : (_known[job.Name] = (stamp, [.. Read(machine, job, named, program)])).Programs;
        }
        catch (Exception e) when (e is InputException or IOException or UnauthorizedAccessException)
        {
            return [];
        }
    }

    private static IEnumerable<JobProgram> Read(MachineSettings machine, CellJobSettings job, NamedJob named, string? program)
    {
        var slot = machine.Slots.FirstOrDefault(s => s.Name == job.Slot);
        ReadOnlyMemory<byte>? bytes = program is null ? null : InputFile.Program(program);
        var isByOffsets = named.Mating is { Correction.AllowsOffsets: true };
        if (isByOffsets && slot is not null)
        {
            var dialect = InputFile.Dialect(machine.Dialect);
            var heads = OffsetProgram.HeadsOf(dialect, slot.Program, named.Mating!.Correction.ProgramNumber);
            yield return new(job, slot, program, new(slot.Program, dialect.ProgramNaming, heads));
        }

        if (program is not null && (isByOffsets || slot is not null))
        {
            yield return new(
                job, isByOffsets ? null : slot, program,
                MachinePrograms.Identify(machine, isByOffsets ? Path.GetFileName(program) : slot!.Program, [bytes]));
        }
    }

    private static string Stamp(string file) => FormattableString.Invariant(
        $"{File.GetLastWriteTimeUtc(file).Ticks}-{(File.Exists(file) ? new FileInfo(file).Length : -1)}");
}

/// <summary>A program of a job at a machine.</summary>
/// <param name="Job">The job.</param>
/// <param name="Slot">The slot that it goes to; null for one that the cell does not send.</param>
/// <param name="File">The file that it comes from; null if there is none.</param>
/// <param name="Program">What the control will call it.</param>
internal sealed record JobProgram(CellJobSettings Job, SlotSettings? Slot, string? File, ProgramIdentity Program);
