using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>
/// Machining cycles with their arguments in parentheses: return plane, reference plane, safety distance, depth, depth below the reference plane. Drilling, boring, tapping and
/// patterns of holes are followed; of all others only the return plane is known. The motions are those of the Siemens cycles guide (docs/dialects.md says what of them is assumed).
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
        if (PatternOf(call) is { } places)
        {
            RunPattern(places, call.Number != 801);
            return;
        }

        if (HoleOf(call) is { } hole && StrokesOf(call, hole) is { } strokes)
        {
            RunHole(call, hole, strokes);
            return;
        }

        // Drilling cycles end over their hole at the return plane; of patterns, pockets and the like not even that is known.
        Note("cycle-not-followed", $"{call.Name} is not followed: what it does is the control's affair.");
        var plane = _state.Plane;
        var toolAxis = AxisSet.All & ~plane.Axes();
        var isDrilling = call.Number is (>= 81 and <= 89) or 840;
        var height = isDrilling && call[0] * Unit is { } known && !double.IsNaN(known) ? known : (double?)null;
        var unknown = isDrilling ? height is null ? _state.Unknown | toolAxis : _state.Unknown & ~toolAxis : AxisSet.All;
        DependOnPlace();
        Append(MotionKind.Cycle, MotionFlags.Cycle, plane.Lift(plane.Project(_state.Position), height ?? plane.Height(_state.Position)), unknown);
    }

    private double Unit => _state.Inch ? MmPerInch : 1;

    private void ToKnownHeight(MotionKind kind, double height)
    {
        var plane = _state.Plane;
        var toolAxis = AxisSet.All & ~plane.Axes();
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
