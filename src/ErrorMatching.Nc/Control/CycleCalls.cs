using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Machining cycles with their arguments in parentheses: return plane, reference plane, safety distance, depth, depth below the
/// reference plane. Drilling, boring, tapping and hole patterns are followed; of all others, only the return plane is known. The motions
/// follow the Siemens cycles guide (docs/dialects.md lists the assumptions).</summary>
internal sealed class CycleCalls(NcControl control, Corners corners)
{
    private readonly HoleCycles _holes = new(control);
    private readonly HolePatterns _patterns = new(control);

    // The call that runs after every motion, and the block's own call.
    private CycleCall? _modal;
    private CycleCall? _once;
    private bool _nextIsModal;

    /// <summary>True if no call is pending for a motion or a block.</summary>
    public bool AreNone => _once is null && _modal is null && !_nextIsModal;

    /// <summary>True if the next call of the block runs after every motion (MCALL).</summary>
    public bool NextIsModal => _nextIsModal;

    /// <summary>MCALL: ends the modal call; the block's next call replaces it.</summary>
    public void BeginModal() => (_modal, _nextIsModal) = (null, true);

    /// <summary>Stores a call with its arguments.</summary>
    /// <param name="token">The call.</param>
    /// <param name="measures">True if the dialect says that it only touches.</param>
    public void Call(NcToken token, bool measures = false)
    {
        var name = control.Run.NameOf(token);
        var number = name.Length > 5 && Ascii.EqualsIgnoreCase(name[..5], "CYCLE"u8)
            && int.TryParse(name[5..], NumberStyles.None, CultureInfo.InvariantCulture, out var n) ? n : 0;
        var call = new CycleCall(Encoding.ASCII.GetString(name).ToUpperInvariant(), number, ArgumentsOf(token));
        call = call with { Measures = measures || MeasuresOnly(call) };
        if (_nextIsModal)
        {
            (_modal, _nextIsModal) = (call, false);
        }
        else
        {
            _once = call;
        }
    }

    /// <summary>After the block's own motion, runs the cycle that it calls or the modal call.</summary>
    public void RunBehind(bool moved)
    {
        if ((_once ?? (moved ? _modal : null)) is { } call)
        {
            _once = null;
            Run(call);
        }

        _nextIsModal = false;
    }

    private void Run(CycleCall call)
    {
        // The tool leaves the plane first, so no corner is rounded.
        corners.Drop();
        if (call.Measures)
        {
            control.Result.DependOnPlace();
            control.Moves.Append(MotionKind.Probe, MotionFlags.Cycle, control.State.Position, AxisSet.All);
            return;
        }

        if (_patterns.PlacesOf(call) is { } places)
        {
            RunPattern(places, call.Number != 801);
            return;
        }

        if (_holes.HoleOf(call) is { } hole && _holes.StrokesOf(call, hole) is { } strokes)
        {
            _holes.Run(call, hole, strokes);
            return;
        }

        // Drilling cycles end over their hole at the return plane; for other cycles (patterns, pockets and the like), even that is unknown.
        control.Result.Note("cycle-not-followed", $"{call.Name} is not followed: what it does is the control's affair.");
        var plane = control.State.Plane;
        var toolAxis = AxisSet.All & ~plane.Axes();
        var isDrilling = call.Number is (>= 81 and <= 89) or 840;
        var height = isDrilling && call[0] * control.Unit is { } known && !double.IsNaN(known) ? known : (double?)null;
        var unknown = isDrilling ? height is null ? control.State.Unknown | toolAxis : control.State.Unknown & ~toolAxis : AxisSet.All;
        control.Result.DependOnPlace();
        control.Moves.Append(MotionKind.Cycle, MotionFlags.Cycle,
            plane.Lift(plane.Project(control.State.Position), height ?? plane.Height(control.State.Position)), unknown);
    }

    // One touch along an axis that writes no offset. Its first argument says what else the cycle does.
    private static bool MeasuresOnly(CycleCall call) => call.Number == 978 && call[0] == 0;

    private void RunPattern(List<Point2> places, bool hasOrder)
    {
        var plane = control.State.Plane;
        control.Result.DependOnPlace();
        if (!hasOrder)
        {
            control.Result.Note("cycle-not-followed",
                "The places of the grid are known; in which order it goes there is the control's affair.");
        }

        foreach (var place in places)
        {
            control.Moves.Append(hasOrder ? MotionKind.Rapid : MotionKind.Cycle, MotionFlags.Cycle,
                plane.Lift(place, plane.Height(control.State.Position)), control.State.Unknown & ~plane.Axes());
            if (_modal is { } call)
            {
                Run(call);
            }
        }

        // The end at which it stops could depend on the version of the cycle.
        control.State.Unknown |= places.Count > 1 ? plane.Axes() : AxisSet.None;
    }

    // One value per argument: null if omitted, NaN if only the machine knows it.
    private List<double?> ArgumentsOf(NcToken call)
    {
        var bytes = control.Run.BytesOf(call);
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
                values.Add(bytes[from..at].Trim(" \t"u8) is { Length: > 0 } text ? text[0] == '"' ? double.NaN
                    : control.Run.Compute(call.Start + from, at - from) : null);
                from = at + 1;
            }
        }

        return values;
    }
}

/// <summary>A call of a machining cycle, with its arguments as read: null for an omitted one, NaN if only the machine knows the
/// value.</summary>
/// <param name="Name">Its name in capitals.</param>
/// <param name="Number">The number of a CYCLE; 0 for others.</param>
/// <param name="Arguments">The arguments.</param>
internal sealed record CycleCall(string Name, int Number, IReadOnlyList<double?> Arguments)
{
    /// <summary>True if it only touches: it cuts nothing and writes no offset.</summary>
    public bool Measures { get; init; }

    public double? this[int index] => index < Arguments.Count ? Arguments[index] : null;

    /// <summary>True if the program knows the values of these arguments, apart from omitted ones.</summary>
    public bool IsStated(params ReadOnlySpan<int> indexes)
    {
        foreach (var i in indexes)
        {
            if (this[i] is { } value && !double.IsFinite(value))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>True if all arguments from an index on are omitted or zero.</summary>
    public bool IsAbsent(int from)
    {
        for (var i = from; i < Arguments.Count; i++)
        {
            if (this[i] is not (null or 0))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>The depth at an argument, given as a position or relative to the reference plane. If both are given and disagree, their
    /// meaning depends on the version of the cycle.</summary>
    public double? DepthOf(int index)
    {
        var (place, reference, below) = (this[index], this[1], this[index + 1]);
        if (below is null or 0)
        {
            // No depth below the reference plane is not a hole: the position applies.
            return place;
        }

        // Without a position, the depth is downward.
        var depth = reference - Math.Abs(below.Value);
        return place is not { } stated || Math.Abs(stated - depth ?? 0) < 1e-9 ? depth : null;
    }
}
