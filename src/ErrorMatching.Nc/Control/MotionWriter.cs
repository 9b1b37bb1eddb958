using System.Runtime.CompilerServices;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Moves the tool: adds motions in work coordinates, each with the active modes.</summary>
internal sealed class MotionWriter(ControlState control, CoordinateLayers layers, RunResult result)
{
    /// <summary>Moves the tool to a programmed place.</summary>
    public void Append(MotionKind kind, MotionFlags flags, Point3 end, AxisSet unknownEnd, Point2 center = default, int turns = 0)
    {
        ref var state = ref control.State;
        var start = layers.Tool();
        var to = layers.Work(end, unknownEnd);
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
        result.Motions.Add(new(
            result.Block, kind, isArc || switches ? state.Plane : state.StraightPlane, flags | ModeFlags(), start.Place, to.Place, center,
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
        result.Motions.AddStraight(result.Block, state, flags | state.Flags, end, unknownEnd);
        state.Position = end;
        state.Unknown = unknownEnd;
    }

    private MotionFlags ModeFlags() =>
        control.State.Flags
        | (layers.Transforms.AreMoreThanShift ? MotionFlags.Transformed : MotionFlags.None)
        | (control.State.ModalRounding != 0 ? MotionFlags.CornerWord : MotionFlags.None);
}
