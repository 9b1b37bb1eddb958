using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Origin and rotation of a work offset: machine = place + rotation about Z of (work + shift).</summary>
/// <param name="Place">Its origin in machine coordinates, mm.</param>
/// <param name="Unknown">Axes in which only the machine knows the origin.</param>
/// <param name="Degrees">Its rotation in the XY plane; null if only the machine knows it.</param>
internal readonly record struct WorkOrigin(Vector3 Place, AxisSet Unknown, double? Degrees)
{
    private const AxisSet Flat = AxisSet.X | AxisSet.Y;

    /// <summary>True if it is the compared offset, written without a rotation: the rotation stays the same, whatever it is.</summary>
    public bool KeepsRotation { get; init; }

    /// <summary>A rotation mixes the two coordinates: if one is unknown, both become unknown.</summary>
    public static AxisSet Mixed(AxisSet unknown) => (unknown & Flat) != AxisSet.None ? unknown | Flat : unknown;

    /// <summary>A vector turned about Z.</summary>
    public static Vector3 Turned(Vector3 by, double degrees) =>
        degrees == 0 ? by : ProgramFrame.Rotation(CoordinatePlane.XY, default, degrees).Turn(by);

    /// <summary>The coordinates of a place after its work offset changes.</summary>
    /// <param name="place">The place in the old offset.</param>
    /// <param name="unknown">Its unknown coordinates.</param>
    /// <param name="was">The old offset.</param>
    /// <param name="now">The new offset.</param>
    /// <param name="unknownDifference">Axes in which the distance between the two is unknown.</param>
    /// <param name="shift">The shift on top of both (G92).</param>
    /// <param name="unknownShift">Axes in which that shift is unknown.</param>
    public static (Point3 Place, AxisSet Unknown) Reseen(
        Point3 place, AxisSet unknown, WorkOrigin was, WorkOrigin now, AxisSet unknownDifference, Vector3 shift, AxisSet unknownShift)
    {
        var by = was.Place - now.Place;
        if (was.Degrees is { } from && now.Degrees is { } to)
        {
            return from == to
                ? (place + Turned(by, -to), unknown | (to == 0 ? unknownDifference : Mixed(unknownDifference)))
                : (
                    default(Point3) + (Turned(Turned(place - default(Point3) + shift, from) + by, -to) - shift),
                    Mixed(unknown | unknownDifference | (unknownShift & Flat)));
        }

        var isStraight = now.KeepsRotation && by.X == 0 && by.Y == 0 && (unknownDifference & Flat) == AxisSet.None;
        return (place + by, unknown | unknownDifference | (isStraight ? AxisSet.None : Flat));
    }
}
