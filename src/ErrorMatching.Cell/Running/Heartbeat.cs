using System.Globalization;
using System.Text.Json;

namespace ErrorMatching.Cell;

/// <summary>The sign of life that a running cell leaves beside its logs every few seconds, for <c>cell status</c> in another process: since when it runs, and what keeps it from working.</summary>
/// <param name="ProcessId">The process.</param>
/// <param name="Since">Since when it runs.</param>
/// <param name="At">When it said so.</param>
/// <param name="Troubles">What keeps it from working.</param>
public sealed record Heartbeat(int ProcessId, DateTimeOffset Since, DateTimeOffset At, IReadOnlyList<CellTrouble> Troubles)
{
    private const string FileName = "running.json";
    private const int Room = 4096;

    /// <summary>Older ones tell of a cell that does not run any more.</summary>
    public static TimeSpan Fresh { get; } = TimeSpan.FromSeconds(15);

    /// <summary>The sign in a folder; null if there is none, or one that cannot be read.</summary>
    public static Heartbeat? Read(string folder)
    {
        try
        {
            return JsonSerializer.Deserialize<Heartbeat>(File.ReadAllBytes(Path.Combine(folder, FileName))) is { Troubles: not null } sign ? sign : null;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or JsonException)
        {
            return null;
        }
    }

    /// <summary>Leaves the sign: whole, but without waiting for the disk. On a full disk it is written over the one before, so that a cell is not taken for dead because it has no room to say that it lives.</summary>
    public void Write(string folder)
    {
        Directory.CreateDirectory(folder);
        var file = Path.Combine(folder, FileName);
        var written = string.Create(CultureInfo.InvariantCulture, $"{file}.{ProcessId}");
        var sign = JsonSerializer.SerializeToUtf8Bytes(this);

        // Spaces behind it keep the room that troubles to come may need.
        byte[] bytes = [.. sign, .. Enumerable.Repeat((byte)' ', Math.Max(0, Room - sign.Length))];
        try
        {
            File.WriteAllBytes(written, bytes);
            File.Move(written, file, overwrite: true);
        }
        catch (IOException) when (new FileInfo(file) is { Exists: true } before && before.Length == bytes.Length)
        {
            File.Delete(written);
            using var over = new FileStream(file, FileMode.Open, FileAccess.Write, FileShare.ReadWrite | FileShare.Delete, bufferSize: 0);
            over.Write(bytes);
        }
    }

    /// <summary>Takes the sign away: the cell has ended in order.</summary>
    public static void Remove(string folder) => File.Delete(Path.Combine(folder, FileName));

    /// <summary>True if the cell lived just now. A sign from the future is none: the clock was set back since.</summary>
    public bool IsFresh(DateTimeOffset now) => (now - At).Duration() < Fresh;
}
