using System.Diagnostics.CodeAnalysis;
using Avalonia;
using Avalonia.Media;
using Avalonia.Platform;

namespace ErrorMatching.Hmi.Platform;

/// <summary>A path as a list of segments; Cairo computes its properties on a scratch context.</summary>
internal class CairoGeometry : IGeometryImpl
{
    internal enum Op : byte { Move, Line, Curve, Close }
    internal readonly record struct Segment(Op Op, Point A, Point B, Point C);

    [ThreadStatic] private static nint t_scratch;
    internal static nint Scratch
    {
        get
        {
            if (t_scratch == 0) t_scratch = LibCairo.cairo_create(LibCairo.cairo_image_surface_create(LibCairo.FormatA8, 1, 1));
            LibCairo.cairo_new_path(t_scratch);
            return t_scratch;
        }
    }

    internal List<Segment> Segments { get; init; } = [];
    internal FillRule FillRule { get; set; } = FillRule.EvenOdd;
    private List<(Point P, bool Start)>? _flat;

    // ---- building
    public CairoGeometry Move(Point p) { Segments.Add(new(Op.Move, p, default, default)); return this; }
    public CairoGeometry Line(Point p) { Segments.Add(new(Op.Line, p, default, default)); return this; }
    public CairoGeometry Curve(Point a, Point b, Point c) { Segments.Add(new(Op.Curve, a, b, c)); return this; }
    public CairoGeometry Close() { Segments.Add(new(Op.Close, default, default, default)); return this; }

    public static CairoGeometry Rectangle(Rect r) =>
        new CairoGeometry().Move(r.TopLeft).Line(r.TopRight).Line(r.BottomRight).Line(r.BottomLeft).Close();

    public static CairoGeometry Ellipse(Rect r)
    {
        const double k = 0.5522847498307936;
        double cx = r.Center.X, cy = r.Center.Y, rx = r.Width / 2, ry = r.Height / 2;
        return new CairoGeometry().Move(new(cx + rx, cy))
            .Curve(new(cx + rx, cy + k * ry), new(cx + k * rx, cy + ry), new(cx, cy + ry))
            .Curve(new(cx - k * rx, cy + ry), new(cx - rx, cy + k * ry), new(cx - rx, cy))
            .Curve(new(cx - rx, cy - k * ry), new(cx - k * rx, cy - ry), new(cx, cy - ry))
            .Curve(new(cx + k * rx, cy - ry), new(cx + rx, cy - k * ry), new(cx + rx, cy)).Close();
    }

    public static CairoGeometry Rounded(RoundedRect rr)
    {
        const double k = 1 - 0.5522847498307936;
        var r = rr.Rect;
        Vector tl = rr.RadiiTopLeft, tr = rr.RadiiTopRight, br = rr.RadiiBottomRight, bl = rr.RadiiBottomLeft;
        // Radii that do not fit are scaled down together, as in CSS.
        var f = 1.0;
        void Fit(double sum, double room) { if (sum > room && sum > 0) f = Math.Min(f, room / sum); }
        Fit(tl.X + tr.X, r.Width); Fit(bl.X + br.X, r.Width); Fit(tl.Y + bl.Y, r.Height); Fit(tr.Y + br.Y, r.Height);
        tl *= f; tr *= f; br *= f; bl *= f;
        return new CairoGeometry().Move(new(r.X + tl.X, r.Y)).Line(new(r.Right - tr.X, r.Y))
            .Curve(new(r.Right - k * tr.X, r.Y), new(r.Right, r.Y + k * tr.Y), new(r.Right, r.Y + tr.Y)).Line(new(r.Right, r.Bottom - br.Y))
            .Curve(
                new(r.Right, r.Bottom - k * br.Y),
                new(r.Right - k * br.X, r.Bottom),
                new(r.Right - br.X, r.Bottom)).Line(new(r.X + bl.X, r.Bottom))
            .Curve(new(r.X + k * bl.X, r.Bottom), new(r.X, r.Bottom - k * bl.Y), new(r.X, r.Bottom - bl.Y)).Line(new(r.X, r.Y + tl.Y))
            .Curve(new(r.X, r.Y + k * tl.Y), new(r.X + k * tl.X, r.Y), new(r.X + tl.X, r.Y)).Close();
    }

