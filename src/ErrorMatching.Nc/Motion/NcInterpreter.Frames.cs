using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>
/// Offsets and transforms as layers: machine = origin of the work offset + shift (G92, G52) + work; work = rotation of scale of mirror of frame of what is programmed.
/// Motions are in work coordinates. The tool stays where it is when a layer changes; what its coordinates are then follows as far as it is known.
/// </content>
public sealed partial class NcInterpreter
{
    private readonly Dictionary<(int Code, int Number), WorkOrigin> _origins = [];
    private readonly List<NcFrame> _frames = [new(0, 540, 0, Vector3.Zero, AxisSet.All, null, Vector3.Zero, AxisSet.None, Vector3.Zero, false)];
    private (int Code, int Number) _workOffset = (540, 0);
    private bool _isWorkOffsetUnsure;
    private Vector3 _shift;
    private AxisSet _unknownShift;

    // The part of the shift that is G52's.
    private (Vector3 Vector, AxisSet Unknown) _localShift;

    // What G92.3 brings back: before the program has set a shift itself, only the machine knows it.
    private (Vector3 Shift, AxisSet Unknown) _keptShift = (Vector3.Zero, AxisSet.All);

    // Only LinuxCNC's work offsets turn.
    private WorkOrigin OriginOf((int Code, int Number) offset) =>
        _origins.TryGetValue(offset, out var known) ? known : new(Vector3.Zero, AxisSet.All, _dialect.Syntax == NcSyntax.LinuxCnc ? null : 0);

    private void NextFrame()
    {
        _flow?.Variables.ForgetMachine();
        _state.Frame++;
        var origin = OriginOf(_workOffset);
        _frames.Add(new(_block, _workOffset.Code, _workOffset.Number, origin.Place, origin.Unknown, origin.Degrees, _shift, _unknownShift, IsTransformed ? Vector3.Zero : _frame?.ShiftOnly ?? Vector3.Zero, IsTransformed));
    }

    // Whatever ran unseen could have written offsets and stored places, and chosen another offset.
    private void ForgetOrigins()
    {
        _origins.Clear();
        _references.Clear();
        (_isWorkOffsetUnsure, _unknownShift, _keptShift, _localShift) = (true, AxisSet.All, (Vector3.Zero, AxisSet.All), (Vector3.Zero, AxisSet.All));
    }

    private void ChooseWorkOffset((int Code, int Number) chosen, bool isKnown)
    {
        if (chosen == _workOffset && !_isWorkOffsetUnsure && isKnown)
        {
            return;
        }

        var (was, now) = (OriginOf(_workOffset), OriginOf(chosen));
        (_workOffset, _isWorkOffsetUnsure) = (chosen, false);
        SeeFrom(was, now, was.Unknown | now.Unknown, _shift);
        NextFrame();
    }

    private void SeeFrom(WorkOrigin was, WorkOrigin now, AxisSet unknownDifference, Vector3 shift)
    {
        var (place, unknown) = Work(_state.Position, _state.Unknown);
        (place, unknown) = WorkOrigin.Reseen(place, unknown, was, now, unknownDifference, shift, _unknownShift);
        SetWork(place, unknown);
    }

    // The coordinates of the place where the tool stands change by this much.
    private void MoveWork(Vector3 by, AxisSet unknown)
    {
        var (place, was) = Work(_state.Position, _state.Unknown);
        SetWork(place + by, was | unknown);
    }

    private void SetOrigin(NcMeaning meaning)
    {
        LoseCorner();
        switch (meaning)
        {
            case NcMeaning.SetPosition:
                SetPosition();
                _keptShift = (_shift, _unknownShift);
                break;
            case NcMeaning.ClearPosition:
                ChangeShift(Vector3.Zero, AxisSet.None);
                _keptShift = (_shift, _unknownShift);
                break;
            case NcMeaning.SuspendPosition:
                ChangeShift(Vector3.Zero, AxisSet.None);
                break;
            case NcMeaning.RestorePosition:
                ChangeShift(_keptShift.Shift, _keptShift.Unknown);
                break;
            case NcMeaning.LocalShift:
                ShiftLocally();
                _keptShift = (_shift, _unknownShift);
                break;
            case NcMeaning.SetOffset:
                SetOffset();
                break;
            case NcMeaning.ToolLength:
                SetToolLength();
                break;
            default:
                BeginTransform(meaning);
                break;
        }
    }

    private void ChangeShift(Vector3 to, AxisSet unknown)
    {
        var (by, unknownBy) = (_shift - to, _unknownShift | unknown);
        (_shift, _unknownShift) = (to, unknown);
        MoveWork(by, unknownBy);
        NextFrame();
    }

    private void SetPosition()
    {
        var given = GivenAxes();
        if (given == AxisSet.None)
        {
            return;
        }

        var (place, unknown) = Work(_state.Position, _state.Unknown);
        var target = Given(place, incremental: false);
        _shift += Only(given, place - target);
        _unknownShift |= unknown & given;
        _localShift = (_localShift.Vector - Only(given, _localShift.Vector), _localShift.Unknown & ~given);
        SetWork(target, (unknown & ~given) | UnknownWords());
        NextFrame();
    }

    // LinuxCNC has one shift for G52 and G92; elsewhere that of G52 lies on top and is kept apart.
    private void ShiftLocally()
    {
        var given = GivenAxes();
        var isOnly = _dialect.Syntax == NcSyntax.LinuxCnc;
        var (was, wasUnknown) = isOnly ? (_shift, _unknownShift) : _localShift;
        var by = Only(given, was - (Given(default(Point3) + was, incremental: false) - default(Point3)));
        var nowUnknown = (wasUnknown & ~given) | UnknownWords();
        _shift -= by;
        _unknownShift = isOnly ? nowUnknown : _unknownShift | UnknownWords();
        _localShift = isOnly ? _localShift : (was - by, nowUnknown);
        MoveWork(by, (wasUnknown & given) | UnknownWords());
        NextFrame();
    }

    // A place with the coordinates that the block's axis words give.
    private Point3 Given(Point3 place, bool incremental) => new(
        _words.Has('X') ? (incremental ? place.X : 0) + Length('X') : place.X,
        _words.Has('Y') ? (incremental ? place.Y : 0) + Length('Y') : place.Y,
        _words.Has('Z') ? (incremental ? place.Z : 0) + Length('Z') : place.Z);

    // Of a word that stands twice nobody knows which one counts.
    private AxisSet UnknownWords() => AxesOf(_words.Unknown | _words.Repeated);

    private static Vector3 Only(AxisSet axes, Vector3 v) => new(
        (axes & AxisSet.X) != AxisSet.None ? v.X : 0, (axes & AxisSet.Y) != AxisSet.None ? v.Y : 0, (axes & AxisSet.Z) != AxisSet.None ? v.Z : 0);
}
