namespace ErrorMatching.Geometry;

/// <summary>Searches the closest point of a surface by branch and bound over a tree of cells. A cell is skipped if its bound proves that
/// nothing in it is closer by more than the tolerance. If the squared distance is provably convex in it, descent finds the only minimum;
/// otherwise it is halved.</summary>
internal struct SurfaceSearch(Point3 point, double tolerance)
{
    // So many cells occur only if very many places are equally close (a point at the center of a sphere). The accuracy states the result.
    private const int MaxCells = 5_000;

    private double _distance = double.PositiveInfinity;
    private SurfacePoint _at;

    // True if descent ended at the place. The center of a cell may be within the tolerance, but it is not a foot.
    private bool _settled;
    private double _bound = double.PositiveInfinity;
    private int _cells;

    /// <summary>Finds the closest point, optionally starting at a pair of parameters.</summary>
    public static SurfaceFoot Run(SplineSurface surface, SurfaceCell root, Point3 point, double tolerance, (double U, double V)? hint)
    {
        var search = new SurfaceSearch(point, tolerance);
        if (hint is { } start)
        {
            search.Offer(SurfaceDescent.From(surface, point, start.U, start.V), settled: true);
        }

        search.Visit(root);
        if (!search._settled)
        {
            search.Offer(SurfaceDescent.From(surface, point, search._at.U, search._at.V), settled: true);
        }

        var offset = point - search._at.Position;
        return new(search._at, offset, Math.Max(0, offset.Length - search._bound));
    }

    /// <summary>Examines cells in the order of their bounds until none can contain a closer point.</summary>
    private void Visit(SurfaceCell root)
    {
        var open = new PriorityQueue<SurfaceCell, double>(32);
        Keep(open, root, root.DistanceBound(point));
        while (open.TryDequeue(out var cell, out var bound))
        {
            if (bound >= _distance - tolerance || ++_cells > MaxCells)
            {
                _bound = Math.Min(_bound, bound);
                return;
            }

            if (cell.IsPiece)
            {
                Offer(cell.Center, settled: false);
                bound = cell.IsConvexFrom(point) ? Math.Max(bound, Finish(cell)) : bound;
            }

            if (bound < _distance - tolerance && cell.Children() is { } halves)
            {
                Keep(open, halves[0], Math.Max(bound, halves[0].DistanceBound(point)));
                Keep(open, halves[1], Math.Max(bound, halves[1].DistanceBound(point)));
            }
            else
            {
                _bound = Math.Min(_bound, bound);
            }
        }
    }

    private void Keep(PriorityQueue<SurfaceCell, double> open, SurfaceCell cell, double bound)
    {
        if (bound < _distance - tolerance)
        {
            open.Enqueue(cell, bound);
        }
        else
        {
            _bound = Math.Min(_bound, bound);
        }
    }

    /// <summary>Descends in a cell in which the squared distance is convex, and returns a lower bound from the tangent plane at the end of
    /// the descent.</summary>
    private double Finish(SurfaceCell cell)
    {
        var surface = cell.Surface;

        // On a border, derivatives may be those of the cell beyond a crease.
        var inside = _at.U > surface.KnotsU.Start
            && _at.U < surface.KnotsU.End
            && _at.V > surface.KnotsV.Start
            && _at.V < surface.KnotsV.End;
        var at = _at;
        if (!_settled || !inside)
        {
            at = SurfaceDescent.From(surface, point, _at.U, _at.V);
            Offer(at, settled: true);
        }

        var d = at.Position - point;
        var (gu, gv) = (d.Dot(at.Du), d.Dot(at.Dv));
        var square = d.Dot(d)
            + (2 * gu * ((gu > 0 ? surface.KnotsU.Start : surface.KnotsU.End) - at.U))
            + (2 * gv * ((gv > 0 ? surface.KnotsV.Start : surface.KnotsV.End) - at.V));
        return Math.Sqrt(Math.Max(0, square));
    }

    private void Offer(in SurfacePoint at, bool settled)
    {
        var distance = (at.Position - point).Length;
        if (distance < _distance)
        {
            (_distance, _at, _settled) = (distance, at, settled);
        }
    }
}