    public static CairoGeometry Group(FillRule rule, IEnumerable<IGeometryImpl> children)
        => new() { FillRule = rule, Segments = [.. children.OfType<CairoGeometry>().SelectMany(c => c.Segments)] };

    internal static unsafe CairoGeometry FromPath(nint cr)
    {
        var geometry = new CairoGeometry { FillRule = FillRule.NonZero };
        var path = LibCairo.cairo_copy_path(cr);
        for (var i = 0; i < path->Count;)
        {
            var type = *(int*)&path->Data[i * 2];
            var length = ((int*)&path->Data[i * 2])[1];
            Point P(int n) => new(path->Data[(i + n) * 2], path->Data[(i + n) * 2 + 1]);
            switch (type)
            {
                case 0: geometry.Move(P(1)); break;
                case 1: geometry.Line(P(1)); break;
                case 2: geometry.Curve(P(1), P(2), P(3)); break;
                default: geometry.Close(); break;
            }
            i += length;
        }
        LibCairo.cairo_path_destroy(path);
        return geometry;
    }

    // ---- replaying
    public void AddTo(nint cr)
    {
        LibCairo.cairo_set_fill_rule(cr, FillRule == FillRule.EvenOdd ? LibCairo.FillEvenOdd : LibCairo.FillWinding);
        foreach (var s in Segments)
            switch (s.Op)
            {
                case Op.Move: LibCairo.cairo_move_to(cr, s.A.X, s.A.Y); break;
                case Op.Line: LibCairo.cairo_line_to(cr, s.A.X, s.A.Y); break;
                case Op.Curve: LibCairo.cairo_curve_to(cr, s.A.X, s.A.Y, s.B.X, s.B.Y, s.C.X, s.C.Y); break;
                default: LibCairo.cairo_close_path(cr); break;
            }
    }

    internal static void ApplyPen(nint cr, IPen pen)
    {
        LibCairo.cairo_set_line_width(cr, pen.Thickness);
        LibCairo.cairo_set_line_cap(cr, pen.LineCap switch { PenLineCap.Round => 1, PenLineCap.Square => 2, _ => 0 });
        LibCairo.cairo_set_line_join(cr, pen.LineJoin switch { PenLineJoin.Round => 1, PenLineJoin.Bevel => 2, _ => 0 });
        LibCairo.cairo_set_miter_limit(cr, pen.MiterLimit);
        var dashes = pen.DashStyle?.Dashes is { Count: > 0 } d ? d.Select(v => v * pen.Thickness).ToArray() : null;
        if (dashes is not null && dashes.Sum() <= 0) dashes = null;
        LibCairo.cairo_set_dash(cr, dashes, dashes?.Length ?? 0, (pen.DashStyle?.Offset ?? 0) * pen.Thickness);
    }

    // ---- questions
    public Rect Bounds
    {
        get
        {
            if (Segments.Count == 0) return default;
            AddTo(Scratch2(out var cr));
            LibCairo.cairo_path_extents(cr, out var x1, out var y1, out var x2, out var y2);
            return new Rect(x1, y1, x2 - x1, y2 - y1);
        }
    }

    private static nint Scratch2(out nint cr) => cr = Scratch;

    public Rect GetRenderBounds(IPen? pen)
    {
        var bounds = Bounds;
        if (pen is not { Thickness: > 0 } || Segments.Count == 0) return bounds;
        AddTo(Scratch2(out var cr));
        ApplyPen(cr, pen);
        LibCairo.cairo_stroke_extents(cr, out var x1, out var y1, out var x2, out var y2);
        return bounds.Union(new Rect(x1, y1, x2 - x1, y2 - y1));
    }

