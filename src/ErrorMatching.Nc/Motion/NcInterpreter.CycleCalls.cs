using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>
/// Machining cycles with their arguments in parentheses: return plane, reference plane, safety distance, depth, depth below the reference plane. Drilling and boring are
/// followed; of all others only the return plane is known.
/// </content>
public sealed partial class NcInterpreter
{
    private CycleCall? _modalCycle;
    private CycleCall? _cycleCall;
    private bool _nextCycleIsModal;

    /// <summary>A call, with its arguments as they were when it was read: null where nothing stands, NaN where only the machine knows the value.</summary>
    private sealed record CycleCall(string Name, int Number, IReadOnlyList<double?> Arguments)
    {
        public double? this[int index] => index < Arguments.Count ? Arguments[index] : null;
    }

    private void CallCycle(NcToken token)
    {
        var name = NameOf(token);
        var number = name.Length > 5 && Ascii.EqualsIgnoreCase(name[..5], "CYCLE"u8) && int.TryParse(name[5..], NumberStyles.None, CultureInfo.InvariantCulture, out var n) ? n : 0;
        var call = new CycleCall(Encoding.ASCII.GetString(name).ToUpperInvariant(), number, ArgumentsOf(token));
        if (_nextCycleIsModal)
        {
            (_modalCycle, _nextCycleIsModal) = (call, false);
        }
        else
        {
            _cycleCall = call;
        }
    }

    // Behind the block's own motion: the cycle that it calls, or the one that is called behind every motion.
    private void RunCycleCalls()
    {
        if ((_cycleCall ?? (Moved ? _modalCycle : null)) is { } call)
        {
            _cycleCall = null;
            RunCycle(call);
        }

        _nextCycleIsModal = false;
    }

    private void RunCycle(CycleCall call)
    {
        // It leaves the plane first, so that no corner is rounded.
        _corner = default;
        var plane = _state.Plane;
        var toolAxis = AxisSet.All & ~plane.Axes();
        var unit = _state.Inch ? MmPerInch : 1;
        var (top, reference, safety) = (call[0] * unit, call[1] * unit, Math.Abs(call[2] ?? 0) * unit);
        if (IsFollowed(call) && top is { } t && reference is { } r && DepthOf(call) * unit is { } d && !double.IsNaN(t + r + d + safety))
        {
            var start = Sum(r, d < r ? safety : -safety);
            ToKnownHeight(MotionKind.Rapid, start, toolAxis);
            ToKnownHeight(MotionKind.Line, d, toolAxis);
            if (call.Number is 84 or 840 or 85 or 89)
            {
                ToKnownHeight(MotionKind.Line, start, toolAxis);
            }

            ToKnownHeight(MotionKind.Rapid, t, toolAxis);
            return;
        }

        // Drilling cycles end over their hole at the return plane; of patterns, pockets and the like not even that is known.
        Note("cycle-not-followed", $"{call.Name} is not followed: what it does is the control's affair.");
        var isDrilling = call.Number is (>= 81 and <= 89) or 840;
        var height = isDrilling && top is { } known && !double.IsNaN(known) ? known : (double?)null;
        var unknown = isDrilling ? height is null ? _state.Unknown | toolAxis : _state.Unknown & ~toolAxis : AxisSet.All;
        DependOnPlace();
        Append(MotionKind.Cycle, MotionFlags.Cycle, plane.Lift(plane.Project(_state.Position), height ?? plane.Height(_state.Position)), unknown);
    }

    // Boring with an oriented spindle (86) lifts off sideways where it is told to.
    private static bool IsFollowed(CycleCall call) => call.Number switch
    {
        81 or 82 or 84 or 840 or 85 or 87 or 88 or 89 => true,
        86 => (call[7] ?? 0) == 0 && (call[8] ?? 0) == 0,
        _ => false,
    };

    // The depth is given as a place or below the reference plane; what two values mean that disagree hangs on the version of the cycle.
    private static double? DepthOf(CycleCall call)
    {
        var below = call[1] - Math.Abs(call[4] ?? double.NaN);
        return call[4] is null ? call[3] : call[3] is not { } depth || Math.Abs(depth - below ?? 0) < 1e-9 ? below : null;
    }

    private void ToKnownHeight(MotionKind kind, double height, AxisSet toolAxis)
    {
        var plane = _state.Plane;
        if (plane.Height(_state.Position) != height || (_state.Unknown & toolAxis) != AxisSet.None)
        {
            Append(kind, MotionFlags.Cycle, plane.Lift(plane.Project(_state.Position), height), _state.Unknown & ~toolAxis);
        }
    }

    // One value a comma, null where nothing stands; NaN where only the machine knows it.
    private List<double?> ArgumentsOf(NcToken call)
    {
        var bytes = _text.Bytes.Span.Slice(call.Start, call.Length);
        var values = new List<double?>();
        var at = bytes.IndexOf((byte)'(') + 1;
        if (at == 0)
        {
            return values;
        }

        for (var (from, depth) = (at, 0); at < bytes.Length; at++)
        {
            if (bytes[at] == '"')
            {
                at = SyntaxBytes.BehindString(bytes, at, bytes.Length) - 1;
            }
            else if (bytes[at] is (byte)'(' or (byte)'[')
            {
                depth++;
            }
            else if (bytes[at] is (byte)')' or (byte)']' && depth > 0)
            {
                depth--;
            }
            else if (bytes[at] is (byte)',' or (byte)')' && depth == 0)
            {
                values.Add(bytes[from..at].Trim(" \t"u8) is { Length: > 0 } text ? text[0] == '"' ? double.NaN : Compute(call.Start + from, at - from) : null);
                from = at + 1;
            }
        }

        return values;
    }
}
