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
