using System.Collections.Concurrent;
using System.Text.Json.Serialization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Something that prevents a part of a running cell from working.</summary>
/// <param name="Where">The part concerned: <see cref="OfMachine"/>, <see cref="OfSlot"/>, <see cref="OfProgram"/>, <see cref="OfGauge"/>,
/// <see cref="OfFolder"/>, <see cref="OfDelivery"/>, <see cref="OfState"/>, <c>store</c> or the name of a worker.</param>
/// <param name="Code">Stable code.</param>
/// <param name="Message">A sentence for the person who has to fix it.</param>
/// <param name="Since">Since when.</param>
public sealed record CellTrouble(string Where, string Code, string Message, DateTimeOffset Since)
{
    /// <summary>The message as it is recorded; null from a cell of an earlier version.</summary>
    public string? Recorded { get; init; }

    /// <summary>The message as a statement.</summary>
    [JsonIgnore]
    public Statement Statement => Recorded is { } text ? Cell.Recorded.Read(text) : Message;

    /// <summary>Name of the part that checks whether a machine responds.</summary>
    public static string OfMachine(string machine) => $"machine {machine}";

    /// <summary>Name for a gauge's folder.</summary>
    public static string OfFolder(string gauge) => $"folder of gauge {gauge}";

    /// <summary>Name for the program in a taken slot.</summary>
    public static string OfProgram(string machine, string slot) => $"program {machine}/{slot}";

    /// <summary>Name for a program that waits too long for its machine.</summary>
    public static string OfDelivery(string machine, string slot) => $"delivery {machine}/{slot}";

    /// <summary>Name of the part that asks a machine what it is doing.</summary>
    public static string OfState(string machine) => $"state {machine}";

    /// <summary>Name for what waits at a gauge.</summary>
    public static string OfBacklog(string gauge) => $"backlog {gauge}";

    /// <summary>True if it concerns a slot: its program, its worker, its machine, or a program that waits for it.</summary>
    public bool Concerns(string machine, string slot) =>
        Where == OfProgram(machine, slot) || Where == OfSlot(machine, slot) || Where == OfMachine(machine)
        || Where == OfDelivery(machine, slot) || Where == OfState(machine);

    /// <summary>Name of the part that serves a slot.</summary>
    public static string OfSlot(string machine, string slot) => $"slot {machine}/{slot}";

    /// <summary>Name of the part that takes a gauge's files.</summary>
    public static string OfGauge(string gauge) => $"gauge {gauge}";
}

/// <summary>What currently prevents the workers of a running cell from working.</summary>
internal sealed class Troubles(TimeProvider clock)
{
    private readonly ConcurrentDictionary<string, CellTrouble> _open = new(StringComparer.Ordinal);

    /// <summary>All troubles, ordered by worker name.</summary>
    public IReadOnlyList<CellTrouble> Open => [.. _open.Values.OrderBy(t => t.Where, StringComparer.Ordinal)];

    /// <summary>Reports that a worker is prevented from working.</summary>
    /// <returns>True if this is new, or differs from its previous trouble.</returns>
    public bool Begin(string where, string code, Statement message)
    {
        var isNew = true;
        _open.AddOrUpdate(where, _ => new(where, code, message.Sentence, clock.GetUtcNow()) { Recorded = message.Text }, (_, old) =>
        {
            isNew = old.Code != code;
            return old with { Code = code, Message = message.Sentence, Recorded = message.Text };
        });
        return isNew;
    }

    /// <summary>Reports that a worker works again.</summary>
    /// <returns>True if it had a trouble.</returns>
    public bool End(string where) => !_open.IsEmpty && _open.TryRemove(where, out _);
}
