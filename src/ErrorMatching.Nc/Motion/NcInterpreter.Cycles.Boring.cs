using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>
/// Boring cycles that take the tip off the wall at the bottom: the spindle stands in one direction, the tool shifts away from the tip, leaves, and shifts back (Fanuc G76, G87).
/// How far is said by Q, but which way by a parameter of the machine; then nothing is known of the plane while the tool is shifted. I, J, K say both.
/// </content>
public sealed partial class NcInterpreter
{
    private Vector2? _cycleShift;

    private (char First, char Second) ShiftLetters => _state.Plane switch { CoordinatePlane.ZX => ('K', 'I'), CoordinatePlane.YZ => ('J', 'K'), _ => ('I', 'J') };

    // In G18 and G19 a K beside the other letter is a shift; alone it is how often the cycle runs.
    private bool ShiftsByK => _state.Cycle is NcMeaning.FineBoreCycle or NcMeaning.BackBoreCycle && _state.Plane != CoordinatePlane.XY && _words.Has(ShiftLetters.First) && _words.Has(ShiftLetters.Second);

    // Modal like the other words of a cycle: the last block counts that has one, Q or the center letters of the plane.
    private void ReadCycleShift()
    {
        var (first, second) = ShiftLetters;
        var stated = (_words.Has(first) ? BlockWords.Bit(first) : 0) | (_words.Has(second) ? BlockWords.Bit(second) : 0);
        stated &= ShiftsByK ? uint.MaxValue : ~BlockWords.Bit('K');
        if (((_words.Present | _words.Unknown) & BlockWords.Bit('Q')) != 0 || (_words.Unknown & CenterWords) != 0)
        {
            _cycleShift = null;
        }
        else if (stated != 0)
        {
            _cycleShift = new((stated & BlockWords.Bit(first)) != 0 ? Length(first) : 0, (stated & BlockWords.Bit(second)) != 0 ? Length(second) : 0);
        }
    }

    // From the bottom: off the wall, out, back over the hole.
    private void LeaveOffTheWall(MotionFlags flags, Point2 place, AxisSet unknown, double clear)
    {
        Shift(flags, place, unknown, away: true);
        ToHeight(MotionKind.Rapid, flags, clear);
        Shift(flags, place, unknown, away: false);
    }

    // The tool passes the hole off its wall, cuts upwards from the R plane below, and leaves to where it began, whatever G98 and G99 say.
    private void BackBore(MotionFlags flags, Point2 place, AxisSet unknown)
    {
        var plane = _state.Plane;
        if (plane.Project(_state.Position) != place || _state.Unknown != unknown)
        {
            Append(MotionKind.Rapid, flags, plane.Lift(place, plane.Height(_state.Position)), unknown);
        }

        Shift(flags, place, unknown, away: true);
        ToHeight(MotionKind.Rapid, flags, _cycle.Plane);
        Shift(flags, place, unknown, away: false);
        ToHeight(MotionKind.Line, flags, _cycle.Depth);
        LeaveOffTheWall(flags, place, unknown, _cycleInitial);
    }

    private void Shift(MotionFlags flags, Point2 place, AxisSet unknown, bool away)
    {
        var plane = _state.Plane;
        var to = away ? place + (_cycleShift ?? Vector2.Zero) : place;
        unknown |= away && _cycleShift is null ? plane.Axes() : AxisSet.None;

        // Stated lengths are cut to at feed, those of the parameter are rapids.
        Append(_cycleShift is null ? MotionKind.Rapid : MotionKind.Line, flags, plane.Lift(to, plane.Height(_state.Position)), unknown);
    }
}
