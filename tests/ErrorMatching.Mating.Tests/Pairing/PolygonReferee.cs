namespace ErrorMatching.Mating.Tests;

/// <summary>A polygon in a polygonal pocket by exact distances of all vertices from all edges, and golden section searches inside one
/// another. Shares no code with what it judges.</summary>
internal sealed class PolygonReferee
{
    // An overlap is measured in a pocket that is wider by this much everywhere.
    private const double Wider = 0.1, Reach = 0.12, Turn = 0.008, Beside = 1;

    private readonly (double X, double Y)[] _pocket, _part, _moved;
    private readonly (double X, double Y) _center;
    private (double X, double Y)[] _now;
    private double _wider;

    public PolygonReferee((double X, double Y)[] pocket, (double X, double Y)[] part, Geometry.Point2 center)
    {
        (_pocket, _part, _center) = (pocket, part, (center.X, center.Y));
        (_moved, _now) = (new (double, double)[part.Length], pocket);
    }

    /// <summary>The most air that a motion leaves at the tightest place.</summary>
    public double MostAir()
    {
        (_now, _wider) = (_pocket, 0);
        var best = Search();
        if (best > 0)
        {
            return best;
        }

        (_now, _wider) = (Grown(Wider), Wider);
        return Search();

        double Search() => Golden(-Turn, Turn, 17, w => Golden(-Reach, Reach, 17, x => Golden(-Reach, Reach, 17, y => AirAt(x, y, w))));
    }

    /// <summary>The most air where one part of the motion is given: 0 for x, 1 for y, 2 for the turn.</summary>
    public double MostAir(int part, double at)
    {
        (_now, _wider) = (_pocket, 0);
        return part switch
        {
            0 => Golden(-Turn, Turn, 24, w => Golden(-Reach, Reach, 24, y => AirAt(at, y, w))),
            1 => Golden(-Turn, Turn, 24, w => Golden(-Reach, Reach, 24, x => AirAt(x, at, w))),
            _ => Golden(-Reach, Reach, 24, x => Golden(-Reach, Reach, 24, y => AirAt(x, y, at))),
        };
    }

    /// <summary>The air at the tightest place after a motion.</summary>
    public double AirAt(double x, double y, double turn)
    {
        var (sine, cosine) = Math.SinCos(turn);
        for (var i = 0; i < _part.Length; i++)
        {
            _moved[i] = Moved(_part[i], x, y, sine, cosine);
        }

        var least = double.PositiveInfinity;
        foreach (var vertex in _moved)
        {
            least = Math.Min(least, Inside(vertex, _now));
        }

        foreach (var vertex in _now)
        {
            least = Math.Min(least, -Inside(vertex, _moved));
        }

        return least - _wider;
    }

    /// <summary>The air at a place of the part after a motion, or at the pocket's corner beside it.</summary>
    public double AirOf(Geometry.Point2 place, double x, double y, double turn)
    {
        AirAt(x, y, turn);
        var (sine, cosine) = Math.SinCos(turn);
        var moved = Moved((place.X, place.Y), x, y, sine, cosine);
        var corners = _now.Where(v => Math.Max(Math.Abs(v.X - moved.X), Math.Abs(v.Y - moved.Y)) < Beside);
        return corners.Select(v => -Inside(v, _moved)).Append(Inside(moved, _now)).Min() - _wider;
    }

    private (double X, double Y) Moved((double X, double Y) p, double x, double y, double sine, double cosine)
    {
        var (dx, dy) = (p.X - _center.X, p.Y - _center.Y);
        return (_center.X + (dx * cosine) - (dy * sine) + x, _center.Y + (dx * sine) + (dy * cosine) + y);
    }

    // Distance from the edges, negative outside.
    private static double Inside((double X, double Y) p, (double X, double Y)[] polygon)
    {
        var (nearest, isInside) = (double.PositiveInfinity, false);
        for (var i = 0; i < polygon.Length; i++)
        {
            var (a, b) = (polygon[i], polygon[i + 1 == polygon.Length ? 0 : i + 1]);
            var (ex, ey, px, py) = (b.X - a.X, b.Y - a.Y, p.X - a.X, p.Y - a.Y);
            var f = Math.Clamp(((px * ex) + (py * ey)) / ((ex * ex) + (ey * ey)), 0, 1);
            var (dx, dy) = (px - (f * ex), py - (f * ey));
            nearest = Math.Min(nearest, (dx * dx) + (dy * dy));
            isInside ^= a.Y > p.Y != b.Y > p.Y && px < ex * py / ey;
        }

        return isInside ? Math.Sqrt(nearest) : -Math.Sqrt(nearest);
    }

    // Each edge outward, neighbors met again.
    private (double X, double Y)[] Grown(double by)
    {
        var n = _pocket.Length;
        var lines = _pocket.Select((a, i) =>
        {
            var b = _pocket[(i + 1) % n];
            var (x, y) = (b.X - a.X, b.Y - a.Y);
            var length = Math.Sqrt((x * x) + (y * y));
            return (X: a.X + (by * y / length), Y: a.Y - (by * x / length), Dx: x, Dy: y);
        }).ToArray();
        return [.. lines.Select((l, i) =>
        {
            var k = lines[(i + n - 1) % n];
            var t = (((l.X - k.X) * l.Dy) - ((l.Y - k.Y) * l.Dx)) / ((k.Dx * l.Dy) - (k.Dy * l.Dx));
            return (k.X + (t * k.Dx), k.Y + (t * k.Dy));
        })];
    }

    private static double Golden(double from, double to, int steps, Func<double, double> value)
    {
        const double share = 0.6180339887498949;
        var (a, b) = (to - (share * (to - from)), from + (share * (to - from)));
        var (va, vb) = (value(a), value(b));
        for (var i = 2; i < steps; i++)
        {
            if (va > vb)
            {
                (to, b, vb) = (b, a, va);
                a = to - (share * (to - from));
                va = value(a);
            }
            else
            {
                (from, a, va) = (a, b, vb);
                b = from + (share * (to - from));
                vb = value(b);
            }
        }

        return Math.Max(va, vb);
    }
}
