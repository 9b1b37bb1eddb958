namespace ErrorMatching.Cell;

/// <summary>Something that keeps a part of a running cell from working.</summary>
/// <param name="Where">Which part: <see cref="OfSlot"/>, <see cref="OfGauge"/>, <c>store</c> or the name of a worker.</param>
/// <param name="Code">Stable word.</param>
/// <param name="Message">A sentence for whoever has to help.</param>
/// <param name="Since">Since when.</param>
public sealed record CellTrouble(string Where, string Code, string Message, DateTimeOffset Since)
{
    /// <summary>How the part is called that serves a slot.</summary>
    public static string OfSlot(string machine, string slot) => $"slot {machine}/{slot}";

    /// <summary>How the part is called that takes the files of a gauge.</summary>
    public static string OfGauge(string gauge) => $"gauge {gauge}";
}
