namespace ErrorMatching.Cell;

/// <summary>Something that keeps a part of a running cell from working.</summary>
/// <param name="Where">
/// Which part: <see cref="OfMachine"/>, <see cref="OfSlot"/>, <see cref="OfProgram"/>, <see cref="OfGauge"/>, <see cref="OfFolder"/>,
/// <c>store</c> or the name of a worker.
/// </param>
/// <param name="Code">Stable word.</param>
/// <param name="Message">A sentence for whoever has to help.</param>
/// <param name="Since">Since when.</param>
public sealed record CellTrouble(string Where, string Code, string Message, DateTimeOffset Since)
{
    /// <summary>How the part is called that looks whether a machine answers.</summary>
    public static string OfMachine(string machine) => $"machine {machine}";

    /// <summary>How a gauge's folder is called.</summary>
    public static string OfFolder(string gauge) => $"folder of gauge {gauge}";

    /// <summary>How the program is called that a taken slot holds.</summary>
    public static string OfProgram(string machine, string slot) => $"program {machine}/{slot}";

    /// <summary>True if it concerns a slot: its program, whoever serves it, or its machine.</summary>
    public bool Concerns(string machine, string slot) =>
        Where == OfProgram(machine, slot) || Where == OfSlot(machine, slot) || Where == OfMachine(machine);

    /// <summary>How the part is called that serves a slot.</summary>
    public static string OfSlot(string machine, string slot) => $"slot {machine}/{slot}";

    /// <summary>How the part is called that takes the files of a gauge.</summary>
    public static string OfGauge(string gauge) => $"gauge {gauge}";
}
