using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>The piece to be cut, and its program.</summary>
/// <param name="Program">Program file, as the job writes it.</param>
/// <param name="Dialect">The control that the program is written for: the name of a built-in dialect, or the shop's dialect file as the
/// job writes it (<see cref="NcDialects.IsFile"/>).</param>
/// <param name="ToolDiameterMm">Diameter of the tool that cuts the boundary.</param>
/// <param name="Measured">File of the key points of an earlier counterpart; null if there is none.</param>
/// <param name="Frame">Transform from the part's frame to the program's.</param>
/// <param name="MapMm">Allowed distance of a key point from the path of its blocks.</param>
public sealed record JobCounterpart(
    string Program, string Dialect, double ToolDiameterMm, string? Measured, RigidTransform2 Frame, double MapMm)
{
    /// <summary>The default of <see cref="MapMm"/>.</summary>
    public const double DefaultMapMm = 0.5;

    /// <summary>State of the machine's block skip switch; unstated if the job does not give it.</summary>
    public BlockSkip BlockSkip { get; init; }

    /// <summary>Values of variables that only the machine knows; none if the job does not state them.</summary>
    public AssumedValues Assumed { get; init; } = AssumedValues.None;

    /// <summary>SHA-256 of the program for which the blocks were chosen, 64 lowercase hexadecimal digits; null if the job does not state
    /// it.</summary>
    public string? ProgramSha256 { get; init; }

    /// <summary>Folders with programs that the program calls, as the job writes them; searched in order, behind the program's own
    /// folder.</summary>
    public IReadOnlyList<string> Libraries { get; init; } = [];

    /// <summary>The dialect of the program, with the state of the switch and the values of variables from the job.</summary>
    /// <param name="own">The shop's dialect if the job names a file; null for a built-in one.</param>
    /// <exception cref="InputException">No dialect has the job's name.</exception>
    public NcDialect DialectOf(NcDialect? own) =>
        (own ?? NcDialects.Named(Dialect)).With(BlockSkip).With(Assumed).With(ToolRadii.Of(ToolDiameterMm / 2));

    /// <summary>Position of a part point in the program, mm, in the axis order of a plane.</summary>
    /// <param name="point">The point as designed.</param>
    /// <param name="plane">The plane of its feature.</param>
    /// <param name="file">File of the point, for messages.</param>
    /// <exception cref="InputException">The plane is not XY and the point has no Z
    /// (<see cref="MeasurementError.MissingCoordinate"/>).</exception>
    public Point2 PlaceOf(LabelledPoint point, CoordinatePlane plane, string file) =>
        Frame.Apply(ProjectedPoint.Of(point, plane, file).Position);
}
