namespace ErrorMatching.Geometry;

/// <summary>Finds all intersections of a line with a surface, using the tree of cells. A cell is skipped if its bound proves that the line
/// misses it. If the surface, seen along the line, provably has no overlaps, Newton's method finds the only hit; otherwise the cell is
/// halved.</summary>
internal sealed class LineSearch(Point3 from, Vector3 direction)
{
    private const int MaxCells = 5_000;
    private const int MaxSteps = 20;

    // A line may touch the surface without crossing it. A gap this small counts as a touch.
    private const double Touch = 1e-9;

    // The place of a touch is known only to the square root of that.
    private const double TouchSize = 1e-3;

    // Below this square of the sine, the width of a surface seen along the line has no significant digits.
    private const double Flat = 1e-12;

    private readonly List<(SurfaceHit Hit, bool Touches)> _hits = [];
    private int _cells;

    /// <summary>Returns the hits by their distance along the line.</summary>
    /// <exception cref="GeometryException">The line runs along the surface.</exception>
    public IReadOnlyList<SurfaceHit> Run(SurfaceCell root)
    {
        Visit(root);
        var hits = new List<SurfaceHit>();
        foreach (var (hit, touches) in _hits.OrderBy(h => h.Touches).ThenBy(h => h.Hit.Along))
        {
            // A hit on the border of two cells is found in both, a touch in all surrounding ones.
            if (hits.TrueForAll(h => (h.At.Position - hit.At.Position).Length > (touches ? 2 * TouchSize : 10 * Touch)))
            {
                hits.Add(hit);
            }
        }

        return [.. hits.OrderBy(h => h.Along)];
    }

    private Vector3 Across(Vector3 v) => v - (direction * v.Dot(direction));

    private void Visit(SurfaceCell cell)
    {
        if (++_cells > MaxCells)
        {
            throw new GeometryException(GeometryError.NearParallel, "the line runs along the surface; a line that crosses it is expected");
        }

        if (PassesBy(cell) || (cell.IsPiece && Decide(cell)))
        {
            return;
        }

        if (cell.Children() is { } halves)
        {
            Visit(halves[0]);
            Visit(halves[1]);
        }
    }

    private bool PassesBy(SurfaceCell cell)
    {
        var half = 0.5 * cell.Box.Diagonal;
        var middle = cell.Box.Min + ((cell.Box.Max - cell.Box.Min) * 0.5);
        return Across(middle - from).Length > half + Touch
            || (
                cell.IsPiece
                    && SurfaceCell.DistanceToParallelogram(
                        Across(from - cell.Center.Position), Across(cell.Ds), Across(cell.Dt)) > cell.OffPlane
                        + Touch);
    }

    /// <summary>True if the piece need not be halved.</summary>
    private bool Decide(SurfaceCell cell)
    {
        var b = cell.Bounds;
        // Seen along the line. Bounds on the change of the columns Ds and Dt within the cell follow.
        var (s, t) = (Across(cell.Ds), Across(cell.Dt));
        var (e, f, g) = (s.Dot(s), s.Dot(t), t.Dot(t));
        var smallest = 0.5 * (e + g - Math.Sqrt(((e - g) * (e - g)) + (4 * f * f)));
        var (changeS, changeT) = (b[2, 0] + b[1, 1], b[1, 1] + b[0, 2]);
        if (smallest > (changeS * changeS) + (changeT * changeT) + (Flat * (e + g)))
        {
            return Newton(cell);
        }

        var size = b[1, 0] + b[0, 1];
        if (size < Touch || (size < TouchSize && cell.OffPlane < Touch))
        {
            _hits.Add((Hit(cell.Center), true));
            return true;
        }

        return false;
    }

    private bool Newton(SurfaceCell cell)
    {
        var (u, v) = (cell.Surface.KnotsU, cell.Surface.KnotsV);
        var (slackU, slackV) = (1e-12 * (u.End - u.Start), 1e-12 * (v.End - v.Start));
        var at = cell.Center;
        for (var i = 0; i < MaxSteps; i++)
        {
            var r = Across(at.Position - from);
            var (a, b) = (Across(at.Du), Across(at.Dv));
            var (e, f, g) = (a.Dot(a), a.Dot(b), b.Dot(b));
            var (x, y) = (r.Dot(a), r.Dot(b));
            var det = (e * g) - (f * f);
            var next = (U: at.U - (((g * x) - (f * y)) / det), V: at.V - (((e * y) - (f * x)) / det));
            if (!(Math.Abs(next.U - at.U) <= u.End - u.Start && Math.Abs(next.V - at.V) <= v.End - v.Start))
            {
                return false;
            }

            var step = (at.Du * (next.U - at.U)).Length + (at.Dv * (next.V - at.V)).Length;
            at = cell.Surface.At(next.U, next.V);
            if (step < 1e-12)
            {
                if (at.U < u.Start - slackU || at.U > u.End + slackU || at.V < v.Start - slackV || at.V > v.End + slackV)
                {
                    return false;
                }

                _hits.Add((Hit(cell.Surface.At(Math.Clamp(at.U, u.Start, u.End), Math.Clamp(at.V, v.Start, v.End))), false));
                return true;
            }
        }

        return false;
    }

    private SurfaceHit Hit(SurfacePoint at) => new(at, (at.Position - from).Dot(direction));
}
