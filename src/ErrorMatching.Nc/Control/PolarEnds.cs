using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Ends of straight moves by polar coordinates about a pole (AP=, RP=), or by an angle and one coordinate (ANG=).</summary>
/// <remarks>Followed where the block states all of it, in absolute coordinates. The pole is stated in the coordinates that are active:
/// after a change of plane or frame, it is unknown.</remarks>
internal sealed class PolarEnds(NcControl control)
{
    private const double Flat = 1e-9;

    private (Point2 Place, CoordinatePlane Plane, int Frame)? _pole;

    /// <summary>Sets the pole from the block's axis words: from the tool's place, the origin, or the pole before.</summary>
    public void SetPole(NcMeaning meaning)
    {
        var plane = control.State.Plane;
        var named = control.Values.GivenAxes() & plane.Axes();
        var isStated = named == plane.Axes() && !control.Words.HasPolarEnd && control.Values.UnknownWords() == AxisSet.None;
        var from = meaning switch
        {
            NcMeaning.PoleFromOrigin => Point2.Origin,
            NcMeaning.PoleFromPosition when (control.State.Unknown & plane.Axes()) == AxisSet.None => plane.Project(control.State.Position),
            NcMeaning.PoleFromPole => Pole(),
            _ => null,
        };
        var by = plane.Project(control.Values.Given(default, incremental: false)) - Point2.Origin;
        _pole = isStated && from is { } start
            ? (new(BlockValues.Sum(start.X, by.X), BlockValues.Sum(start.Y, by.Y)), plane, control.State.Frame)
            : null;
    }

    /// <summary>The end of the block's move; null if it is not followed.</summary>
    /// <param name="kind">The kind of the move.</param>
    public Point3? End(MotionKind kind)
    {
        var words = control.Words;
        if (kind is not (MotionKind.Rapid or MotionKind.Line) || control.State.Incremental || control.State.Cycle != NcMeaning.Unknown)
        {
            return null;
        }

        var plane = control.State.Plane;
        var height = plane.Height(control.Values.Given(control.State.Position, incremental: false));
        var end = words.LineAngle is { } angle ? OnLine(angle) : AboutPole();
        return end is { } place ? plane.Lift(place, height) : null;
    }

    private Point2? AboutPole()
    {
        var words = control.Words;
        var isAlone = (control.Values.GivenAxes() & control.State.Plane.Axes()) == AxisSet.None;
        if (!isAlone || Pole() is not { } pole || words.PoleRadius is not (>= 0 and var radius) || words.PoleAngle is not { } angle
            || double.IsNaN(angle))
        {
            return null;
        }

        var by = Vector2.FromDirection(Angle.FromDegrees(angle)) * (radius * control.Unit);
        return new(BlockValues.Sum(pole.X, by.X), BlockValues.Sum(pole.Y, by.Y));
    }

    // One coordinate of the plane and the angle to its first axis say where a straight line ends, if it goes that way.
    private Point2? OnLine(double degrees)
    {
        var words = control.Words;
        var plane = control.State.Plane;
        var given = control.Values.GivenAxes() & plane.Axes();
        if (double.IsNaN(degrees) || words.PoleRadius is not null || words.PoleAngle is not null
            || (control.State.Unknown & plane.Axes()) != AxisSet.None || control.Values.UnknownWords() != AxisSet.None)
        {
            return null;
        }

        var start = plane.Project(control.State.Position);
        var to = plane.Project(control.Values.Given(control.State.Position, incremental: false));
        var along = Vector2.FromDirection(Angle.FromDegrees(degrees));
        var first = plane.Lift(new(1, 0), 0);
        var firstAxis = first.X != 0 ? AxisSet.X : first.Y != 0 ? AxisSet.Y : AxisSet.Z;
        var (component, by) = given == firstAxis ? (along.X, to.X - start.X)
            : given != AxisSet.None && given != plane.Axes() ? (along.Y, to.Y - start.Y)
            : (0, 0);
        if (Math.Abs(component) < Flat || by / component <= 0)
        {
            return null;
        }

        var length = by / component;
        return given == firstAxis
            ? new(to.X, BlockValues.Sum(start.Y, along.Y * length))
            : new(BlockValues.Sum(start.X, along.X * length), to.Y);
    }

    private Point2? Pole() =>
        _pole is { } pole && pole.Plane == control.State.Plane && pole.Frame == control.State.Frame ? pole.Place : null;
}

/// <summary>The pole: the center of arcs, and the origin of polar ends, that a block of its own states for the blocks after it
/// (CC).</summary>
internal sealed class PoleCodes(NcControl control)
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
