using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Collects the curves of a drawing within limits.</summary>
/// <param name="groups">The file, for errors.</param>
/// <param name="notes">Receives what is passed over.</param>
internal sealed class DxfPen(DxfGroups groups, DxfNotes notes)
{
    private DxfEntity? _entity;
    private string _layer = "";
    private int _points;

    /// <summary>The curves so far.</summary>
    public List<DrawnCurve> Curves { get; } = [];

    /// <summary>Draws an entity.</summary>
    /// <param name="entity">The entity.</param>
    /// <param name="shapes">Its pieces.</param>
    /// <param name="layer">Its layer, or that of the INSERT that it comes from.</param>
    /// <param name="map">From its block to the drawing in millimeters.</param>
    public void Draw(DxfEntity entity, IReadOnlyList<DxfShape> shapes, string layer, in DxfMap map)
    {
        (_entity, _layer) = (entity, layer);
        foreach (var shape in shapes)
        {
            shape.Draw(map, this);
        }
    }

    /// <summary>Adds a line, unless it has no length.</summary>
    public void Line(Point2 from, Point2 to)
    {
        Check(from);
        Check(to);
        if (from.DistanceTo(to) < DxfLimits.MinMm)
        {
            notes.Count(DxfNote.NoLength, _entity!);
            return;
        }

        Add(new DrawnLine(_layer, _entity!.Label, from, to));
    }

    /// <summary>Adds an arc, unless it has no length.</summary>
    public void Arc(Point2 center, double radius, double start, double sweep)
    {
        if (radius * Math.Abs(sweep) < DxfLimits.MinMm)
        {
            notes.Count(DxfNote.NoLength, _entity!);
            return;
        }

        var arc = new DrawnArc(_layer, _entity!.Label, center, radius, start, sweep);
        if (arc.IsCircle ? !(radius <= DxfLimits.MaxMm) : !(radius <= DxfLimits.MaxArcMm))
        {
            throw Fail("too-large", string.Create(
                CultureInfo.InvariantCulture,
                $"a radius of {radius:g6} mm; at most {(arc.IsCircle ? DxfLimits.MaxMm : DxfLimits.MaxArcMm):g6} mm is expected"));
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

        if (length < DxfLimits.MinMm)
        {
            notes.Count(DxfNote.NoLength, _entity!);
            return;
        }

        Add(new DrawnCourse(_layer, _entity!.Label, points));
    }

    /// <summary>Takes points from the budget of the drawing.</summary>
    public void Reserve(int points)
    {
        _points += Math.Min(points, DxfLimits.MaxPoints + 1);
        if (_points > DxfLimits.MaxPoints)
        {
            throw Fail("too-large", string.Create(
                CultureInfo.InvariantCulture,
                $"more than {DxfLimits.MaxPoints} points of ellipses and splines are needed; fewer are expected"));
        }
    }

    /// <summary>Returns a point that is in the largest drawing.</summary>
    public Point2 Check(Point2 point, double limit = DxfLimits.MaxMm) =>
        Math.Abs(point.X) <= limit && Math.Abs(point.Y) <= limit
            ? point
            : throw Fail("too-large", string.Create(
                CultureInfo.InvariantCulture,
                $"a point at X {point.X:g6}, Y {point.Y:g6} mm; at most {limit:g6} mm from the origin is expected: move the drawing to its "
                    + $"origin, or correct its unit"));

    /// <summary>An error at the entity that is being drawn.</summary>
    public InputException Fail(string code, string problem) =>
        groups.FailAt(code, _entity!.Place, $"{_entity.Label}: {problem}");

    private void Add(DrawnCurve curve)
    {
        if (Curves.Count >= DxfLimits.MaxCurves)
        {
            throw Fail("too-large", string.Create(
                CultureInfo.InvariantCulture,
                $"more than {DxfLimits.MaxCurves} curves with those of inserted blocks; fewer are expected"));
        }

        Curves.Add(curve);
    }
}
