namespace ErrorMatching.Freeform;

/// <summary>Determines where curves and points may be on a surface, and distributes them.</summary>
internal sealed class PlanLayout
{
    /// <summary>Distance from trimmed edges, mm. A touch still finds the surface if the edge is off by less.</summary>
    public const double TrimSetInMm = 0.5;

    /// <summary>Number of sample lines for a common spacing.</summary>
    private const int Lines = 9;

    /// <summary>Weight of a curve's turning angle in its share of all points; the rest is its length, because errors may occur where the
    /// nominal surface is straight.</summary>
    private const double AnglePart = 0.3;

    private readonly PartSurface _surface;
    private readonly double _rimSetInMm;
    private readonly (double Start, double End) _v;
    private readonly CurveSpacing _across;

    // The spacing shared by all curves; null if each has its own.
    private readonly (CurveSpacing Spacing, double[] Breaks)? _shared;

    public PlanLayout(PartSurface surface, double rimSetInMm)
    {
        (_surface, _rimSetInMm) = (surface, rimSetInMm);
        _v = RangeOfV();
        BreaksU = CurvatureBreaks.Common(surface, alongU: true);
        BreaksV = [.. CurvatureBreaks.Common(surface, alongU: false).Where(b => b > _v.Start && b < _v.End)];
        var knots = surface.Spline.KnotsU;
        _across = CurveSpacing.Find(
            [
                .. Enumerable.Range(0, Lines).Select(i => new IsoCurve(
                    surface, AlongU: false, knots.Start + ((i + 0.5) / Lines * (knots.End - knots.Start))))],
            _v.Start,
            _v.End);
        _shared = Shared();
    }

    public IReadOnlyList<double> BreaksU { get; }

    public IReadOnlyList<double> BreaksV { get; }

    /// <summary>Returns curves with equal numbers of points. On a whole surface whose breaks follow its parameter lines, all curves share
    /// the same u, so that the points form curves in both directions.</summary>
    /// <exception cref="PlanRefusedException">Breaks and ends alone need more points, or a curve has no room in the region.</exception>
    public IReadOnlyList<PlanCurve> Even(int curves, int each)
    {
        var lines = Curves(curves);
        if (_shared is not { } shared)
        {
            return [.. lines.Select(l => Own(l, each, EndsOf(l.V)))];
        }

        var nodes = Nodes(shared.Spacing, each, shared.Breaks);
        return [.. lines.Select(l => new PlanCurve(l.V, l.Reason, nodes))];
    }

    /// <summary>Distributes a number of points over curves by the turning angle and length of each.</summary>
    /// <exception cref="PlanRefusedException">As for <see cref="Even"/>.</exception>
    public IReadOnlyList<PlanCurve> Spread(int curves, int points)
    {
        var lines = Curves(curves);
        var ends = lines.Select(l => EndsOf(l.V)).ToArray();
        var spacings = lines.Select((l, j) => CurveSpacing.Find([CurveAt(l.V)], ends[j].Start, ends[j].End)).ToArray();
        var breaks = lines.Select(
            (l, j) => CurvatureBreaks.On(CurveAt(l.V)).Where(b => b > ends[j].Start && b < ends[j].End).ToArray()).ToArray();
        var needed = breaks.Sum(b => b.Length + 2);
        if (needed > points)
        {
            throw PlanRefusedException.TooFew("points", points, needed, breaks.Sum(b => b.Length));
        }

        var (angle, length) = (spacings.Sum(s => s.AngleRad), spacings.Sum(s => s.LengthMm));
        var most = LargestRemainder.Divide(
            points, [.. spacings.Select(s => (angle > 0 ? AnglePart * s.AngleRad / angle : 0) + ((1 - AnglePart) * s.LengthMm / length))]);
        var counts = most.Select((m, j) => Math.Max(m, breaks[j].Length + 2)).ToArray();

        // Ends and breaks may need points beyond a curve's share. These are taken from the curves with the most points to spare.
        for (var over = counts.Sum() - points; over > 0; over--)
        {
            counts[Enumerable.Range(0, counts.Length).MaxBy(j => counts[j] - breaks[j].Length)]--;
        }

        return [.. lines.Select((l, j) => new PlanCurve(l.V, l.Reason, Nodes(spacings[j], counts[j], breaks[j])))];
    }

