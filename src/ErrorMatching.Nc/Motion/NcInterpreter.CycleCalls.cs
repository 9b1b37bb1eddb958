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

    // A cycle with the values that its arguments have where it stands; a modal one keeps them.
    private sealed record CycleCall(string Name, List<double?> Arguments);

    private void CallCycle(NcToken token)
    {
        var call = new CycleCall(Encoding.ASCII.GetString(NameOf(token)).ToUpperInvariant(), ArgumentsOf(token));
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
        var (name, arguments) = call;
        var number = name.StartsWith("CYCLE", StringComparison.Ordinal) && int.TryParse(name.AsSpan(5), NumberStyles.None, CultureInfo.InvariantCulture, out var n) ? n : 0;
        var plane = _state.Plane;
        var toolAxis = AxisSet.All & ~plane.Axes();
        var (top, reference, safety) = (Argument(arguments, 0), Argument(arguments, 1), Argument(arguments, 2) ?? 0);
        var depth = Argument(arguments, 3) ?? (Argument(arguments, 4) is { } below ? reference - Math.Abs(below) : null);
        var feedsOut = number is 84 or 840 or 85 or 89;
        var isFollowed = number is 81 or 82 or 84 or 840 or 85 or 86 or 87 or 88 or 89;
        if (isFollowed && top is { } t && reference is { } r && depth is { } d && !double.IsNaN(t + r + d + safety))
        {
            var start = r + (d < r ? Math.Abs(safety) : -Math.Abs(safety));
            ToKnownHeight(MotionKind.Rapid, start, toolAxis);
            ToKnownHeight(MotionKind.Line, d, toolAxis);
            if (feedsOut)
            {
                ToKnownHeight(MotionKind.Line, start, toolAxis);
            }

            ToKnownHeight(MotionKind.Rapid, t, toolAxis);
            return;
        }

        Note("cycle-not-followed", $"{name} is not followed: what it does is the control's affair.");
        var isPattern = number is 0 or >= 800 or < 81;
        var height = top is { } known && !double.IsNaN(known) && !isPattern ? known : plane.Height(_state.Position);
        var unknown = isPattern ? AxisSet.All : top is null || double.IsNaN(top.Value) ? _state.Unknown | toolAxis : _state.Unknown & ~toolAxis;
        DependOnPlace();
        Append(MotionKind.Cycle, MotionFlags.Cycle, plane.Lift(plane.Project(_state.Position), height), unknown);
    }

    private void ToKnownHeight(MotionKind kind, double height, AxisSet toolAxis)
    {
        var plane = _state.Plane;
        if (plane.Height(_state.Position) != height || (_state.Unknown & toolAxis) != AxisSet.None)
        {
            Append(kind, MotionFlags.Cycle, plane.Lift(plane.Project(_state.Position), height), _state.Unknown & ~toolAxis);
        }
    }

    private static double? Argument(List<double?> arguments, int index) => index < arguments.Count ? arguments[index] : null;

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
