using System.Security.Cryptography;
using System.Text;

namespace ErrorMatching.Cell.Tests;

/// <summary>An incoming folder with its source, and a store's memory of what was archived, by key.</summary>
internal sealed class Incoming : IDisposable
{
    public Incoming(FinishedRule? finished = null, string files = "*.csv", long mostBytes = 1_000_000)
    {
        Gauge = new()
        {
            Name = "cmm",
            Incoming = Folder,
            Files = files,
            Finished = finished ?? new FinishedByRename(),
            Format = Measurement.MeasurementFormat.Points,
            MostBytes = mostBytes,
            Every = TimeSpan.FromMilliseconds(200),
        };
        Source = new(Gauge, Clock);
    }

    public string Folder { get; } = Directory.CreateTempSubdirectory("errormatch-incoming-").FullName;

    public ManualClock Clock { get; } = new();

    public GaugeSettings Gauge { get; }

    public FileSource Source { get; private set; }

    public Dictionary<string, Arrival> Archived { get; } = new(StringComparer.Ordinal);

    public List<UnreadArrival> Unread { get; } = [];

    /// <summary>How often something was handed over, the same arrival again included.</summary>
    public int Handed { get; private set; }

    /// <summary>Names and texts of what is archived, in the order of the first handing over.</summary>
    public IEnumerable<string> Texts => Archived.Values.Select(a => $"{a.FileName}:{Encoding.UTF8.GetString(a.Bytes.Span)}");

    public string PathOf(string name) => Path.Combine(Folder, name);

    public string Claimed(string name) => Path.Combine(Folder, ClaimFolder.Name, name);

    public string Write(string name, string text, int second = 0)
    {
        Directory.CreateDirectory(Path.GetDirectoryName(PathOf(name))!);
        File.WriteAllText(PathOf(name), text);
        File.SetLastWriteTimeUtc(PathOf(name), new DateTime(2026, 1, 2, 3, 4, 0, DateTimeKind.Utc).AddSeconds(second));

        // It is the time of the folder's last change, as with a clock that nobody moves: what changes within a step of the file system's
        // time does not show in it, and is looked for nevertheless.
        Clock.Set(new(Directory.GetLastWriteTimeUtc(Folder), TimeSpan.Zero));
        return PathOf(name);
    }

    public int Take(Action<Arrival>? before = null, Action<Arrival>? behind = null)
    {
        return Source.Take(Keep, KeepUnread, TestContext.Current.CancellationToken);

        void Keep(Arrival arrival)
        {
            before?.Invoke(arrival);
            Handed++;
            Archived.TryAdd(arrival.Key, arrival);
            behind?.Invoke(arrival);
        }

        void KeepUnread(UnreadArrival arrival)
        {
            Handed++;
            if (Unread.All(u => u.Key != arrival.Key))
            {
                Unread.Add(arrival);
            }
        }
    }

    /// <summary>Another process after a kill: nothing is remembered but what is on the disk and in the store.</summary>
    public void Restart()
    {
        Source.Dispose();
        Source = new(Gauge, Clock);
    }

    /// <summary>Names of everything below the folder, folders without files left out.</summary>
    public IEnumerable<string> Files() => Directory.EnumerateFiles(
        Folder, "*", new EnumerationOptions { RecurseSubdirectories = true, AttributesToSkip = FileAttributes.None })
        .Select(f => Path.GetRelativePath(Folder, f).Replace('\\', '/')).Order(StringComparer.Ordinal);

    public static string Sha256(string text) => Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(text)));

    public void Dispose()
    {
        Source.Dispose();
        Directory.Delete(Folder, recursive: true);
    }
}
