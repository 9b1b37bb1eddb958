using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Follows a guide in the parameters with centers of the ball. The curvature of the centers' curve determines the steps.</summary>
/// <remarks>The deviation of the curve from its chord is |Δ²C''| / 8 (at the middle, to second order), where Δ²C'' is Δ times the
/// difference of the exact derivatives at both ends. Steps are chosen by this formula. The finished polyline is then measured
/// (<see cref="CenterLine.MeasureChord"/>).</remarks>
internal sealed class PassBuilder(OffsetSurface offset, CenterRounding rounding, double chordMm, double liftMm)
{
    /// <summary>The part of the scallop that a chord out of the material may take:
    /// with as much for the ridge, the path has the fewest points.</summary>
    public const double LiftShare = 0.4;

    private const int Attempts = 24;

    // Steps of fewer increments are not made shorter: rounding would turn them round.
    private const double Shortest = 40;

    // So close before a knot that the place is the same, and the derivatives are still those before it.
    private const double JustBefore = 1 - 1e-9;

    private readonly double[] _breaksU = Breaks(offset.Surface.Spline.KnotsU);
    private readonly double[] _breaksV = Breaks(offset.Surface.Spline.KnotsV);
    private readonly List<double> _cuts = [];

    public void Build(CutPiece piece, CenterLine into)
    {
        into.Clear();
        for (var i = 0; i + 1 < piece.Guide.Count; i++)
        {
            var (a, b) = (piece.Guide[i], piece.Guide[i + 1]);
            var from = 0.0;
            foreach (var to in Cuts(a, b))
            {
                Walk(piece, a, b, from, to, into);
                from = to;
            }
        }
    }

    /// <summary>Knots at which the curvature or tangent of a surface may break; steps end there.</summary>
    private static double[] Breaks(KnotVector knots) => [.. knots.Breaks.Where(k => knots.Multiplicity(k) >= knots.Degree - 1)];

    // Where a straight guide crosses such knots, as fractions of its length, and its end.
    private List<double> Cuts(Point2 a, Point2 b)
    {
        _cuts.Clear();
        Add(_breaksU, a.X, b.X);
        Add(_breaksV, a.Y, b.Y);
        _cuts.Sort();
        for (var i = _cuts.Count - 1; i > 0; i--)
        {
            if (_cuts[i] - _cuts[i - 1] < 1e-9)
            {
                _cuts.RemoveAt(i);
            }
        }

        _cuts.Add(1);
        return _cuts;

        void Add(double[] knots, double from, double to)
        {
            foreach (var knot in knots)
            {
                var t = (knot - from) / (to - from);
                if (t > 1e-9 && t < 1 - 1e-9)
                {
                    _cuts.Add(t);
                }
            }
        }
    }

    private void Walk(CutPiece piece, Point2 a, Point2 b, double from, double to, CenterLine into)
    {
        var d = b - a;
        var place = a.Lerp(b, from);
        var p = offset.Moving(place.X, place.Y, d);
        var longest = Math.Min(
            to - from, Math.Max((to - from) * piece.LongestStep, 5 * Shortest * rounding.IncrementMm / Math.Max(p.Velocity.Length, 1e-9)));
        var (t, step) = (from, longest);
        if (into.Count == 0)
        {
            into.Add(place, rounding.Nearest(p.Center), p.Normal);
        }

        var off = CenterRounding.Across(into.Centers[^1] - p.Center, Direction(p.Velocity));

        while (t < to)
        {
            for (var attempt = 0; ; attempt++)
            {
                var left = to - t;
                var h = step >= left ? left : step > left / 2 ? left / 2 : step;
                var isLast = h >= left;
                var next = isLast ? to : t + h;
                var exact = a.Lerp(b, isLast ? from + ((to - from) * JustBefore) : next);
                var q = offset.Moving(exact.X, exact.Y, d);
                var direction = Direction(q.Center - p.Center);
                var bend = (q.Velocity - p.Velocity) * (h / 8);
                bend -= direction * bend.Dot(direction);
                var (sag, lift) = (piece.Finer * bend.Length, piece.Finer * bend.Dot(q.Normal));
                var room = Math.Max(chordMm - Math.Max(off, rounding.ReserveMm), 0.1 * chordMm);
                var share = Math.Min(room / Math.Max(sag, 1e-12), lift > 0 ? liftMm / lift : double.MaxValue);
                var mayShrink = attempt < Attempts && (q.Center - p.Center).Length > Shortest * rounding.IncrementMm;
                if (share < 1 && mayShrink)
                {
                    step = h * Math.Max(0.1, 0.95 * Math.Sqrt(share));
                    continue;
                }

                var across = 0.0;
                var isEnd = isLast && to == 1;
                var center = isEnd ? rounding.Nearest(q.Center) : rounding.Along(q.Center, Direction(q.Velocity), q.Normal, out across);
                across = isEnd ? CenterRounding.Across(center - q.Center, Direction(q.Velocity)) : across;
                var worst = Math.Max(across, off);
                if (sag + worst > chordMm && mayShrink)
                {
                    step = h * Math.Max(0.3, 0.95 * Math.Sqrt(Math.Max(0, chordMm - worst) / sag));
                    continue;
                }

                into.Add(isLast ? a.Lerp(b, to) : exact, center, q.Normal);
                (t, p, off) = (next, q, across);
                step = Math.Min(longest, h * Math.Min(2, 0.97 * Math.Sqrt(share)));
                break;
            }
        }
    }

    private static Vector3 Direction(Vector3 v)
    {
        var length = v.Length;
        return length > 0 ? v * (1 / length) : Vector3.Zero;
    }
}
