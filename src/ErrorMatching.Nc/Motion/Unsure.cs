namespace ErrorMatching.Nc;

/// <summary>Modes that something could have changed unseen (a called program, an unknown code) and that have not been stated again
/// since.</summary>
[Flags]
internal enum Unsure : byte
{
    None = 0,
    Mode = 1,
    Distance = 2,
    Plane = 4,
    Compensation = 8,
    All = 15,
}