    public bool FillContains(Point point)
    {
        AddTo(Scratch2(out var cr));
        return LibCairo.cairo_in_fill(cr, point.X, point.Y) != 0;
    }

    public bool StrokeContains(IPen? pen, Point point)
    {
        if (pen is null) return false;
        AddTo(Scratch2(out var cr));
        ApplyPen(cr, pen);
        return LibCairo.cairo_in_stroke(cr, point.X, point.Y) != 0;
    }

    // Cairo has no path booleans: these two are approximations (see CreateCombinedGeometry).
    public IGeometryImpl? Intersect(IGeometryImpl geometry) => Rectangle(Bounds.Intersect(geometry.Bounds));
    public IGeometryImpl GetWidenedGeometry(IPen pen) => Rectangle(GetRenderBounds(pen));

    public ITransformedGeometryImpl WithTransform(Matrix transform) => new Transformed(this, transform);

    // ---- walking along the path
    private List<(Point P, bool Start)> Flat
    {
        get
        {
            if (_flat is not null) return _flat;
            var flat = new List<(Point, bool)>();
            Point at = default, start = default;
            foreach (var s in Segments)
                switch (s.Op)
                {
                    case Op.Move: flat.Add((start = at = s.A, true)); break;
                    case Op.Line: flat.Add((at = s.A, false)); break;
                    case Op.Close: flat.Add((at = start, false)); break;
                    default:
                        for (var i = 1; i <= 24; i++)
                        {
                            double t = i / 24.0, u = 1 - t;
                            flat.Add((at * (u * u * u) + s.A * (3 * u * u * t) + s.B * (3 * u * t * t) + s.C * (t * t * t), false));
                        }
                        at = s.C;
                        break;
                }
            return _flat = flat;
        }
    }

    public double ContourLength
    {
        get
        {
            var sum = 0.0;
            for (var i = 1; i < Flat.Count; i++) if (!Flat[i].Start) sum += Point.Distance(Flat[i - 1].P, Flat[i].P);
            return sum;
        }
    }

    public bool TryGetPointAtDistance(double distance, out Point point) => TryGetPointAndTangentAtDistance(distance, out point, out _);

    public bool TryGetPointAndTangentAtDistance(double distance, out Point point, out Point tangent)
    {
        for (var i = 1; i < Flat.Count; i++)
        {
            if (Flat[i].Start) continue;
            var (a, b) = (Flat[i - 1].P, Flat[i].P);
            var length = Point.Distance(a, b);
            if (length > 0 && distance <= length)
            {
                tangent = (b - a) / length;
                point = a + (b - a) * (distance / length);
                return true;
            }
            distance -= length;
        }
        point = tangent = default;
        return false;
    }

    public bool TryGetSegment(
        double startDistance, double stopDistance, bool startOnBeginFigure, [NotNullWhen(true)] out IGeometryImpl? segmentGeometry)
    {
        var result = new CairoGeometry();
        var at = 0.0;
        for (var i = 1; i < Flat.Count; i++)
        {
            if (Flat[i].Start) continue;
            var (a, b) = (Flat[i - 1].P, Flat[i].P);
            var length = Point.Distance(a, b);
            double from = Math.Max(startDistance, at), to = Math.Min(stopDistance, at + length);
            if (length > 0 && from < to)
            {
                if (result.Segments.Count == 0 || Flat[i - 1].Start) result.Move(a + (b - a) * ((from - at) / length));
                result.Line(a + (b - a) * ((to - at) / length));
            }
            at += length;
        }
        segmentGeometry = result;
        return result.Segments.Count > 0;
    }

    private sealed class Transformed : CairoGeometry, ITransformedGeometryImpl
    {
        public Transformed(CairoGeometry source, Matrix m)
        {
            SourceGeometry = source;
            Transform = m;
            FillRule = source.FillRule;
            foreach (var s in source.Segments) Segments.Add(new(s.Op, s.A * m, s.B * m, s.C * m));
        }

        public IGeometryImpl SourceGeometry { get; }
        public Matrix Transform { get; }
    }

