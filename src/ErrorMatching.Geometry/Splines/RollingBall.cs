namespace ErrorMatching.Geometry;

/// <summary>Proves that a ball may roll over parts of a surface: wherever it touches such a part, on either side, no point of the whole
/// surface is inside the ball.</summary>
/// <remarks>A ball of radius R that touches at p with unit normal n contains a point q if n (q - p) exceeds |q - p|^2 / 2R. Follow the
/// surface from p to q along a straight line in the parameters. Over a length L, the normal turns by at most k L, where k is the largest
/// normal curvature, so n (q - p) is at most k L^2 / 2. If the directions of all such paths are within an angle a, |q - p| is at least L
/// cos a. So the ball is free if k R is at most cos^2 a over a rectangle of parameters that contains the part and everything nearer to it
/// than 2 R; the ball does not reach farther (compare Blaschke's rolling theorem). Both quantities are bounded over cells by derivatives up
/// to the third order (<see cref="DerivativeBounds"/>). If the proof fails, the ball may still be free.</remarks>
public sealed class RollingBall
{
    // Cells whose first derivatives change by a smaller share are not halved further, because the bounds would hardly improve.
    private const double Steady = 0.1;

    private readonly SplineSurface _surface;
    private readonly double _radius;
    private readonly Part _root;

    /// <summary>Prepares proofs for a ball on a surface.</summary>
    /// <param name="surface">The surface over its full knot range.</param>
    /// <param name="radius">Radius of the ball, in millimeters.</param>
    public RollingBall(SplineSurface surface, double radius)
    {
        ArgumentNullException.ThrowIfNull(surface);
        (_surface, _radius, _root) = (surface, radius, new(surface.Cells));
    }

    /// <summary>The largest part around a pair of parameters over which the ball is proven to be free, from its lowest to its highest
    /// parameters; null if there is none. Proofs are cached, so each thread needs its own instance.</summary>
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

            // The proof also covers everything around the part within reach of the ball, so a smaller part would hardly be easier.
            if (cell.Box.Diagonal < 2 * _radius || part.TwoThreads() is not { } halves)
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

    // The rectangle that contains a part and every cell within reach of a ball on it.
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

    // True if the tangent may break at a knot inside a range.
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

    /// <summary>Includes the parts of a cell inside a rectangle; false as soon as the proof fails.</summary>
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

        return (!cell.IsPiece || cell.Box.Diagonal > _radius / 8)
            && cell.Children() is { } halves
            && Follow(halves[0], from, to, ref bend)
            && Follow(halves[1], from, to, ref bend);
    }

    /// <summary>A cell of the surface with its proof.</summary>
    private sealed class Part(SurfaceCell cell)
    {
        private Part[]? _halves;

        public SurfaceCell Cell => cell;

        public bool? IsFree { get; set; }

        public Part[]? TwoThreads() => _halves ??= cell.Children() is { } halves ? [new(halves[0]), new(halves[1])] : null;
    }

    /// <summary>Bounds the curvature in the cells of a rectangle, and the deviation of their tangents from those at one place.</summary>
    private struct Bend(SurfacePoint middle)
    {
        private readonly double _apart = OneLessCosine(middle.Du, middle.Dv);
        private double _strayU;
        private double _strayV;

        /// <summary>A bound of the normal curvature of all cells on either side, in 1/mm.</summary>
        public double Curvature { get; private set; }

        /// <summary>Square of the cosine of a bound of the angle between any two straight paths in the parameters, one of them through the
        /// middle.</summary>
        public readonly double SquaredCosine => 1 - (((_strayU * _strayU) + (_strayV * _strayV)) / _apart);

        public void Add(SurfaceCell cell)
        {
            var half = (cell.To - cell.From) * 0.5;
            var b = cell.Bounds;
            var (changeS, changeT) = (b[2, 0] + b[1, 1], b[1, 1] + b[0, 2]);
            _strayU = Math.Max(_strayU, ((cell.Center.Du - middle.Du).Length + (changeS / half.X)) / middle.Du.Length);
            _strayV = Math.Max(_strayV, ((cell.Center.Dv - middle.Dv).Length + (changeT / half.Y)) / middle.Dv.Length);

            // In lengths along both parameters. First derivatives are the values at the center and the changes in s and t.
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

            // A bound of a second derivative's component along any normal of the cell.
            double Along(Vector3 second, double change) => Math.Abs(second.Dot(normal)) + change + (off * (second.Length + change));
        }

        // The square of a sum a x + b y of unit vectors is at least this value times x^2 + y^2.
        private static double OneLessCosine(Vector3 a, Vector3 b) => 1 - (Math.Abs(a.Dot(b)) / (a.Length * b.Length));
    }
}
