namespace ErrorMatching.Geometry;

/// <summary>Proves for parts of a surface that a ball may roll over them: wherever in such a part it touches, on either side, no place of the whole surface lies within the ball.</summary>
/// <remarks>
/// A ball of radius R that touches at p, where the unit normal is n, holds a place q if n (q - p) exceeds |q - p|^2 / 2R. Follow the surface from p to q straight in the parameters: over a length L the normal turns by k L at most,
/// k being the largest normal curvature, so n (q - p) is at most k L^2 / 2; and where the directions of all such ways keep within an angle a, |q - p| is at least L cos a. So the ball is free if k R is at most cos^2 a over a rectangle of
/// parameters that holds the part and all that is nearer to it than 2 R; the ball does not reach farther (compare Blaschke's rolling theorem). Both are bounded over cells by derivatives up to the third (<see cref="DerivativeBounds"/>).
/// Where the proof fails, the ball may be free all the same.
/// </remarks>
public sealed class RollingBall
{
    // Cells whose first derivatives change by less than this part of them are not cut further: bounds hardly become better.
    private const double Steady = 0.1;

    private readonly SplineSurface _surface;
    private readonly double _radius;
    private readonly Part _root;

    /// <summary>A ball on a surface.</summary>
    /// <param name="surface">The surface, all of it within its knots.</param>
    /// <param name="radius">Radius of the ball, in millimetres.</param>
    public RollingBall(SplineSurface surface, double radius)
    {
        ArgumentNullException.ThrowIfNull(surface);
        (_surface, _radius, _root) = (surface, radius, new(surface.Cells));
    }

    /// <summary>The largest part around a pair of parameters over which the ball is proven to be free, from its lowest to its highest parameters; null if there is none. What was proven is kept: each thread needs its own.</summary>
    /// <param name="u">First parameter.</param>
    /// <param name="v">Second parameter.</param>
    public (Point2 From, Point2 To)? FreeAround(double u, double v)
    {
        for (var part = _root; ;)
        {
            var cell = part.Cell;
            if (part.IsFree ??= IsFree(cell))
            {
                return (cell.From, cell.To);
            }

            // All around the part, as far as the ball reaches, counts as well: a smaller part has hardly less to prove.
            if (cell.Box.Diagonal < 2 * _radius || part.Halves() is not { } halves)
            {
                return null;
            }

            part = u <= halves[0].Cell.To.X && v <= halves[0].Cell.To.Y ? halves[0] : halves[1];
        }
    }

    private bool IsFree(SurfaceCell part)
    {
        var (from, to) = (part.From, part.To);
        Reach(_root.Cell, part, ref from, ref to);
        if (HasEdge(_surface.KnotsU, from.X, to.X) || HasEdge(_surface.KnotsV, from.Y, to.Y))
        {
            return false;
        }

        var middle = from.Lerp(to, 0.5);
        var bend = new Bend(_surface.At(middle.X, middle.Y));
        return Follow(_root.Cell, from, to, ref bend) && IsFree(bend);
    }

    private bool IsFree(in Bend bend) => bend.Curvature * _radius <= bend.SquaredCosine;

    // The rectangle that holds a part, and every cell that the ball on it may reach.
    private void Reach(SurfaceCell cell, SurfaceCell part, ref Point2 from, ref Point2 to)
    {
        var isInside = cell.From.X >= from.X && cell.From.Y >= from.Y && cell.To.X <= to.X && cell.To.Y <= to.Y;
        if (isInside || cell.Box.DistanceTo(part.Box) >= 2 * _radius)
        {
            return;
        }

        if (cell.Box.Diagonal > Math.Max(_radius, part.Box.Diagonal) / 2 && cell.Children() is { } halves)
        {
            Reach(halves[0], part, ref from, ref to);
            Reach(halves[1], part, ref from, ref to);
            return;
        }

        from = new(Math.Min(from.X, cell.From.X), Math.Min(from.Y, cell.From.Y));
        to = new(Math.Max(to.X, cell.To.X), Math.Max(to.Y, cell.To.Y));
    }

