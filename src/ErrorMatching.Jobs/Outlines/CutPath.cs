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
    private readonly Dictionary<(int X, int Y), List<int>> _cells = [];
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

        _cellMm = _motions.Count == 0 ? 1 : Math.Max(LeastCellMm, Math.Max(right - left, high - low) / CellsAlong);
        foreach (var m in _motions)
        {
            var steps = 1 + (int)Math.Min(100_000, path.Motions[m].PlaneLength / _cellMm * 2);
            for (var k = 0; k <= steps; k++)
            {
                var cell = CellOf(path.Motions[m].PlaneAt((double)k / steps));
                if (!_cells.TryGetValue(cell, out var list))
                {
                    _cells[cell] = list = [];
                }

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
        CutFoot? best = null;
        var (x, y) = CellOf(point);
        var reach = (int)Math.Ceiling(withinMm / _cellMm) + 1;
        for (var i = x - reach; i <= x + reach; i++)
        {
            for (var j = y - reach; j <= y + reach; j++)
            {
                foreach (var m in _cells.GetValueOrDefault((i, j)) ?? [])
                {
                    var motion = _path.Motions[m];
                    var fraction = Math.Clamp(
                        motion.IsArc ? motion.Arc.NearestFraction(point) : motion.Segment.NearestFraction(point), 0, 1);
                    var at = motion.PlaneAt(fraction);
                    var distance = at.DistanceTo(point);
                    if (distance <= withinMm && (best is null || distance < best.Value.DistanceMm))
                    {
                        best = new(m, at, distance, IsOffset(m), motion.TangentAt(fraction).Left);
                    }
                }
            }
        }

        return best;
    }

    private bool IsOffset(int motion) =>
        _path.Motions[motion].Has(MotionFlags.CompensationLeft | MotionFlags.CompensationRight);

    private (int X, int Y) CellOf(Point2 at) => ((int)Math.Floor(at.X / _cellMm), (int)Math.Floor(at.Y / _cellMm));
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
internal readonly record struct CutFoot(int Motion, Point2 At, double DistanceMm, bool IsCompensated, Vector2 Left);
