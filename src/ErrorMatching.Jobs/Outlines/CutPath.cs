using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Jobs;

/// <summary>What a program cuts in the plane XY, searched by place.</summary>
internal sealed class CutPath
{
    // Below this, a stretch tells no direction, mm.
    private const double LeastLineMm = 1;

    // Cosine of half a degree, and the distance in mm by which pieces of one line may be apart.
    private const double SameLineCosine = 0.99996;
    private const double SameLineMm = 0.01;

    // So many of the longest lines are tried.
    private const int MostLines = 60;
    private const int CellsAlong = 64;
    private const double LeastCellMm = 2;

    private readonly NcPath _path;
    private readonly List<int> _motions = [];
    // Squares that cover the program, with the motions in each.
    private readonly List<int>?[,] _cells;
    private readonly Point2 _corner;
    private readonly double _cellMm;

    /// <summary>Takes the cuts of a program.</summary>
    /// <param name="path">The program, interpreted.</param>
    public CutPath(NcPath path)
    {
        _path = path;
        for (var m = 0; m < path.Motions.Length; m++)
        {
            if (path.Motions[m] is { IsCut: true, MovesInPlane: true, IsKnownInPlane: true, Plane: CoordinatePlane.XY } motion
                && !motion.Has(MotionFlags.Transformed | MotionFlags.BadArc))
            {
                _motions.Add(m);
            }
        }

        double left = double.PositiveInfinity, right = double.NegativeInfinity, low = left, high = right;
        foreach (var m in _motions)
        {
            foreach (var p in new[] { path.Motions[m].PlaneStart, path.Motions[m].PlaneEnd })
            {
                (left, right) = (Math.Min(left, p.X), Math.Max(right, p.X));
                (low, high) = (Math.Min(low, p.Y), Math.Max(high, p.Y));
            }
        }

        if (_motions.Count == 0)
        {
            (_corner, _cellMm, _cells) = (Point2.Origin, 1, new List<int>?[0, 0]);
            return;
        }

        (_corner, _cellMm) = (new(left, low), Math.Max(LeastCellMm, Math.Max(right - left, high - low) / CellsAlong));
        _cells = new List<int>?[1 + (int)((right - left) / _cellMm), 1 + (int)((high - low) / _cellMm)];
        foreach (var m in _motions)
        {
            var steps = 1 + (int)Math.Min(100_000, path.Motions[m].PlaneLength / _cellMm * 2);
            for (var k = 0; k <= steps; k++)
            {
                var (x, y) = CellOf(path.Motions[m].PlaneAt((double)k / steps));
                var list = _cells[x, y] ??= [];
                if (list.Count == 0 || list[^1] != m)
                {
                    list.Add(m);
                }
            }
        }
    }

    /// <summary>Length of its cuts, mm.</summary>
    public double LengthMm => _motions.Sum(m => _path.Motions[m].PlaneLength);

    /// <summary>True if it cuts nothing in the plane XY of which it says where.</summary>
    public bool IsEmpty => _motions.Count == 0;

    /// <summary>True if the control offsets the tool along all of it, so that the path is the boundary; false if nowhere; null if along
    /// parts.</summary>
    public bool? IsCompensated
    {
        get
        {
            var compensated = _motions.Count(IsOffset);
            return compensated == 0 ? false : compensated == _motions.Count ? true : null;
        }
    }

    /// <summary>Its longest lines, each as it is traveled, those that several blocks cut joined; the longest first.</summary>
    public IReadOnlyList<CutLine> Lines()
    {
        var lines = new List<CutLine>();
        foreach (var m in _motions)
        {
            var motion = _path.Motions[m];
            if (motion.IsArc)
            {
                continue;
            }

            var (from, to) = (motion.PlaneStart, motion.PlaneEnd);
            if (lines.Count > 0 && lines[^1] is var last && last.IsCompensated == IsOffset(m)
                && last.To.DistanceTo(from) < SameLineMm && last.From.DistanceTo(to) > SameLineMm
                && last.Direction.Dot((to - last.From).Normalize()) > SameLineCosine
                && last.Direction.Dot((to - from).Normalize()) > SameLineCosine)
            {
                lines[^1] = last with { To = to };
            }
            else
            {
                lines.Add(new(from, to, IsOffset(m)));
            }
        }

        return [
            .. lines.Where(l => l.From.DistanceTo(l.To) >= LeastLineMm).DistinctBy(l => (Rounded(l.From), Rounded(l.To)))
                .OrderByDescending(l => l.From.DistanceTo(l.To)).Take(MostLines)];

        static (double, double) Rounded(Point2 p) => (Math.Round(p.X, 3), Math.Round(p.Y, 3));
    }

