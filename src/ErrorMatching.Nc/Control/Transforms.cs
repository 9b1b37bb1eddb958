namespace ErrorMatching.Nc;

/// <summary>Which transformations of a program are active.</summary>
[Flags]
internal enum Transforms : byte
{
    None = 0,
    Rotation = 1,
    Scale = 2,
    Mirror = 4,
    Polar = 8,
    Programmable = 16,
    Opaque = 32,
}
