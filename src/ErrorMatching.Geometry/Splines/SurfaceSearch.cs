namespace ErrorMatching.Geometry;

/// <summary>
/// One search for the closest place of a surface: branch and bound over a tree of cells. A cell is left aside when its bound says that nothing in it is closer by more than the tolerance; it is finished when the squared
/// distance is proven convex in it, by descent to its only minimum; else it is cut in two.
/// </summary>
internal struct SurfaceSearch(Point3 point, double tolerance)
{
    // Only where very many places are equally close (a point in the center of a sphere) are there so many cells: then the accuracy says what was reached.
    private const int MaxCells = 5_000;

    private double _distance = double.PositiveInfinity;
    private SurfacePoint _at;

    // True if descent ended at the place; one from the middle of a cell may be good enough for the tolerance, yet it is no foot.
    private bool _settled;
    private double _bound = double.PositiveInfinity;
    private int _cells;

    /// <summary>The closest place, beginning at a pair of parameters.</summary>
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

    /// <summary>Looks at cells in the order of their bounds until none can hold anything closer.</summary>
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

    /// <summary>Descends in a cell in which the squared distance is convex, and bounds it from below by its tangent plane where descent ended.</summary>
    private double Finish(SurfaceCell cell)
    {
        var surface = cell.Surface;

        // On a border, derivatives may be those of the cell beyond a crease.
        var inside = _at.U > surface.KnotsU.Start && _at.U < surface.KnotsU.End && _at.V > surface.KnotsV.Start && _at.V < surface.KnotsV.End;
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
