using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Siemens patterns of holes: a row (HOLES1), a circle (HOLES2), a grid or frame (CYCLE801).</summary>
internal sealed class HolePatterns(ControlState control, CycleSteps steps)
{
    /// <summary>The places of a call. Null if it is not a pattern, or if its places are unknown.</summary>
    public List<Point2>? PlacesOf(CycleCall call)
    {
        var places = call.Name switch
        {
            "HOLES1" when call.IsAbsent(6) && CountOf(call[5]) is { } count => Row(call, count),
            "HOLES2" when call.IsAbsent(6) && CountOf(call[5]) is { } count => Circle(call, count),
            "CYCLE801" when call.IsAbsent(8) && call[7] is null or 0 or 1 && CountOf(call[5] * call[6]) is not null => Grid(call),
            _ => null,
        };
        return places is not null && places.TrueForAll(p => double.IsFinite(p.X + p.Y)) ? places : null;
    }

    private int? CountOf(double? number)
    {
        if (number is not (>= 1 and <= CycleSteps.Most)
            || number != Math.Floor(number.Value)
            || (steps.Count += number.Value) > CycleSteps.Most)
        {
            return null;
        }

        return (int)number;
    }

    // SPCA, SPCO (a point of the row), STA1 (angle to the first axis), FDIS (from there to the first hole), DBH (between holes), NUM. It
    // begins at the nearer end.
    private List<Point2>? Row(CycleCall call, int count)
    {
        var along = Vector2.FromDirection(Angle.FromDegrees(call[2] ?? 0));
        var places = new List<Point2>(count);
        for (var i = 0; i < count; i++)
        {
            places.Add(Place(call, along * ((call[3] ?? 0) + (i * (call[4] ?? 0)))));
        }

        var plane = control.State.Plane;
        var at = plane.Project(control.State.Position);
        var (first, last) = (at.DistanceTo(places[0]), at.DistanceTo(places[^1]));
        if (count > 1 && ((control.State.Unknown & plane.Axes()) != AxisSet.None || Math.Abs(first - last) < 1e-9))
        {
            return null;
        }

        if (last < first)
        {
            places.Reverse();
        }

        return places;
    }

    // CPA, CPO (center), RAD, STA1 (angle of the first hole), INDA (from hole to hole; 0 or omitted: full circle), NUM.
    private List<Point2> Circle(CycleCall call, int count)
    {
        var step = call[4] is null or 0 ? 360.0 / count : call[4]!.Value;
        var places = new List<Point2>(count);
        for (var i = 0; i < count; i++)
        {
            places.Add(Place(call, Vector2.FromDirection(Angle.FromDegrees((call[3] ?? 0) + (i * step))) * (call[2] ?? double.NaN)));
        }

        return places;
    }

    // SPCA, SPCO (a corner), STA (angle to the first axis), DIS1, DIS2 (between columns, rows), NUM1, NUM2 (columns, rows), VARI (1: the
    // border only). The control determines the order.
    private List<Point2>? Grid(CycleCall call)
    {
        if (CountOf(call[5]) is not { } columns || CountOf(call[6]) is not { } rows)
        {
            return null;
        }

        var along = Vector2.FromDirection(Angle.FromDegrees(call[2] ?? 0));
        var places = new List<Point2>();
        for (var row = 0; row < rows; row++)
        {
            for (var i = 0; i < columns; i++)
            {
                var column = row % 2 == 0 ? i : columns - 1 - i;
                if (call[7] is not 1 || row == 0 || row == rows - 1 || column == 0 || column == columns - 1)
                {
                    places.Add(Place(call, (along * (column * (call[3] ?? 0))) + (along.Left * (row * (call[4] ?? 0)))));
                }
            }
        }

        return places;
    }

    // As exact as sums of increments.
    private Point2 Place(CycleCall call, Vector2 from) =>
        new(
            BlockValues.Sum((call[0] ?? 0) * control.Unit, from.X * control.Unit),
            BlockValues.Sum((call[1] ?? 0) * control.Unit, from.Y * control.Unit));
}
