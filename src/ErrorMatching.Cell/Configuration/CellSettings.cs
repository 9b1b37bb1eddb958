using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <summary>The configuration of a cell, checked as a whole. Its schema describes every key of the file. Paths are absolute here.</summary>
public sealed record CellSettings
{
    internal CellSettings()
    {
    }

    /// <summary>The file as the caller named it.</summary>
    public required string File { get; init; }

    /// <summary>The cell's name.</summary>
    public required string Name { get; init; }

    /// <summary>Where the cell stores its data.</summary>
    public required StoreSettings Store { get; init; }

    /// <summary>Folder of the keys that encrypt the machines' secrets. Anyone who has both this folder and the store can read the
    /// secrets.</summary>
    public required string KeysFolder { get; init; }

    /// <summary>A file apart from store and keys that remembers how far the audit trail goes; null for none.</summary>
    public string? WitnessFile { get; init; }

    /// <summary>Folder of the rolling logs.</summary>
    public required string LogFolder { get; init; }

    /// <summary>The gauges.</summary>
    public required IReadOnlyList<GaugeSettings> Gauges { get; init; }

    /// <summary>The machines.</summary>
    public required IReadOnlyList<MachineSettings> Machines { get; init; }

    /// <summary>The jobs, in the order in which a file is tested against them.</summary>
    public required IReadOnlyList<CellJobSettings> Jobs { get; init; }

    /// <summary>Who approves what.</summary>
    public required PolicySettings Policy { get; init; }

    /// <summary>How people may sign in at a station besides by password.</summary>
    public SignInWays SignIn { get; init; }

    /// <summary>Why people reject a correction, as the shop puts it; empty if it has no such list.</summary>
    public IReadOnlyList<string> RejectionReasons { get; init; } = [];

    /// <summary>The broker that every step is published to; null for none.</summary>
    public EventSettings? Events { get; init; }

    /// <summary>Warnings, in document order, such as plain FTP or a gauge that no job uses.</summary>
    public IReadOnlyList<Refusal> Warnings { get; init; } = [];
}

/// <summary>Who approves what.</summary>
/// <param name="Automatic">True if the cell itself approves corrections within the limits; otherwise a person approves each one.</param>
/// <param name="LimitMm">The largest displacement of one correction in mm; larger ones are refused. Null: only the job's own limit
/// applies.</param>
/// <param name="SumLimitMm">The largest sum of displacements since the original program in mm. Null: the limit for one correction
/// applies.</param>
/// <param name="Gain">Replaces the job's gain; null keeps the job's.</param>
public sealed record PolicySettings(bool Automatic, double? LimitMm, double? SumLimitMm, double? Gain);
