using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>The piece to be cut, and its program.</summary>
/// <param name="Program">File of the program, as the job writes it.</param>
/// <param name="Dialect">The control that the program is written for: the name of a built-in dialect, or a file of the shop as the job writes it (<see cref="Nc.NcDialects.IsFile"/>).</param>
/// <param name="ToolDiameterMm">Diameter of the tool that cuts the boundary.</param>
/// <param name="Measured">File of the key points of a counterpart that was cut before; null if there is none.</param>
/// <param name="Frame">From the part's frame to the program's.</param>
/// <param name="MapMm">How far a key point may lie from the path of its blocks.</param>
public sealed record JobCounterpart(string Program, string Dialect, double ToolDiameterMm, string? Measured, RigidTransform2 Frame, double MapMm)
{
    /// <summary>The default of <see cref="MapMm"/>.</summary>
    public const double DefaultMapMm = 0.5;
}
