using System.Runtime.CompilerServices;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Moves the tool: says where the motion of a block ends, and adds motions in work coordinates, each with the active
/// modes.</summary>
internal sealed class ToolMoves(NcControl control)
{
    private readonly RunResult _result = control.Result;

    /// <summary>The end of the block's motion.</summary>
    public (Point3 End, AxisSet Unknown) Target()
    {
        if (control.Layers.Transforms.IsPolar)
        {
            return PolarTarget();
        }

        if (control.Words.IsPolar)
        {
            return PolarWordsTarget(control.State.Position, control.State.Unknown);
        }

        var at = control.State.Position;
        var (given, unknown) = (control.Words.Present, control.State.Unknown);
        var incremental = control.Values.IncrementalLetters();
        var end = (given & BlockWords.LinearAxes) == 0 ? at : control.Values.End(at, given, incremental);
        unknown &= ~BlockWords.AxesOf(given & ~incremental);
        return (end, control.Intent.HasUnknownCode ? AxisSet.All : unknown | control.Values.UnknownWords());
    }

    /// <summary>LinuxCNC's @ and ^ are the polar coordinates of the end in the XY plane, or their increments; an omitted one
    /// stays.</summary>
    public (Point3 End, AxisSet Unknown) PolarWordsTarget(Point3 at, AxisSet unknown)
    {
        var from = new Vector2(at.X, at.Y);
        var (distance, degrees) = (from.Length, Elementary.Atan2(from.Y, from.X) * 180 / Math.PI);
        var (grown, turned) = (control.Words.PolarDistance * control.Unit, control.Words.PolarAngle);
        distance = control.State.Incremental ? distance + (grown ?? 0) : grown ?? distance;
        degrees = control.State.Incremental ? degrees + (turned ?? 0) : turned ?? degrees;
        var flat = AxisSet.X | AxisSet.Y;
        var isUnknown = double.IsNaN(distance) || double.IsNaN(degrees)
            || ((control.State.Incremental || grown is null || turned is null) && (unknown & flat) != AxisSet.None);
        var (sin, cos) = Elementary.SinCos(degrees * Math.PI / 180);
        var z = control.Words.Has('Z')
            ? (control.State.Incremental ? BlockValues.Sum(at.Z, control.Values.Length('Z')) : control.Values.Length('Z')) : at.Z;
        var unknownZ = control.Words.Has('Z') && !control.State.Incremental ? AxisSet.None : unknown & AxisSet.Z;
        return isUnknown ? (new(at.X, at.Y, z), flat | unknownZ | control.Values.UnknownWords())
            : (new(distance * cos, distance * sin, z), unknownZ | control.Values.UnknownWords());
    }

    /// <summary>Moves the tool to a programmed place.</summary>
    public void Append(MotionKind kind, MotionFlags flags, Point3 end, AxisSet unknownEnd, Point2 center = default, int turns = 0)
    {
        ref var state = ref control.State;
        var start = control.Layers.Tool();
        var to = control.Layers.Work(end, unknownEnd);
        var isArc = kind is MotionKind.ArcClockwise or MotionKind.ArcCounterClockwise;
        if (isArc)
        {
            state.IsPlaneNew = false;
        }
        else
        {
            state.TakePlane();
        }

        var switches = (flags & MotionFlags.CompensationSwitches) != MotionFlags.None;
        _result.Motions.Add(new(
            _result.Block, kind, isArc || switches ? state.Plane : state.StraightPlane, flags | ModeFlags(), start.Place, to.Place, center,
            turns, state.Feed, state.Frame, start.Unknown, to.Unknown)
        {
            IsVertical = isArc && !switches && state.IsArcVertical,
        });
        state.Position = end;
        state.Unknown = unknownEnd;
    }

    /// <summary>Moves it on straight, for programmed coordinates that equal work coordinates and without a corner.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AppendStraight(MotionFlags flags, Point3 end, AxisSet unknownEnd)
    {
        ref var state = ref control.State;
        state.TakePlane();
        _result.Motions.AddStraight(_result.Block, state, flags | state.Flags, end, unknownEnd);
        state.Position = end;
        state.Unknown = unknownEnd;
    }

    // The first axis of the plane is a radius about the origin; the second is an angle.
    private (Point3 End, AxisSet Unknown) PolarTarget()
    {
        var plane = control.State.Plane;
        var (first, second, third) =
            plane switch { CoordinatePlane.ZX => ('Z', 'X', 'Y'), CoordinatePlane.YZ => ('Y', 'Z', 'X'), _ => ('X', 'Y', 'Z') };
        var (at, height) = (plane.Project(control.State.Position), plane.Height(control.State.Position));
        var inPlane = control.Words.Has(first) || control.Words.Has(second);
        var radius = control.Words.Has(first) ? control.Values.Length(first) : at.DistanceTo(Point2.Origin);
        var angle = control.Words.Has(second) ? Angle.FromDegrees(control.Values.Degrees(second)) : (at - Point2.Origin).Direction;
        var end = inPlane ? Point2.Origin + (Vector2.FromDirection(angle) * radius) : at;
        var newHeight = control.Words.Has(third)
            ? (control.State.Incremental ? BlockValues.Sum(height, control.Values.Length(third)) : control.Values.Length(third)) : height;
        var missing = inPlane && !(control.Words.Has(first) && control.Words.Has(second)) ? control.State.Unknown & plane.Axes()
            : AxisSet.None;
        var unknown = (inPlane ? (missing != AxisSet.None || control.State.Incremental ? plane.Axes() : AxisSet.None)
            : control.State.Unknown & plane.Axes())
            | (control.Words.Has(third) && !control.State.Incremental ? AxisSet.None : control.State.Unknown & ~plane.Axes());
        return (plane.Lift(end, newHeight), unknown | control.Values.UnknownWords());
    }

    private MotionFlags ModeFlags() =>
        control.State.Flags
        | (control.Layers.Transforms.AreMoreThanShift ? MotionFlags.Transformed : MotionFlags.None)
        | (control.State.ModalRounding != 0 ? MotionFlags.CornerWord : MotionFlags.None);
}
