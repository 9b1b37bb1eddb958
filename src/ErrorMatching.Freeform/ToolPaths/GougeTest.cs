using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Tests centers against the whole surface: whether the ball cuts in where it should not touch.</summary>
/// <param name="context">What the path is planned with.</param>
internal sealed class GougeTest(PlanningContext context)
{
    private readonly PatchTree _tree = new(context.Offset.Surface);
    private readonly RollingBall _rolling = new(context.Offset.Surface.Spline, context.Offset.DistanceMm);
    private (Point2 From, Point2 To)? _free;

    /// <summary>Greatest Z of the surface.</summary>
    public double HighestMm => _tree.HighestMm;

    /// <summary>Where that is.</summary>
    public Point3 HighestPlace => _tree.HighestPlace;

    /// <summary>Tests a line that has not been raised.</summary>
    // It is within the chordal error of the exact offset. If the ball rolls freely on the exact offset, nothing is nearer than that.
    public bool Gouges(CenterLine line)
    {
        var centers = line.Centers;
        var places = line.Places;
        for (var i = 0; i < centers.Length; i++)
        {
            var isFree = RollsAt(places[i]);
            if (!isFree && Gouges(centers[i], line.Normals[i]))
            {
                return true;
            }

            if (i + 1 < centers.Length
                && !(isFree && IsInFreePart(places[i + 1]))
                && Gouges(Middle(centers[i], centers[i + 1]), Between(line.Normals[i], line.Normals[i + 1])))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Tests one center.</summary>
    public bool Gouges(Point3 center, Vector3 normal) => _tree.IsNearer(center, normal, context.NearestMm);

    /// <summary>True if a center on a straight way at the feed is nearer than even a raised one may be.</summary>
    public bool Blocks(Point3 from, Point3 to, Vector3 normal) =>
        _tree.PlaceNearer(from, to, normal, context.NearestMm - context.MostRaisedMm) is not null;

    /// <summary>True if the ball may meet the material before the stage on a rapid way between two places, which are rounded to the
    /// program's increment afterwards.</summary>
    public bool MeetsMaterial(Point3 from, Point3 to, Vector3 normal) =>
        _tree.PlaceNearer(from, to, normal, context.FreeMm + (2 * context.Rounding.IncrementMm)) is not null;

    /// <summary>By how much the ball cuts too deep at a center.</summary>
    public double DepthMm(Point3 center, Vector3 normal) =>
        context.Offset.DistanceMm - _tree.DistanceBelow(center, normal, context.Offset.DistanceMm);

    public static Point3 Middle(Point3 a, Point3 b) => a + ((b - a) * 0.5);

    // The unit normal halfway between two.
    private static Vector3 Between(Vector3 a, Vector3 b)
    {
        var sum = a + b;
        return sum * (1 / Math.Max(1e-9, sum.Length));
    }

    private bool RollsAt(Point2 place)
    {
        if (!IsInFreePart(place))
        {
            _free = _rolling.FreeAround(place.X, place.Y);
        }

        return _free is not null;
    }

    private bool IsInFreePart(Point2 place) =>
        _free is var (from, to) && place.X >= from.X && place.Y >= from.Y && place.X <= to.X && place.Y <= to.Y;
}
