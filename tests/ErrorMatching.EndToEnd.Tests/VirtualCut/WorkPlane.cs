namespace ErrorMatching.EndToEnd.Tests;

/// <summary>The plane of arcs: G17, G18 and G19. ISO 6983-1 looks at each against its third axis, so G18 is Z then X.</summary>
internal enum WorkPlane
{
    XY,
    ZX,
    YZ,
}
