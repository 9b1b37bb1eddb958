using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>How boring cycles take the tip off the wall at the bottom: the spindle stops in one orientation, the tool shifts away from
/// the tip, retracts, and shifts back (Fanuc G76, G87). Q gives the distance, but a machine parameter gives the direction; then the place
/// in the plane is unknown while the tool is shifted. I, J and K give both.</summary>
internal sealed class OffTheWall(ControlState control, BlockValues values, MotionWriter writer)
{
    private Vector2? _shift;

    private (char First, char Second) ShiftLetters => control.State.Plane switch
    {
        CoordinatePlane.ZX => ('K', 'I'),
        CoordinatePlane.YZ => ('J', 'K'),
        _ => ('I', 'J'),
    };

    /// <summary>True if K is a shift: in G18 and G19, together with the other letter; alone it is the number of cycle runs.</summary>
    public bool ShiftsByK => control.State.Cycle is NcMeaning.FineBoreCycle or NcMeaning.BackBoreCycle
        && control.State.Plane != CoordinatePlane.XY && values.Words.Has(ShiftLetters.First) && values.Words.Has(ShiftLetters.Second);

    /// <summary>Clears the shift: a cycle begins.</summary>
    public void Begin() => _shift = null;

    /// <summary>Reads the shift. It is modal like the other words of a cycle: the last block with Q or the center letters of the plane
    /// applies.</summary>
    public void Read()
    {
        var (first, second) = ShiftLetters;
        var stated = (values.Words.Has(first) ? BlockWords.Bit(first) : 0) | (values.Words.Has(second) ? BlockWords.Bit(second) : 0);
        stated &= ShiftsByK ? uint.MaxValue : ~BlockWords.Bit('K');
        if (((values.Words.Present | values.Words.Unknown) & BlockWords.Bit('Q')) != 0
            || (values.Words.Unknown & BlockWords.CenterWords) != 0)
        {
            _shift = null;
        }
        else if (stated != 0)
        {
            _shift = new((stated & BlockWords.Bit(first)) != 0 ? values.Length(first) : 0,
                (stated & BlockWords.Bit(second)) != 0 ? values.Length(second) : 0);
        }
    }

    /// <summary>Shifts the tool away from the wall over a hole, or back.</summary>
    public void Shift(MotionFlags flags, Point2 place, AxisSet unknown, bool away)
    {
        var plane = control.State.Plane;
        var to = away ? place + (_shift ?? Vector2.Zero) : place;
        unknown |= away && _shift is null ? plane.Axes() : AxisSet.None;

        // A stated shift is at feed; one by the machine parameter is a rapid.
        writer.Append(_shift is null ? MotionKind.Rapid : MotionKind.Line, flags, plane.Lift(to, plane.Height(control.State.Position)),
            unknown);
    }
}
