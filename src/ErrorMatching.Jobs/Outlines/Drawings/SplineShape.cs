using ErrorMatching.Geometry;

namespace ErrorMatching.Jobs;

/// <summary>A B-spline in the plane, rational if it has weights.</summary>
/// <param name="Degree">Its degree.</param>
/// <param name="Knots">Nondecreasing, one more than poles and degree.</param>
/// <param name="Poles">Its control points.</param>
/// <param name="Weights">One positive number per pole; null for a nonrational curve.</param>
internal sealed record SplineShape(int Degree, double[] Knots, Point2[] Poles, double[]? Weights) : DrawnShape
{
    // A halved piece is about four times as flat.
    private const int MaxHalvings = 40;

    // A knot that is repeated once more than the degree leaves pieces that need not meet. Numbers of files are rounded, too.
    private const double MaxGapMm = 0.1 * DrawnCourse.ChordMm;

    // Poles may be outside the drawing, but a piece whose poles overflow would be halved without end.
    private const double MaxPoleMm = 1e9;

    /// <inheritdoc/>
    public override void Draw(in PlaneMap map, DrawingPen pen)
    {
        var poles = new Point3[Poles.Length];
        for (var i = 0; i < poles.Length; i++)
        {
            var (p, w) = (map.Of(Poles[i]), Weights?[i] ?? 1);
            poles[i] = new(p.X * w, p.Y * w, w);
        }

        List<Point2> points = [];
        var piece = new Point3[Degree + 1];
        for (var span = Degree; span < Poles.Length; span++)
        {
            if (Knots[span] < Knots[span + 1])
            {
                Piece(poles, span, piece);
                foreach (var pole in piece)
                {
                    pen.Check(Flat(pole), MaxPoleMm);
                }

                var start = Flat(piece[0]);
                if (points.Count == 0)
                {
                    Add(points, start, pen);
                }
                else if (!(points[^1].DistanceTo(start) <= MaxGapMm))
                {
                    throw pen.Fail("bad-spline", "pieces with a gap between them; one curve without a gap is expected");
                }

                Follow(piece, points, pen, MaxHalvings);
            }
        }

        pen.Course(points);
    }

    private static void Add(List<Point2> points, Point2 point, DrawingPen pen)
    {
        pen.Reserve(1);
        points.Add(pen.Check(point));
    }

    private static Point2 Flat(Point3 p) => new(p.X / p.Z, p.Y / p.Z);

    // A Bezier curve is within the hull of its poles, so their distance from the chord bounds its own.
    private static void Follow(Point3[] piece, List<Point2> points, DrawingPen pen, int halvings)
    {
        if (IsFlat(piece))
        {
            Add(points, Flat(piece[^1]), pen);
            return;
        }

        if (halvings == 0)
        {
            throw pen.Fail("bad-value", "weights or poles that differ too much; a curve with finite curvature is expected");
        }

        var (left, right) = (new Point3[piece.Length], (Point3[])piece.Clone());
        for (var i = 0; i < piece.Length; i++)
        {
            left[i] = right[0];
            for (var k = 0; k < piece.Length - 1 - i; k++)
            {
                right[k] = Between(right[k], right[k + 1], 0.5);
            }
        }

        // The last poles of each round stayed where they are: the right half from its start to its end.
        Follow(left, points, pen, halvings - 1);
        Follow(right, points, pen, halvings - 1);
    }

    private static bool IsFlat(Point3[] piece)
    {
        var (from, to) = (Flat(piece[0]), Flat(piece[^1]));
        var chord = to - from;
        var square = chord.Dot(chord);
        for (var i = 1; i < piece.Length - 1; i++)
        {
            var pole = Flat(piece[i]);
            var share = square > 0 ? Math.Clamp((pole - from).Dot(chord) / square, 0, 1) : 0;

            // Written so that a number that is none is flat and ends at the check of its point.
            if (pole.DistanceTo(from.Lerp(to, share)) > 0.9 * DrawnCourse.ChordMm)
            {
                return false;
            }
        }

        return true;
    }

    private static Point3 Between(Point3 a, Point3 b, double share) =>
        new(a.X + (share * (b.X - a.X)), a.Y + (share * (b.Y - a.Y)), a.Z + (share * (b.Z - a.Z)));

    // The Bezier poles of a span are values of the polynomial's polar form: pole j takes the span's end j times, its start otherwise.
    private void Piece(Point3[] poles, int span, Point3[] result)
    {
        Span<Point3> level = new Point3[Degree + 1];
        for (var j = 0; j <= Degree; j++)
        {
            poles.AsSpan(span - Degree, Degree + 1).CopyTo(level);
            for (var r = 1; r <= Degree; r++)
            {
                var t = r <= j ? Knots[span + 1] : Knots[span];
                for (var m = Degree; m >= r; m--)
                {
                    var (low, high) = (Knots[span - Degree + m], Knots[span + 1 + m - r]);
                    level[m] = Between(level[m - 1], level[m], (t - low) / (high - low));
                }
            }

            result[j] = level[Degree];
        }
    }
}
