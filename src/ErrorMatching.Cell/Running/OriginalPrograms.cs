using System.Security.Cryptography;
using ErrorMatching.Jobs;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

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
                    hashes.Add(Convert.ToHexStringLower(SHA256.HashData(bytes.Span)));
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
