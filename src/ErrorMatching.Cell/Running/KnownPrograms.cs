using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Decides which programs found in a slot the cell may replace.</summary>
/// <param name="flow">State shared by the workers.</param>
/// <param name="place">The slot.</param>
/// <param name="originals">The original programs of the slot's jobs.</param>
internal sealed class KnownPrograms(CellFlow flow, SlotPlace place, OriginalPrograms originals)
{
    // Identical pieces have the same program.
    private const int MostAlike = 100;

    /// <summary>Why a program must not be replaced; null if it may be: the cell put it there, or it is an original.</summary>
    /// <param name="found">The program; null if the slot is empty.</param>
    /// <param name="hash">Its SHA-256; null if the slot is empty.</param>
    /// <param name="approved">The correction to send.</param>
    public Statement? WhyNot(byte[]? found, string? hash, Correction approved)
    {
        // What it found earlier was known then, or a person was warned and approved again.
        if (found is null || hash is null || hash == approved.ProgramSha256 || hash == approved.PreviousSha256) return null;
        if (Cutting(hash, approved) is { } cutting)
            return RecordedOffset.SlotOfPrograms.With(place.Slot.Program, place.Machine.Name, cutting.Id);
        var holding = flow.Store.Slot(place.Machine.Name, place.Slot.Name);
        return hash == holding.ProgramSha256 || hash == holding.PreviousSha256
            || (approved.Offset is null && originals.Hashes(place.Machine.Name, place.Slot.Name).Contains(hash))
            ? null
            : (IsOfOtherCell(found) ? Recorded.OfOtherCell : Recorded.ChangedBefore).With(place.Slot.Program, place.Machine.Name, hash);
    }

    // A marker says which measurement a program was made from. No file that arrived here was that one.
    private bool IsOfOtherCell(byte[] found)
    {
        try
        {
            return Marker.Find(NcProgram.Read(found, InputFile.Dialect(place.Machine.Dialect).Syntax)) is [_, ..] markers
                && markers.All(m => m.Marker is { } marker && flow.Store.Corrections.OfMeasurement(marker.MeasurementSha256).Count == 0);
        }
        catch (InputException)
        {
            // It is no program that the cell can read, and so none with a marker.
            return false;
        }
    }

    // A program that sets offsets does not replace one that cuts.
    private Correction? Cutting(string hash, Correction approved) => approved.Offset is null
        ? null
        : flow.Store.Search(new() { Program = hash, Most = MostAlike }).FirstOrDefault(c => c.ProgramSha256 == hash && c.Offset is null);
}

/// <summary>The base programs of jobs, as they are on disk now.</summary>
internal sealed class OriginalPrograms(CellSettings settings)
{
    /// <summary>The original program of a job; null for a free-form job that computes its tool path.</summary>
    /// <exception cref="InputException">The job or the program cannot be opened. The job is invalid.</exception>
    public static ReadOnlyMemory<byte>? Of(CellJobSettings job)
    {
        if (!job.IsFreeform)
        {
            return new JobFiles(job.File).Program(null).Bytes;
        }

        return job.Program is { } program ? InputFile.Program(program) : null;
    }

    /// <summary>Hashes of the original programs of all jobs of a slot. Programs that cannot be read are omitted: they cannot have been
    /// copied to the machine from here.</summary>
    public IReadOnlySet<string> Hashes(string machine, string slot)
    {
        var hashes = new HashSet<string>(StringComparer.Ordinal);
        foreach (var job in settings.Jobs.Where(j => j.Machine == machine && j.Slot == slot))
        {
            try
            {
                if (Of(job) is { } bytes)
                {
                    hashes.Add(ContentHash.Sha256(bytes.Span));
                }
            }
            catch (InputException)
            {
                // The job's own measurements report it.
            }
        }

        return hashes;
    }
}
