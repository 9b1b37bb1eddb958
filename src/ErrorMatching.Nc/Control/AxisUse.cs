namespace ErrorMatching.Nc;

/// <summary>What the axis words of a block are for.</summary>
internal enum AxisUse
{
    Motion,
    Nothing,
    Origin,
    Reference,
    MachineCoordinates,
}
