using ErrorMatching.Measurement;

namespace ErrorMatching.Cell;

/// <summary>Where measurements come from: a folder that files arrive in, or a file at a machine that is fetched.</summary>
public sealed record GaugeSettings
{
    /// <summary>What people call it.</summary>
    public required string Name { get; init; }

    /// <summary>The folder that files arrive in; null if they are fetched from a machine.</summary>
    public string? Incoming { get; init; }

    /// <summary>The machine whose control writes the log; null for a folder.</summary>
    public string? Machine { get; init; }

    /// <summary>Names of the files in the folder or at the machine, with <c>*</c> and <c>?</c>: other files are left alone.</summary>
    public required string Files { get; init; }

    /// <summary>How a finished file is recognized.</summary>
    public required FinishedRule Finished { get; init; }

    /// <summary>The files' form where recognition looks into them; null for the log of a probing program. The jobs read them by their own.</summary>
    public required MeasurementFormat? Format { get; init; }

    /// <summary>Larger files are refused unread.</summary>
    public required long MostBytes { get; init; }

    /// <summary>How often the source is looked at.</summary>
    public required TimeSpan Every { get; init; }

    /// <summary>True if a machine's log stays at the machine, false if it is deleted once it is archived. Without meaning for a folder, whose files are always taken.</summary>
    public bool KeepsFile { get; init; } = true;
}
