namespace ErrorMatching.Cell;

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
