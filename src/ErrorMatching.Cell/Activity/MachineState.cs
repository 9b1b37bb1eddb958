using System.Text.Json.Serialization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>The state of a machine, as its control reported it.</summary>
/// <param name="Activity">What it is doing.</param>
/// <param name="Programs">Names of the active programs, as the control spells them; none if no program is active; null if they are
/// unknown.</param>
/// <param name="Since">Since when, by the clock of the source; null if it does not say.</param>
public sealed record MachineState(MachineActivity Activity, IReadOnlyList<string>? Programs, DateTimeOffset? Since)
{
    private const int MostNamed = 3;

    /// <summary>Why it is unknown; null if it is known.</summary>
    [JsonIgnore]
    public Statement? Why { get; init; }

    /// <summary>Stable code for how the source failed; null if it answered, even if it does not know the state.</summary>
    public string? Code { get; init; }

    /// <summary>The active programs for display; empty if there are none, or if they are unknown.</summary>
    [JsonIgnore]
    public string Named => string.Join(", ", (Programs ?? []).Take(MostNamed));

    /// <summary>An unknown state.</summary>
    /// <param name="why">Why.</param>
    /// <param name="code">Stable code for how the source failed; null if it answered that it does not know.</param>
    public static MachineState Unknown(Statement why, string? code = null) =>
        new(MachineActivity.Unknown, null, null) { Why = why, Code = code };

    /// <summary>True if the machine runs a program, or may: a held or alarmed program counts as running, and so does an unknown
    /// one.</summary>
    /// <param name="program">The program, by all its names.</param>
    public bool Uses(ProgramIdentity program)
    {
        ArgumentNullException.ThrowIfNull(program);
        return Activity switch
        {
            MachineActivity.Idle => false,
            MachineActivity.Unknown => true,
            _ => Programs is null || Programs.Any(program.MayBe),
        };
    }

    /// <summary>True if both are the same state of affairs, whenever they were reported.</summary>
    internal bool IsLike(MachineState other) =>
        Activity == other.Activity && Code == other.Code && Why == other.Why && (Programs is null) == (other.Programs is null)
        && (Programs ?? []).SequenceEqual(other.Programs ?? [], StringComparer.Ordinal);
}

/// <summary>What a machine is doing, as far as its control says.</summary>
public enum MachineActivity
{
    /// <summary>Nobody knows: the control does not answer, or does not know it.</summary>
    Unknown,

    /// <summary>No program is being executed. One may be selected.</summary>
    Idle,

    /// <summary>A program is being executed.</summary>
    Running,

    /// <summary>A program is interrupted and can go on.</summary>
    Held,

    /// <summary>The control is in alarm or in emergency stop.</summary>
    Alarm,
}