    private (CurveSpacing Spacing, double[] Breaks)? Shared()
    {
        IsoCurve[] lines = [.. Enumerable.Range(0, Lines).Select(i => CurveAt(_v.Start + ((double)i / (Lines - 1) * (_v.End - _v.Start))))];
        var near = CurvatureBreaks.Same(_surface.Spline.KnotsU);
        if (!_surface.Region.IsWhole || lines.Any(l => CurvatureBreaks.On(l).Any(b => !BreaksU.Any(c => Math.Abs(b - c) <= near))))
        {
            return null;
        }

        var ends = lines.Select(l => EndsOf(l.Fixed)).ToArray();
        var (start, end) = (ends.Max(e => e.Start), ends.Min(e => e.End));
        return (CurveSpacing.Find(lines, start, end), [.. BreaksU.Where(b => b > start && b < end)]);
    }

    private PlanCurve Own((double V, PlanReason Reason) line, int each, (double Start, double End) ends) =>
        new(
            line.V,
            line.Reason,
            Nodes(
                CurveSpacing.Find([CurveAt(line.V)], ends.Start, ends.End),
                each,
                [.. CurvatureBreaks.On(CurveAt(line.V)).Where(b => b > ends.Start && b < ends.End)]));

    private IReadOnlyList<(double V, PlanReason Reason)> Curves(int count) => count >= BreaksV.Count + 2
        ? _across.Place(count, BreaksV)
        : throw PlanRefusedException.TooFew("curves", count, BreaksV.Count + 2, BreaksV.Count);

    private static IReadOnlyList<(double U, PlanReason Reason)> Nodes(CurveSpacing spacing, int count, double[] breaks) =>
        count >= breaks.Length + 2
        ? spacing.Place(count, breaks)
        : throw PlanRefusedException.TooFew("points on a curve", count, breaks.Length + 2, breaks.Length);

    private IsoCurve CurveAt(double v) => new(_surface, AlongU: true, v);

    private (double Start, double End) RangeOfV()
    {
        var knots = _surface.Spline.KnotsV;
        var (start, end) = (knots.Start, knots.End);
        if (!_surface.Region.IsWhole)
        {
            var all = _surface.Region.Loops.SelectMany(l => l).Select(p => p.Y).ToArray();
            (start, end) = (Math.Max(start, all.Min()), Math.Min(end, all.Max()));
        }

        var setIn = _surface.Region.IsWhole ? _rimSetInMm : Math.Max(_rimSetInMm, TrimSetInMm);
        var middle = (_surface.Spline.KnotsU.Start + _surface.Spline.KnotsU.End) / 2;
        var range = SetIn(new(_surface, AlongU: false, middle), start, end, setIn);
        return range.Start < range.End ? range : throw PlanRefusedException.NoRoom("the region");
    }

    // The first and last place of a curve inside the region, set in.
    private (double Start, double End) EndsOf(double v)
    {
        var (curve, knots) = (CurveAt(v), _surface.Spline.KnotsU);
        var (start, end) = (knots.Start, knots.End);
        var setIn = _rimSetInMm;
        if (!_surface.Region.IsWhole)
        {
            const int parts = 1000;
            var line = curve.Line;
            var inside = Enumerable.Range(0, parts + 1).Where(i => line.IsInside(At(i))).ToArray();
            if (inside.Length < 2)
            {
                throw PlanRefusedException.NoRoom(string.Create(
                    System.Globalization.CultureInfo.InvariantCulture, $"the curve at v = {v:0.####}"));
            }

            (start, end) = (Edge(line, At(inside[0]), At(inside[0] - 1)), Edge(line, At(inside[^1]), At(inside[^1] + 1)));
            setIn = Math.Max(setIn, TrimSetInMm);

            double At(int i) => knots.Start + ((knots.End - knots.Start) * Math.Clamp(i, 0, parts) / parts);
        }

        var ends = SetIn(curve, start, end, setIn);
        return ends.Start < ends.End
            ? ends
            : throw PlanRefusedException.NoRoom(string.Create(
                System.Globalization.CultureInfo.InvariantCulture, $"the curve at v = {v:0.####}"));
    }

    private static double Edge(RegionLine line, double inside, double outside)
    {
        for (var i = 0; i < 50 && inside != outside; i++)
        {
            var middle = (inside + outside) / 2;
            (inside, outside) = line.IsInside(middle) ? (middle, outside) : (inside, middle);
        }

        return inside;
    }

    // A length is converted to a parameter by the derivative at the curve's end.
    private static (double Start, double End) SetIn(IsoCurve curve, double start, double end, double length) => length == 0
        ? (start, end)
        : (start + (length / curve.Derivative(curve.At(start)).Length), end - (length / curve.Derivative(curve.At(end)).Length));
}
