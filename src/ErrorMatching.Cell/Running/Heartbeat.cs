using System.Diagnostics.CodeAnalysis;
using System.Globalization;
using System.Text.Json;
using System.Text.Json.Serialization;
using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>The heartbeat that a running cell writes next to its logs every few seconds, for <c>cell status</c> in another process: when it
/// started, and what prevents it from working.</summary>
/// <param name="ProcessId">The process.</param>
/// <param name="Since">When the cell started.</param>
/// <param name="At">When the heartbeat was written.</param>
/// <param name="Troubles">What prevents the cell from working.</param>
public sealed record Heartbeat(int ProcessId, DateTimeOffset Since, DateTimeOffset At, IReadOnlyList<CellTrouble> Troubles)
{
    /// <summary>What the machines are doing; those that say it.</summary>
    public IReadOnlyList<MachineReport> Machines { get; init; } = [];

    /// <summary>Programs that wait for their machines.</summary>
    public IReadOnlyList<WaitingDelivery> Waiting { get; init; } = [];

    /// <summary>What waits at the gauges.</summary>
    public IReadOnlyList<GaugeBacklog> Backlog { get; init; } = [];

    private const string FileName = "running.json";
    private const int Room = 4096;

    /// <summary>Maximum age: a cell with an older heartbeat is no longer running.</summary>
    public static TimeSpan Fresh { get; } = TimeSpan.FromSeconds(15);

    /// <summary>The heartbeat in a folder; null if it is missing or unreadable.</summary>
    public static Heartbeat? Read(string folder)
    {
        try
        {
            // A cell on a full disk overwrites it.
            using var file = SharedFile.OpenRead(Path.Combine(folder, FileName), FileShare.ReadWrite | FileShare.Delete);
            return JsonSerializer.Deserialize(file, HeartbeatJson.Default.Heartbeat)
                is { Troubles: not null, Machines: not null, Waiting: not null, Backlog: not null } sign
                ? sign
                : null;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or JsonException)
        {
            return null;
        }
    }

    /// <summary>Writes the heartbeat: complete, but without waiting for the disk. On a full disk, or if
    /// somebody keeps the previous one open, it is overwritten in place: neither must make the cell look dead.</summary>
    public void Write(string folder)
    {
        Directory.CreateDirectory(folder);
        var file = Path.Combine(folder, FileName);
        var written = string.Create(CultureInfo.InvariantCulture, $"{file}.{ProcessId}");
        var sign = JsonSerializer.SerializeToUtf8Bytes(this, HeartbeatJson.Default.Heartbeat);

        // Trailing spaces reserve room for later troubles.
        byte[] bytes = [.. sign, .. Enumerable.Repeat((byte)' ', Math.Max(0, Room - sign.Length))];
        try
        {
            File.WriteAllBytes(written, bytes);
            SharedFile.Replace(written, file);
        }
        catch (Exception e) when (
            e is IOException or UnauthorizedAccessException
            && new FileInfo(file) is { Exists: true } before
            && before.Length == bytes.Length)
        {
            File.Delete(written);
            using var over = new FileStream(file, FileMode.Open, FileAccess.Write, FileShare.ReadWrite | FileShare.Delete, bufferSize: 0);
            over.Write(bytes);
        }
    }

    /// <summary>Removes the heartbeat after an orderly end.</summary>
    public static void Remove(string folder) => SharedFile.Delete(Path.Combine(folder, FileName));

    /// <summary>True if the cell was running a moment ago. A heartbeat from the future is not fresh: the clock has been set back
    /// since.</summary>
    public bool IsFresh(DateTimeOffset now) => (now - At).Duration() < Fresh;
}

/// <summary>How a heartbeat is written, made while the program is compiled.</summary>
[JsonSerializable(typeof(Heartbeat))]
[SuppressMessage("ApiDesign", "RS0030", Justification = "The generated code names a type without a culture.")]
internal sealed partial class HeartbeatJson : JsonSerializerContext;

/// <summary>Reports every few seconds that the cell runs and what prevents it from working.</summary>
internal sealed class HeartbeatWorker(CellFlow flow, Action? alive)
{
    private readonly DateTimeOffset _since = flow.Clock.GetUtcNow();

    /// <summary>Reports once.</summary>
    public Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        stop.ThrowIfCancellationRequested();
        alive?.Invoke();
        Try(
            "signs of life",
            () => new Heartbeat(Environment.ProcessId, _since, flow.Clock.GetUtcNow(), flow.Troubles.Open)
            {
                Machines = flow.Machines.Machines,
                Waiting = flow.Machines.Waiting,
                Backlog = flow.Backlogs.All,
            }.Write(flow.Settings.LogFolder));
        return Task.FromResult(flow.Pace.Heartbeat);
    }

    // A full disk for logs is reported as a trouble. It must not slow the heartbeat, or the cell would look dead and be killed.
    private void Try(string what, Action work)
    {
        try
        {
            work();
            flow.Troubles.End(what);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            if (flow.Troubles.Begin(what, CellCodes.NotKept, e.Message))
            {
                flow.Log.Warning("{What}: {Message}", what, e.Message);
            }
        }
    }
}
