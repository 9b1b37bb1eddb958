using System.Collections.Concurrent;
using ErrorMatching.Cell;
using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi;

/// <summary>Names of the workpieces: the name in the job file stored with each correction, read once and off the UI thread.</summary>
public sealed class JobNames
{
    private readonly ConcurrentDictionary<string, string> _names = new(StringComparer.Ordinal);

    /// <summary>The name of a correction's job; the configured name while the file is not stored yet; null before the piece is
    /// recognized.</summary>
    public string? Of(Correction correction)
    {
        ArgumentNullException.ThrowIfNull(correction);
        return correction.JobSha256 is { } sha && _names.TryGetValue(sha, out var name) ? name : correction.Job;
    }

    /// <summary>Reads names that are not known yet. Do not call it on the UI thread.</summary>
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

    // A stored job was readable when it was computed. If this station cannot read it, the cell's name is used.
    private static string Read(byte[] file, string job)
    {
        try
        {
            var root = JsonInput.Read(file, job);
            return root.Kind == JsonItemKind.Object && root.Find("name")?.Text is { Length: > 0 } name ? name : job;
        }
        catch (InputException)
        {
            return job;
        }
    }
}
