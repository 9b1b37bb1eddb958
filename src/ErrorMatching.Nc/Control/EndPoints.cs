using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The programmed end of a block.</summary>
internal sealed class EndPoints(ControlState control, BlockValues values, CoordinateLayers layers, BlockIntent intent)
{
    /// <summary>The end of the block's motion.</summary>
    public (Point3 End, AxisSet Unknown) Target()
    {
        if (layers.Transforms.IsPolar)
        {
            return PolarTarget();
        }

        if (values.Words.IsPolar)
        {
            return PolarWordsTarget(control.State.Position, control.State.Unknown);
        }

        var at = control.State.Position;
        var (given, unknown) = (values.Words.Present, control.State.Unknown);
        var incremental = ((control.State.Incremental ? BlockWords.LinearAxes : 0) & ~values.Words.Absolute) | values.Words.Incremental;
        var end = (given & BlockWords.LinearAxes) == 0 ? at : values.End(at, given, incremental);
        unknown &= ~BlockWords.AxesOf(given & ~incremental);
        return (end, intent.HasUnknownCode ? AxisSet.All : unknown | values.UnknownWords());
    }

    /// <summary>LinuxCNC's @ and ^ are the polar coordinates of the end in the XY plane, or their increments; an omitted one
    /// stays.</summary>
    public (Point3 End, AxisSet Unknown) PolarWordsTarget(Point3 at, AxisSet unknown)
    {
        var from = new Vector2(at.X, at.Y);
        var (distance, degrees) = (from.Length, Elementary.Atan2(from.Y, from.X) * 180 / Math.PI);
        var (grown, turned) = (values.Words.PolarDistance * (control.State.Inch ? ControlState.MmPerInch : 1), values.Words.PolarAngle);
        distance = control.State.Incremental ? distance + (grown ?? 0) : grown ?? distance;
        degrees = control.State.Incremental ? degrees + (turned ?? 0) : turned ?? degrees;
        var flat = AxisSet.X | AxisSet.Y;
        var isUnknown = double.IsNaN(distance) || double.IsNaN(degrees)
            || ((control.State.Incremental || grown is null || turned is null) && (unknown & flat) != AxisSet.None);
        var (sin, cos) = Elementary.SinCos(degrees * Math.PI / 180);
        var z = values.Words.Has('Z') ? (control.State.Incremental ? BlockValues.Sum(at.Z, values.Length('Z')) : values.Length('Z')) : at.Z;
        var unknownZ = values.Words.Has('Z') && !control.State.Incremental ? AxisSet.None : unknown & AxisSet.Z;
        return isUnknown ? (new(at.X, at.Y, z), flat | unknownZ | values.UnknownWords())
            : (new(distance * cos, distance * sin, z), unknownZ | values.UnknownWords());
    }

    // The first axis of the plane is a radius about the origin; the second is an angle.
    private (Point3 End, AxisSet Unknown) PolarTarget()
    {
        var plane = control.State.Plane;
        var (first, second, third) =
            plane switch { CoordinatePlane.ZX => ('Z', 'X', 'Y'), CoordinatePlane.YZ => ('Y', 'Z', 'X'), _ => ('X', 'Y', 'Z') };
        var (at, height) = (plane.Project(control.State.Position), plane.Height(control.State.Position));
        var inPlane = values.Words.Has(first) || values.Words.Has(second);
        var radius = values.Words.Has(first) ? values.Length(first) : at.DistanceTo(Point2.Origin);
        var angle = values.Words.Has(second) ? Angle.FromDegrees(values.Degrees(second)) : (at - Point2.Origin).Direction;
        var end = inPlane ? Point2.Origin + (Vector2.FromDirection(angle) * radius) : at;
        var newHeight = values.Words.Has(third)
            ? (control.State.Incremental ? BlockValues.Sum(height, values.Length(third)) : values.Length(third)) : height;
        var missing = inPlane && !(values.Words.Has(first) && values.Words.Has(second)) ? control.State.Unknown & plane.Axes()
            : AxisSet.None;
        var unknown = (inPlane ? (missing != AxisSet.None || control.State.Incremental ? plane.Axes() : AxisSet.None)
            : control.State.Unknown & plane.Axes())
            | (values.Words.Has(third) && !control.State.Incremental ? AxisSet.None : control.State.Unknown & ~plane.Axes());
        return (plane.Lift(end, newHeight), unknown | values.UnknownWords());
    }
}
