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

    /// <summary>The file's form where recognition looks into it: a format's name or the shop's file of one. The jobs read it by their own.</summary>
    public required string Format { get; init; }

    /// <summary>Larger files are refused unread.</summary>
    public required long MostBytes { get; init; }

    /// <summary>How often the source is looked at.</summary>
    public required TimeSpan Every { get; init; }
}
