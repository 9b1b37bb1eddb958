using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>The configuration of a cell, checked as a whole. Every key of the file is described by its schema. Paths are absolute here.</summary>
public sealed record CellSettings
{
    internal CellSettings()
    {
    }

    /// <summary>The file as the caller named it.</summary>
    public required string File { get; init; }

    /// <summary>What people call the cell.</summary>
    public required string Name { get; init; }

    /// <summary>Where everything is kept.</summary>
    public required StoreSettings Store { get; init; }

    /// <summary>Folder of the keys that secrets of machines are encrypted with. Whoever has it and the store can read them.</summary>
    public required string KeysFolder { get; init; }

    /// <summary>Folder of the rolling logs.</summary>
    public required string LogFolder { get; init; }

    /// <summary>The gauges.</summary>
    public required IReadOnlyList<GaugeSettings> Gauges { get; init; }

    /// <summary>The machines.</summary>
    public required IReadOnlyList<MachineSettings> Machines { get; init; }

    /// <summary>The jobs, in the order in which they are asked whether a file is theirs.</summary>
    public required IReadOnlyList<CellJobSettings> Jobs { get; init; }

    /// <summary>Who approves what.</summary>
    public required PolicySettings Policy { get; init; }

    /// <summary>What is allowed but unwise, in the order of the file: plain FTP, a gauge that no job listens to.</summary>
    public IReadOnlyList<JsonProblem> Warnings { get; init; } = [];
}
