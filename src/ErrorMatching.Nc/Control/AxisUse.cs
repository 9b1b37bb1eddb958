namespace ErrorMatching.Nc;

/// <summary>The purpose of a block's axis words.</summary>
internal enum AxisUse
{
    Motion,
    Nothing,
    Origin,
    Reference,
    MachineCoordinates,
    Cycle,
    Pole,
    Center,
    Corner,
}
