using System.Globalization;
using System.Text;
using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Reads the state from a file: lines of <c>KEY=VALUE</c>, the last of them <c>END</c>, so that half a file is recognized. Keys:
/// <c>STATE</c> (IDLE, RUNNING, HELD or ALARM), <c>PROGRAM</c> for each active program (empty for none), and <c>SINCE</c>.</summary>
internal sealed class StateFile(StateFileSettings settings, TimeProvider clock) : MachineStateSource(settings.File, settings.Timeout)
{
    private const int MostBytes = 4096;
    private const int MostLines = 40;
    private const int Looks = 4;
    private static readonly TimeSpan Pause = TimeSpan.FromMilliseconds(50);
    private Task? _hanging;

    protected override async Task<MachineState> AnswerAsync(CancellationToken cancellation)
    {
        // A file that is being rewritten is whole a moment later.
        for (var look = 1; ; look++)
        {
            try
            {
                return await LookAsync(cancellation).ConfigureAwait(false);
            }
            catch (Exception e) when (look < Looks && e is StateException { Code: StateCodes.Wrong } or FileNotFoundException)
            {
                await Task.Delay(Pause, clock, cancellation).ConfigureAwait(false);
            }
        }
    }

    private async Task<MachineState> LookAsync(CancellationToken cancellation)
    {
        // A share that hangs blocks one thread, not one per question.
        if (_hanging is { IsCompleted: false })
            throw new StateException(StateCodes.Slow, Recorded.StateSlow.With(Place, settings.Timeout.TotalSeconds));
        var reading = Task.Run(Read, cancellation);
        _hanging = reading;
        var (bytes, age) = await reading.WaitAsync(cancellation).ConfigureAwait(false);

        // A clock that is ahead says as little as a file that is old.
        return age.Duration() > settings.MaxAge
            ? throw new StateException(StateCodes.Stale, Recorded.StateStale.With(Place, age.TotalSeconds, settings.MaxAge.TotalSeconds))
            : Parse(bytes);
    }

    private (byte[] Bytes, TimeSpan Age) Read()
    {
        using var file = PlainFile.Open(settings.File, FileShare.ReadWrite | FileShare.Delete);
        var buffer = new byte[MostBytes + 1];
        var count = 0;
        for (int read; count < buffer.Length && (read = RandomAccess.Read(file, buffer.AsSpan(count), count)) > 0;)
            count += read;
        if (count > MostBytes)
            throw Wrong($"more than {MostBytes} bytes");
        return (buffer[..count], clock.GetUtcNow() - new DateTimeOffset(File.GetLastWriteTimeUtc(file), TimeSpan.Zero));
    }

    private MachineState Parse(byte[] bytes)
    {
        var lines = Encoding.UTF8.GetString(bytes).Split('\n', MostLines + 1).Select(l => l.Trim()).Where(l => l.Length > 0).ToArray();
        if (lines is not [.., "END"])
            throw Wrong("its last line is not END");
        MachineActivity? activity = null;
        List<string>? programs = null;
        DateTimeOffset? since = null;
        foreach (var line in lines[..^1])
        {
            switch (line.Split('=', 2))
            {
                case ["STATE", var word] when activity is null:
                    activity = ActivityOf(word);
                    break;
                case ["PROGRAM", var name]:
                    programs ??= [];
                    if (name.Trim().Length > 0)
                        programs.Add(Name(name.Trim()));
                    break;
                case ["SINCE", var time] when since is null:
                    since = DateTimeOffset.TryParse(time, CultureInfo.InvariantCulture, DateTimeStyles.AssumeUniversal, out var at)
                        ? at
                        : throw Wrong($"SINCE={time}, which is no time");
                    break;
                default:
                    throw Wrong($"the line {line}");
            }
        }

        return new(activity ?? throw Wrong("no line STATE="), programs, since);
    }

    private MachineActivity ActivityOf(string word) => word.Trim() switch
    {
        "IDLE" => MachineActivity.Idle,
        "RUNNING" => MachineActivity.Running,
        "HELD" => MachineActivity.Held,
        "ALARM" => MachineActivity.Alarm,
        _ => throw Wrong($"STATE={word}, which is not IDLE, RUNNING, HELD or ALARM"),
    };
}

/// <summary>A file that a PLC or control rewrites every few seconds.</summary>
/// <param name="File">The file.</param>
/// <param name="MaxAge">An older file says nothing: its writer has stopped.</param>
internal sealed record StateFileSettings(string File, TimeSpan MaxAge) : StateSettings
{
    private const double UsualAge = 10;

    /// <inheritdoc/>
    public override string Address => File;

    /// <inheritdoc/>
    public override string? LocalFile => File;

    public static StateFileSettings Read(JsonItem item, CellPaths paths) =>
        new(paths.Of(item["file"]), TimeSpan.FromSeconds(item.Find("maxAgeS")?.Number ?? UsualAge));

    internal override MachineStateSource Open(TimeProvider clock) => new StateFile(this, clock);
}
