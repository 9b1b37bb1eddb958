using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Where a work offset lies and how it is turned: machine = place + rotation about Z of (work + shift).</summary>
/// <param name="Place">Its origin in machine coordinates, mm.</param>
/// <param name="Unknown">Axes in which only the machine knows it.</param>
/// <param name="Degrees">Its rotation in the plane XY; null where only the machine knows it.</param>
internal readonly record struct WorkOrigin(Vector3 Place, AxisSet Unknown, double? Degrees)
{
    private const AxisSet Flat = AxisSet.X | AxisSet.Y;

    /// <summary>True if it is the offset that it is compared with, written without a rotation: whatever that is, it is the same.</summary>
    public bool KeepsRotation { get; init; }

    /// <summary>A rotation makes two coordinates of each: one that is not known leaves neither.</summary>
    public static AxisSet Mixed(AxisSet unknown) => (unknown & Flat) != AxisSet.None ? unknown | Flat : unknown;

    /// <summary>A vector turned about Z.</summary>
    public static Vector3 Turned(Vector3 by, double degrees) =>
        degrees == 0 ? by : ProgramFrame.Rotation(CoordinatePlane.XY, default, degrees).Turn(by);

    /// <summary>The coordinates of a place when its work offset changes from one to another.</summary>
    /// <param name="place">The place in the first.</param>
    /// <param name="unknown">Coordinates of it that are not known.</param>
    /// <param name="was">The first.</param>
    /// <param name="now">The second.</param>
    /// <param name="unknownDifference">Axes in which it is not known how far they lie apart.</param>
    /// <param name="shift">The shift on top of both (G92).</param>
    /// <param name="unknownShift">Axes in which that is not known.</param>
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