    // A knot inside a range at which the tangent may break.
    private static bool HasEdge(KnotVector knots, double from, double to)
    {
        foreach (var knot in knots.Breaks)
        {
            if (knot > from && knot < to && knots.Multiplicity(knot) >= knots.Degree)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Takes all of a cell that is in a rectangle into account; false as soon as that proves nothing.</summary>
    private bool Follow(SurfaceCell cell, Point2 from, Point2 to, ref Bend bend)
    {
        if (cell.To.X <= from.X || cell.To.Y <= from.Y || cell.From.X >= to.X || cell.From.Y >= to.Y)
        {
            return true;
        }

        if (cell.IsPiece && cell.Unsteadiness <= Steady)
        {
            bend.Add(cell);
            return IsFree(bend);
        }

        return (!cell.IsPiece || cell.Box.Diagonal > _radius / 8) && cell.Children() is { } halves && Follow(halves[0], from, to, ref bend) && Follow(halves[1], from, to, ref bend);
    }

    /// <summary>A cell of the surface, and what is known of it.</summary>
    private sealed class Part(SurfaceCell cell)
    {
        private Part[]? _halves;

        public SurfaceCell Cell => cell;

        public bool? IsFree { get; set; }

        public Part[]? Halves() => _halves ??= cell.Children() is { } halves ? [new(halves[0]), new(halves[1])] : null;
    }

    /// <summary>How much the cells of a rectangle bend, and how far their tangents stray from those at one place.</summary>
    private struct Bend(SurfacePoint middle)
    {
        private readonly double _apart = OneLessCosine(middle.Du, middle.Dv);
        private double _strayU;
        private double _strayV;

        /// <summary>A normal curvature, in 1/mm, that none of the cells exceeds on either side.</summary>
        public double Curvature { get; private set; }

        /// <summary>Square of the cosine of an angle that the directions of no two straight ways in the parameters exceed, one of them through the middle.</summary>
        public readonly double SquaredCosine => 1 - (((_strayU * _strayU) + (_strayV * _strayV)) / _apart);

        public void Add(SurfaceCell cell)
        {
            var half = (cell.To - cell.From) * 0.5;
            var b = cell.Bounds;
            var (changeS, changeT) = (b[2, 0] + b[1, 1], b[1, 1] + b[0, 2]);
            _strayU = Math.Max(_strayU, ((cell.Center.Du - middle.Du).Length + (changeS / half.X)) / middle.Du.Length);
            _strayV = Math.Max(_strayV, ((cell.Center.Dv - middle.Dv).Length + (changeT / half.Y)) / middle.Dv.Length);

            // In lengths along both parameters; first derivatives are those of the center and changes of s and t.
            var (length, width) = (cell.Ds.Length, cell.Dt.Length);
            var (s, t) = (changeS / length, changeT / width);
            var least = Math.Sqrt(OneLessCosine(cell.Ds, cell.Dt)) - Math.Sqrt((s * s) + (t * t));
            var cross = cell.Ds.Cross(cell.Dt);
            var turn = (s + t + (s * t)) * length * width / cross.Length;
            if (!(least > 0 && turn < 1))
            {
                Curvature = double.PositiveInfinity;
                return;
            }

            var normal = cross * (1 / cross.Length);
            var off = Math.Sqrt(2 * (1 - Math.Sqrt(1 - (turn * turn))));
            var ss = Along(cell.Dss, b[3, 0] + b[2, 1]) / (length * length);
            var st = Along(cell.Dst, b[2, 1] + b[1, 2]) / (length * width);
            var tt = Along(cell.Dtt, b[1, 2] + b[0, 3]) / (width * width);
            var largest = ((ss + tt) / 2) + Math.Sqrt(((ss - tt) * (ss - tt) / 4) + (st * st));
            Curvature = Math.Max(Curvature, largest / (least * least));

            // What a second derivative has along any normal of the cell, at most.
            double Along(Vector3 second, double change) => Math.Abs(second.Dot(normal)) + change + (off * (second.Length + change));
        }

        // The square of a sum a x + b y of unit vectors is at least this times x^2 + y^2.
        private static double OneLessCosine(Vector3 a, Vector3 b) => 1 - (Math.Abs(a.Dot(b)) / (a.Length * b.Length));
    }
}
