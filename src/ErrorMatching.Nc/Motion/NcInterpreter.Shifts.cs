using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>Shifts of the origin on top of the work offset: that of G92, which can be suspended and brought back, and that of G52.</content>
public sealed partial class NcInterpreter
{
    private (Vector3 Vector, AxisSet Unknown) _shift;
    private (Vector3 Vector, AxisSet Unknown) _localShift;

    // What G92.3 brings back; a program does not say what was set before it.
    private (Vector3 Vector, AxisSet Unknown) _storedShift = (Vector3.Zero, AxisSet.All);

    private (Vector3 Vector, AxisSet Unknown) Shift => (_shift.Vector + _localShift.Vector, _shift.Unknown | _localShift.Unknown);

    private void ChangeShift(NcMeaning meaning)
    {
        switch (meaning)
        {
            case NcMeaning.SetPosition:
                SetPosition();
                break;
            case NcMeaning.ClearPosition:
                SetShift(default);
                _storedShift = default;
                break;
            case NcMeaning.SuspendPosition:
                SetShift(default);
                break;
            case NcMeaning.RestorePosition:
                SetShift(_storedShift);
                break;
            case NcMeaning.LocalShift when _dialect.Syntax == NcSyntax.LinuxCnc:
                SetShift(Shifted(_shift));
                _storedShift = _shift;
                break;
            default:
                ShiftLocally();
                break;
        }
    }

    private void SetShift((Vector3 Vector, AxisSet Unknown) shift)
    {
        var was = _shift;
        _shift = shift;
        MoveWork(was.Vector - shift.Vector, was.Unknown | shift.Unknown);
        NextFrame();
    }

    // The tool stays, and has the given coordinates. A local shift of these axes is then part of the whole.
    private void SetPosition()
    {
        var given = GivenAxes();
        if (given == AxisSet.None)
        {
            return;
        }

        var (place, unknown) = Work(_state.Position, _state.Unknown);
        var target = Given(place, incremental: false);
        var local = Only(given, _localShift.Vector);
        _shift = (_shift.Vector + Only(given, place - target) + local, _shift.Unknown | ((unknown | _localShift.Unknown) & given));
        _localShift = (_localShift.Vector - local, _localShift.Unknown & ~given);
        _storedShift = _shift;
        SetWork(target, (unknown & ~given) | UnknownWords());
        NextFrame();
    }

    private void ShiftLocally()
    {
        var was = _localShift;
        _localShift = Shifted(was);
        MoveWork(was.Vector - _localShift.Vector, (was.Unknown & GivenAxes()) | UnknownWords());
        NextFrame();
    }

    // A shift with the coordinates that the block gives.
    private (Vector3 Vector, AxisSet Unknown) Shifted((Vector3 Vector, AxisSet Unknown) shift) =>
        (Given(default(Point3) + shift.Vector, incremental: false) - default(Point3), (shift.Unknown & ~GivenAxes()) | UnknownWords());
}
