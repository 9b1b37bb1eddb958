using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Collects the curves of a drawing within limits.</summary>
internal abstract class DrawingPen
{
    private int _points;

    /// <summary>The curves so far.</summary>
    public List<DrawnCurve> Curves { get; } = [];

    /// <summary>The layer of what is being drawn.</summary>
    protected string Layer { get; set; } = "";

    /// <summary>What is being drawn, for messages.</summary>
    protected abstract string Entity { get; }

    /// <summary>An error at what is being drawn.</summary>
    public abstract InputException Fail(string code, string problem);

    /// <summary>Hears that a curve has no length, and is left out.</summary>
    protected abstract void NoLength();

    /// <summary>Adds a line, unless it has no length.</summary>
    public void Line(Point2 from, Point2 to)
    {
        Check(from);
        Check(to);
        if (from.DistanceTo(to) < DrawingLimits.MinMm)
        {
            NoLength();
            return;
        }

        Add(new DrawnLine(Layer, Entity, from, to));
    }

    /// <summary>Adds an arc, unless it has no length.</summary>
    public void Arc(Point2 center, double radius, double start, double sweep)
    {
        if (radius * Math.Abs(sweep) < DrawingLimits.MinMm)
        {
            NoLength();
            return;
        }

        var arc = new DrawnArc(Layer, Entity, center, radius, start, sweep);
        if (arc.IsCircle ? !(radius <= DrawingLimits.MaxMm) : !(radius <= DrawingLimits.MaxArcMm))
        {
            throw Fail("too-large", string.Create(
                CultureInfo.InvariantCulture,
                $"a radius of {radius:g6} mm; at most {(arc.IsCircle ? DrawingLimits.MaxMm : DrawingLimits.MaxArcMm):g6} mm is expected"));
        }

        Check(arc.From);
        Check(arc.To);
        Check(arc.At(0.5));
        Add(arc);
    }

    /// <summary>Adds a polyline along a free curve, unless it has no length.</summary>
    public void Course(IReadOnlyList<Point2> points)
    {
        var length = 0.0;
        for (var i = 0; i < points.Count; i++)
        {
            Check(points[i]);
            length += i == 0 ? 0 : points[i].DistanceTo(points[i - 1]);
        }

        if (length < DrawingLimits.MinMm)
        {
            NoLength();
            return;
        }

        Add(new DrawnCourse(Layer, Entity, points));
    }

    /// <summary>Takes points from the budget of the drawing.</summary>
    public void Reserve(int points)
    {
        _points += Math.Min(points, DrawingLimits.MaxPoints + 1);
        if (_points > DrawingLimits.MaxPoints)
        {
            throw Fail("too-large", string.Create(
                CultureInfo.InvariantCulture,
                $"more than {DrawingLimits.MaxPoints} points of ellipses and splines are needed; fewer are expected"));
        }
    }

    /// <summary>Returns a point that is in the largest drawing.</summary>
    public Point2 Check(Point2 point, double limit = DrawingLimits.MaxMm) =>
        Math.Abs(point.X) <= limit && Math.Abs(point.Y) <= limit
            ? point
            : throw Fail("too-large", string.Create(
                CultureInfo.InvariantCulture,
                $"a point at X {point.X:g6}, Y {point.Y:g6} mm; at most {limit:g6} mm from the origin is expected: move the drawing to its "
                    + $"origin, or correct its unit"));

    private void Add(DrawnCurve curve)
    {
        if (Curves.Count >= DrawingLimits.MaxCurves)
        {
            throw Fail("too-large", string.Create(
                CultureInfo.InvariantCulture,
                $"more than {DrawingLimits.MaxCurves} curves; fewer are expected"));
        }

        Curves.Add(curve);
    }
}
