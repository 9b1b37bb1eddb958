using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>The piece to be cut, and its program.</summary>
/// <param name="Program">File of the program, as the job writes it.</param>
/// <param name="Dialect">The control that the program is written for: the name of a built-in dialect, or a file of the shop as the job
/// writes it (<see cref="NcDialects.IsFile"/>).</param>
/// <param name="ToolDiameterMm">Diameter of the tool that cuts the boundary.</param>
/// <param name="Measured">File of the key points of a counterpart that was cut before; null if there is none.</param>
/// <param name="Frame">From the part's frame to the program's.</param>
/// <param name="MapMm">How far a key point may lie from the path of its blocks.</param>
public sealed record JobCounterpart(
    string Program, string Dialect, double ToolDiameterMm, string? Measured, RigidTransform2 Frame, double MapMm)
{
    /// <summary>The default of <see cref="MapMm"/>.</summary>
    public const double DefaultMapMm = 0.5;

    /// <summary>How the switch for block skip of the machine stands; unstated where the job does not say.</summary>
    public BlockSkip BlockSkip { get; init; }

    /// <summary>The dialect of the program, with the switch as the job states it.</summary>
    /// <param name="own">The shop's dialect, where the job names a file; null for a built-in one.</param>
    /// <exception cref="NcException">No dialect has the job's name.</exception>
    public NcDialect DialectOf(NcDialect? own) => (own ?? NcDialects.Named(Dialect)).With(BlockSkip);

    /// <summary>Where a point of the part lies in the program, mm, in the axis order of a plane.</summary>
    /// <param name="point">The point as designed.</param>
    /// <param name="plane">The plane of its feature.</param>
    /// <param name="file">File of the point, for messages.</param>
    /// <exception cref="MeasurementException">The plane is not XY and the point has no Z
    /// (<see cref="MeasurementError.MissingCoordinate"/>).</exception>
    public Point2 PlaceOf(LabelledPoint point, CoordinatePlane plane, string file) =>
        Frame.Apply(ProjectedPoint.Of(point, plane, file).Position);
}