    internal sealed class Stream : CairoGeometry, IStreamGeometryImpl
    {
        public IStreamGeometryImpl Clone() => new Stream { FillRule = FillRule, Segments = [.. Segments] };
        public IStreamGeometryContextImpl Open() { Segments.Clear(); _flat = null; return new Builder(this); }
    }

    private sealed class Builder(Stream target) : IStreamGeometryContextImpl
    {
        private Point _at;
        public void SetFillRule(FillRule fillRule) => target.FillRule = fillRule;
        public void BeginFigure(Point startPoint, bool isFilled = true) { target.Move(startPoint); _at = startPoint; }
        public void LineTo(Point point, bool isStroked = true) { target.Line(point); _at = point; }
        public void CubicBezierTo(Point c1, Point c2, Point end, bool isStroked = true) { target.Curve(c1, c2, end); _at = end; }
        public void QuadraticBezierTo(Point c, Point end, bool isStroked = true)
        {
            target.Curve(_at + (c - _at) * (2 / 3.0), end + (c - end) * (2 / 3.0), end);
            _at = end;
        }
        public void EndFigure(bool isClosed) { if (isClosed) target.Close(); }
        public void Dispose() { }

        public void ArcTo(
            Point point, Size size, double rotationAngle, bool isLargeArc, SweepDirection sweepDirection, bool isStroked = true)
        {
            // SVG's endpoint-to-center conversion, then quarter-turn Beziers.
            double rx = Math.Abs(size.Width), ry = Math.Abs(size.Height), phi = rotationAngle * Math.PI / 180;
            if (rx < 1e-9 || ry < 1e-9 || point == _at) { LineTo(point); return; }
            double cos = Math.Cos(phi), sin = Math.Sin(phi);
            double dx = (_at.X - point.X) / 2, dy = (_at.Y - point.Y) / 2;
            double x1 = cos * dx + sin * dy, y1 = -sin * dx + cos * dy;
            var lambda = x1 * x1 / (rx * rx) + y1 * y1 / (ry * ry);
            if (lambda > 1) { rx *= Math.Sqrt(lambda); ry *= Math.Sqrt(lambda); }
            var root = Math.Sqrt(Math.Max(
                0, (rx * rx * ry * ry - rx * rx * y1 * y1 - ry * ry * x1 * x1) / (rx * rx * y1 * y1 + ry * ry * x1 * x1)));
            if (isLargeArc == (sweepDirection == SweepDirection.Clockwise)) root = -root;
            double cx1 = root * rx * y1 / ry, cy1 = -root * ry * x1 / rx;
            double cx = cos * cx1 - sin * cy1 + (_at.X + point.X) / 2, cy = sin * cx1 + cos * cy1 + (_at.Y + point.Y) / 2;
            var from = Math.Atan2((y1 - cy1) / ry, (x1 - cx1) / rx);
            var sweep = Math.Atan2((-y1 - cy1) / ry, (-x1 - cx1) / rx) - from;
            if (sweepDirection == SweepDirection.Clockwise && sweep < 0) sweep += 2 * Math.PI;
            if (sweepDirection == SweepDirection.CounterClockwise && sweep > 0) sweep -= 2 * Math.PI;
            var n = Math.Max(1, (int)Math.Ceiling(Math.Abs(sweep) / (Math.PI / 2) - 1e-9));
            var step = sweep / n;
            var k = 4 / 3.0 * Math.Tan(step / 4);
            Point At(double x, double y) => new(cx + cos * rx * x - sin * ry * y, cy + sin * rx * x + cos * ry * y);
            for (var i = 0; i < n; i++)
            {
                double a = from + i * step, b = a + step;
                target.Curve(At(Math.Cos(a) - k * Math.Sin(a), Math.Sin(a) + k * Math.Cos(a)),
                    At(Math.Cos(b) + k * Math.Sin(b), Math.Sin(b) - k * Math.Cos(b)),
                    i == n - 1 ? point : At(Math.Cos(b), Math.Sin(b)));
            }
            _at = point;
        }
    }
}
