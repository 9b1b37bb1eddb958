using System.Collections.Concurrent;
using ErrorMatching.Cell;
using ErrorMatching.Json;

namespace ErrorMatching.Hmi;

/// <summary>What people call the workpieces: the name in the job's file as it was kept with each correction, read once and beside the screen.</summary>
public sealed class JobNames
{
    private readonly ConcurrentDictionary<string, string> _names = new(StringComparer.Ordinal);

    /// <summary>The name of a correction's job; the one in the cell's configuration where the file is not kept yet, null before it is recognized.</summary>
    public string? Of(Correction correction)
    {
        ArgumentNullException.ThrowIfNull(correction);
        return correction.JobSha256 is { } sha && _names.TryGetValue(sha, out var name) ? name : correction.Job;
    }

    /// <summary>Reads what is not known yet. Not to be called on the screen's thread.</summary>
    /// <exception cref="StoreException">The store cannot be read.</exception>
    internal void Learn(CellStore store, IEnumerable<Correction> corrections)
    {
        foreach (var correction in corrections)
        {
            if (correction is { JobSha256: { } sha, Job: { } job } && !_names.ContainsKey(sha))
            {
                _names[sha] = Read(store.Content(sha), job);
            }
        }
    }

    // A kept job was read when it was computed; one that this station cannot read goes by the cell's name.
    private static string Read(byte[] file, string job)
    {
        try
        {
            var root = JsonInput.Read(file, job);
            return root.Kind == JsonItemKind.Object && root.Find("name")?.Text is { Length: > 0 } name ? name : job;
        }
        catch (JsonDocumentException)
        {
            return job;
        }
    }
}
