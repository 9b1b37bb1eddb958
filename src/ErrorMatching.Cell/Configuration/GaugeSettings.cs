using ErrorMatching.Measurement;

namespace ErrorMatching.Cell;

/// <summary>A source of measurements: a folder that files arrive in, or a file that is fetched from a machine.</summary>
public sealed record GaugeSettings
{
    /// <summary>Its name.</summary>
    public required string Name { get; init; }

    /// <summary>The folder that files arrive in; null if they are fetched from a machine.</summary>
    public string? Incoming { get; init; }

    /// <summary>The machine whose control writes the log; null for a folder.</summary>
    public string? Machine { get; init; }

    /// <summary>Pattern for file names in the folder or at the machine, with <c>*</c> and <c>?</c>. Other files are left alone.</summary>
    public required string Files { get; init; }

    /// <summary>How a finished file is recognized.</summary>
    public required FinishedRule Finished { get; init; }

    /// <summary>The format that recognition uses to read the files; null for the log of a probing program. Jobs use their own
    /// format.</summary>
    public required MeasurementFormat? Format { get; init; }

    /// <summary>Larger files are refused unread.</summary>
    public required long MostBytes { get; init; }

    /// <summary>Polling interval.</summary>
    public required TimeSpan Every { get; init; }

    /// <summary>How long a measurement may wait until it is computed, before that is a trouble.</summary>
    public TimeSpan WaitLimit { get; init; } = TimeSpan.FromMinutes(10);

    /// <summary>True if a machine's log stays at the machine, false if it is deleted after archiving. Has no effect for a folder, whose
    /// files are always moved out.</summary>
    public bool KeepsFile { get; init; } = true;
}

/// <summary>How to tell that a file is finished: a <see cref="FinishedByRename"/>, <see cref="FinishedByMarker"/>,
/// <see cref="FinishedAtRest"/> or <see cref="FinishedByEndMark"/>.</summary>
public abstract record FinishedRule;

/// <summary>The gauge writes under another name and then renames: a file with a matching name is finished.</summary>
internal sealed record FinishedByRename : FinishedRule;

/// <summary>A second file, the marker, shows that the first is finished.</summary>
/// <param name="Suffix">What follows the first file's name in the marker's name, such as <c>.done</c>.</param>
internal sealed record FinishedByMarker(string Suffix) : FinishedRule;

/// <summary>The file is finished when its size and modification time stay the same; at a machine, when its content does.</summary>
/// <param name="For">For how long.</param>
internal sealed record FinishedAtRest(TimeSpan For) : FinishedRule;

/// <summary>The file is finished when its last nonblank line is the end mark.</summary>
/// <param name="Mark">The line's text, without surrounding spaces.</param>
internal sealed record FinishedByEndMark(string Mark) : FinishedRule;
