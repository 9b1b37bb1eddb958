using System.Security.Cryptography;
using ErrorMatching.Jobs;

namespace ErrorMatching.Cell;

/// <summary>The programs that jobs start from, as they lie on the disk now.</summary>
internal sealed class OriginalPrograms(CellSettings settings)
{
    /// <summary>The original program of a job; null for a free-form job whose tool path is computed.</summary>
    /// <exception cref="InputException">The job or the program cannot be opened.</exception>
    /// <exception cref="Json.JsonDocumentException">The job cannot be used.</exception>
    public static ReadOnlyMemory<byte>? Of(CellJobSettings job)
    {
        if (!job.IsFreeform)
        {
            return new JobFiles(job.File).Program(null).Bytes;
        }

        return job.Program is { } program ? InputFile.Program(program) : null;
    }

    /// <summary>Hashes of the original programs of all jobs of a slot, those left out that cannot be read: what cannot be read cannot have been put there from here.</summary>
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
            catch (Exception e) when (e is InputException or Json.JsonDocumentException)
            {
                // Its own measurements say so.
            }
        }

        return hashes;
    }
}
