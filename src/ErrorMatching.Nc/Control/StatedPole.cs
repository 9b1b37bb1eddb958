using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The pole: the center of arcs, and the origin of polar ends, that a block of its own states for the blocks after it
/// (CC).</summary>
internal sealed class StatedPole(NcControl control)
{
    /// <summary>The plane of the block's motion: that of the pole if it moves about one.</summary>
    public CoordinatePlane Plane =>
        control.Intent.AboutPole || control.State.Form == NcMeaning.ArcAboutPole ? control.State.Pole.Plane : control.State.Plane;

    /// <summary>True if a pole is known in the coordinates that are active.</summary>
    public bool IsKnown => control.State.Pole.IsKnown && control.State.Pole.Frame == control.State.Frame;

    /// <summary>States the pole: two coordinates name its place and its plane; none at all means the tool's place. With one coordinate or
    /// three, the pole is unknown.</summary>
    public void Set()
    {
        var given = control.Values.GivenAxes();
        var plane = given switch
        {
            AxisSet.Y | AxisSet.Z => CoordinatePlane.YZ,
            AxisSet.X | AxisSet.Z => CoordinatePlane.ZX,
            AxisSet.X | AxisSet.Y => CoordinatePlane.XY,
            _ => control.State.Plane,
        };
        var incremental = control.Words.Incremental;
        var relative = given == AxisSet.None ? plane.Axes() : BlockWords.AxesOf(incremental);
        var isKnown = (given == AxisSet.None || given == plane.Axes()) && (control.Values.UnknownWords() & given) == AxisSet.None
            && (control.State.Unknown & relative) == AxisSet.None && (control.Words.Absolute & incremental) == 0;
        var place = control.Values.End(control.State.Position, control.Words.Present, incremental);
        control.State.Pole = new(plane.Project(place), plane, control.State.Frame, isKnown);
        control.Result.StatePole();
        if (!isKnown)
        {
            control.Result.Problem("unknown-pole", "Where the center of the arcs behind this block lies is not known.", MotionFlags.None);
        }
    }

    /// <summary>The end that a distance from the pole and an angle about it give; an omitted one stays. The third axis goes where its word
    /// says.</summary>
    public (Point3 End, AxisSet Unknown) Target()
    {
        var (plane, pole) = (control.State.Plane, control.State.Pole.Place);
        var at = plane.Project(control.State.Position) - pole;
        var (distance, degrees) = (at.Length, Elementary.Atan2(at.Y, at.X) * 180 / Math.PI);
        var (r, angle) = (control.Words.PolarDistance * control.Unit, control.Words.PolarAngle);
        distance = control.Words.PolarDistanceGrows ? distance + r!.Value : r ?? distance;
        degrees = control.Words.PolarAngleGrows ? degrees + angle!.Value : angle ?? degrees;

        var third = AxisSet.All & ~plane.Axes();
        var letters = control.Words.Present & BlockWords.LinearAxes;
        var incremental = control.Words.Incremental;
        var height = plane.Height(control.Values.End(control.State.Position, letters, incremental));
        var unknownHeight = (control.State.Unknown & ~BlockWords.AxesOf(letters & ~incremental)) | control.Values.UnknownWords();
        var isRelative = r is null || angle is null || control.Words.PolarDistanceGrows || control.Words.PolarAngleGrows;
        var isUnknown = !IsKnown || double.IsNaN(distance) || double.IsNaN(degrees)
            || (isRelative && (control.State.Unknown & plane.Axes()) != AxisSet.None)
            || (control.Values.GivenAxes() & plane.Axes()) != AxisSet.None;
        var (sin, cos) = Elementary.SinCos(degrees * Math.PI / 180);
        var end = isUnknown ? plane.Project(control.State.Position) : pole + new Vector2(distance * cos, distance * sin);
        return (plane.Lift(end, height), (isUnknown ? plane.Axes() : AxisSet.None) | (unknownHeight & third));
    }

    /// <summary>True for an arc about the pole to an angle, in its plane and of at most one turn.</summary>
    public bool IsPlainArc() => control.State.Form == NcMeaning.ArcAboutPole && control.Values.GivenAxes() == AxisSet.None
        && control.Words is { PolarDistance: null, PolarAngle: not null } && Turns() == 0;

    /// <summary>Full turns beyond the first of an arc whose angle is an increment.</summary>
    public int Turns() => control.Words is { PolarAngleGrows: true, PolarAngle: { } angle } && !double.IsNaN(angle)
        ? (int)Math.Clamp(Math.Ceiling(Math.Abs(angle) / 360) - 1, 0, 100_000)
        : 0;
}