    /// <summary>The centers and radii of its arcs, each once.</summary>
    public IReadOnlyList<CutArc> Arcs() =>
        [
            .. _motions.Where(m => _path.Motions[m].IsArc)
                .Select(m => new CutArc(_path.Motions[m].Center, _path.Motions[m].Arc.Radius, IsOffset(m)))
                .DistinctBy(a => (Math.Round(a.Center.X, 2), Math.Round(a.Center.Y, 2), Math.Round(a.Radius, 2))).Take(MostLines)];

    /// <summary>The nearest place of it to a point; null if nothing is near.</summary>
    /// <param name="point">The point.</param>
    /// <param name="withinMm">How far it is looked for.</param>
    public CutFoot? FootOf(Point2 point, double withinMm)
    {
        if (IsEmpty)
        {
            return null;
        }

        CutFoot? best = null;
        var (x, y) = CellOf(point);

        // What lies in a square so many rings away is at least this far, less one square: also at the rim, where squares hold more. A cut
        // is in the squares of places half a square apart, so that a bit of it may be a quarter nearer.
        var rings = Math.Max(_cells.GetLength(0), _cells.GetLength(1));
        for (var ring = 0; ring < rings && (ring - 1.25) * _cellMm <= Math.Min(withinMm, best?.DistanceMm ?? withinMm); ring++)
        {
            for (var i = Math.Max(x - ring, 0); i <= Math.Min(x + ring, _cells.GetLength(0) - 1); i++)
            {
                var step = ring == 0 || Math.Abs(i - x) == ring ? 1 : 2 * ring;
                for (var j = y - ring; j <= y + ring; j += step)
                {
                    if (j >= 0 && j < _cells.GetLength(1) && _cells[i, j] is { } motions)
                    {
                        best = Nearest(motions, point, withinMm, best);
                    }
                }
            }
        }

        return best;
    }

    // Of two that are equally near, the first one in the program.
    private CutFoot? Nearest(List<int> motions, Point2 point, double withinMm, CutFoot? best)
    {
        foreach (var m in motions)
        {
            var motion = _path.Motions[m];
            var fraction = Math.Clamp(motion.IsArc ? motion.Arc.NearestFraction(point) : motion.Segment.NearestFraction(point), 0, 1);
            var at = motion.PlaneAt(fraction);
            var distance = at.DistanceTo(point);
            if (distance <= withinMm
                && (best is not { } last || distance < last.DistanceMm || (distance == last.DistanceMm && m < last.Motion)))
            {
                best = new(m, at, distance, IsOffset(m), motion.TangentAt(fraction).Left)
                {
                    IsToolRight = motion.Has(MotionFlags.CompensationRight),
                };
            }
        }

        return best;
    }

    private bool IsOffset(int motion) =>
        _path.Motions[motion].Has(MotionFlags.CompensationLeft | MotionFlags.CompensationRight);

    // An arc reaches beyond its ends, and a point may be anywhere: at the rim a square holds what is outside of it.
    private (int X, int Y) CellOf(Point2 at) => (
        (int)Math.Clamp((at.X - _corner.X) / _cellMm, 0, _cells.GetLength(0) - 1),
        (int)Math.Clamp((at.Y - _corner.Y) / _cellMm, 0, _cells.GetLength(1) - 1));
}

/// <summary>A line that is cut.</summary>
/// <param name="From">Its start.</param>
/// <param name="To">Its end.</param>
/// <param name="IsCompensated">True if the control offsets the tool along it.</param>
internal sealed record CutLine(Point2 From, Point2 To, bool IsCompensated)
{
    /// <summary>The unit direction of travel.</summary>
    public Vector2 Direction => (To - From).Normalize();
}

/// <summary>The circle of an arc that is cut.</summary>
/// <param name="Center">Its center.</param>
/// <param name="Radius">Its radius, mm.</param>
/// <param name="IsCompensated">True if the control offsets the tool along it.</param>
internal sealed record CutArc(Point2 Center, double Radius, bool IsCompensated);

/// <summary>The nearest place of a cut to a point.</summary>
/// <param name="Motion">Position of its motion in the path.</param>
/// <param name="At">The place.</param>
/// <param name="DistanceMm">Its distance.</param>
/// <param name="IsCompensated">True if the control offsets the tool there.</param>
/// <param name="Left">Unit vector to the left of the path there.</param>
internal readonly record struct CutFoot(int Motion, Point2 At, double DistanceMm, bool IsCompensated, Vector2 Left)
{
    /// <summary>True if the control offsets the tool to the right of the path.</summary>
    public bool IsToolRight { get; init; }

    /// <summary>The direction from a point of the boundary to the tool that cuts it there.</summary>
    /// <param name="boundary">The point whose foot this is.</param>
    public Vector2 ToTool(Point2 boundary) => !IsCompensated ? At - boundary : IsToolRight ? -Left : Left;
}
