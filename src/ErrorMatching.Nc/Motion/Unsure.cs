namespace ErrorMatching.Nc;

/// <summary>Modes that something unseen (a called program, an unknown code) could have changed and that were not stated again.</summary>
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
