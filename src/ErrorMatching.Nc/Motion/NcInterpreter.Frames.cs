using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>
/// Offsets and transforms as layers: machine = origin of the work offset + shift (G92, G52) + work; work = rotation of scale of mirror of frame of what is programmed.
/// Motions are in work coordinates. The tool stays where it is when a layer changes; what its coordinates are then follows as far as it is known.
/// </content>
public sealed partial class NcInterpreter
{
    private readonly Dictionary<(int Code, int Number), (Vector3 Origin, AxisSet Unknown)> _origins = [];
    private readonly List<NcFrame> _frames = [new(0, 540, 0, Vector3.Zero, AxisSet.All, Vector3.Zero, AxisSet.None, Vector3.Zero, false)];
    private (int Code, int Number) _workOffset = (540, 0);
    private Vector3 _shift;
    private AxisSet _unknownShift;
    private (Vector3 Shift, AxisSet Unknown) _suspendedShift;

    private (Vector3 Origin, AxisSet Unknown) OriginOf((int Code, int Number) offset) => _origins.TryGetValue(offset, out var known) ? known : (Vector3.Zero, AxisSet.All);

    private void NextFrame()
    {
        _flow?.Variables.ForgetMachine();
        _state.Frame++;
        var (origin, unknown) = OriginOf(_workOffset);
        _frames.Add(new(_block, _workOffset.Code, _workOffset.Number, origin, unknown, _shift, _unknownShift, IsTransformed ? Vector3.Zero : _frame?.ShiftOnly ?? Vector3.Zero, IsTransformed));
    }

    private void ChooseWorkOffset(int tenths)
    {
        var chosen = (tenths, _words.Has('P') ? (int)Math.Clamp(_words.Value('P'), 0, 1000) : 0);
        if (chosen == _workOffset && (_words.Unknown & BlockWords.Bit('P')) == 0)
        {
            return;
        }

        var (was, now) = (OriginOf(_workOffset), OriginOf(chosen));
        _workOffset = chosen;
        MoveWork(was.Origin - now.Origin, was.Unknown | now.Unknown);
        NextFrame();
    }

    // The coordinates of the place where the tool stands change by this much.
    private void MoveWork(Vector3 by, AxisSet unknown)
    {
        var (place, was) = Work(_state.Position, _state.Unknown);
        SetWork(place + by, was | unknown);
    }

    private void SetOrigin(NcMeaning meaning)
    {
        switch (meaning)
        {
            case NcMeaning.SetPosition:
                SetPosition();
                break;
            case NcMeaning.ClearPosition:
                (_suspendedShift, var (by, unknown)) = ((_shift, _unknownShift), (_shift, _unknownShift));
                (_shift, _unknownShift) = (Vector3.Zero, AxisSet.None);
                MoveWork(by, unknown);
                NextFrame();
                break;
            case NcMeaning.RestorePosition:
                var (was, wasUnknown) = (_shift, _unknownShift);
                (_shift, _unknownShift) = _suspendedShift;
                MoveWork(was - _shift, wasUnknown | _unknownShift);
                NextFrame();
                break;
            case NcMeaning.LocalShift:
                ShiftLocally();
                break;
            case NcMeaning.SetOffset:
                SetOffset();
                break;
            default:
                BeginTransform(meaning);
                break;
        }
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
        SetWork(target, (unknown & ~given) | UnknownWords());
        NextFrame();
    }

    private void ShiftLocally()
    {
        var given = GivenAxes();
        var target = Given(default(Point3) + _shift, incremental: false) - default(Point3);
        var by = Only(given, _shift - target);
        var unknown = (_unknownShift & given) | UnknownWords();
        _shift = _shift - by;
        _unknownShift = (_unknownShift & ~given) | UnknownWords();
        MoveWork(by, unknown);
        NextFrame();
    }

    // G10 L2 writes an offset; LinuxCNC's L20 writes it so that the tool gets the given coordinates. Other tables (tools) move no origin.
    private void SetOffset()
    {
        var table = _words.Has('L') ? (int)Math.Clamp(_words.Value('L'), -1, 10_000) : 2;
        var isLinuxCnc = _dialect.Syntax == NcSyntax.LinuxCnc;
        if (table is not (2 or 20))
        {
            _state.Unknown |= _state.LengthOffset ? AxisSet.Z : AxisSet.None;
            return;
        }

        var number = _words.Has('P') ? (int)Math.Clamp(_words.Value('P'), -1, 10_000) : -1;
        var offset = number switch
        {
            0 when isLinuxCnc => _workOffset,
            >= 1 and <= 6 when table == 2 || isLinuxCnc => (530 + (10 * number), 0),
            >= 7 and <= 9 when isLinuxCnc => (584 + number, 0),
            >= 1 when table == 20 => (541, number),
            _ => default,
        };
        if (offset == default || (_words.Unknown & (BlockWords.Bit('P') | BlockWords.Bit('L'))) != 0 || _words.Has('R'))
        {
            // An external offset, a rotation, or one that only the machine knows.
            NextFrame();
            _state.Unknown = AxisSet.All;
            return;
        }

        var given = GivenAxes();
        var (was, wasUnknown) = OriginOf(offset);
        var isCurrent = offset == _workOffset;
        Vector3 now;
        AxisSet nowUnknown;
        if (table == 20 && isLinuxCnc)
        {
            var (place, unknown) = Work(_state.Position, _state.Unknown);
            var (current, currentUnknown) = OriginOf(_workOffset);
            now = was + Only(given, current + (place - Given(place, incremental: false)) - was);
            nowUnknown = (wasUnknown & ~given) | ((unknown | currentUnknown) & given) | UnknownWords();
            if (isCurrent)
            {
                _origins[offset] = (now, nowUnknown);
                SetWork(Given(place, incremental: false), (unknown & ~given) | UnknownWords());
                NextFrame();
                return;
            }
        }
        else
        {
            var incremental = _state.Incremental && !isLinuxCnc;
            now = Given(default(Point3) + was, incremental) - default(Point3);
            nowUnknown = (incremental ? wasUnknown : wasUnknown & ~given) | UnknownWords();
        }

        _origins[offset] = (now, nowUnknown);
        if (isCurrent)
        {
            MoveWork(was - now, (_state.Incremental && !isLinuxCnc ? AxisSet.None : wasUnknown & given) | UnknownWords());
            NextFrame();
        }
    }

    // A place with the coordinates that the block's axis words give.
    private Point3 Given(Point3 place, bool incremental) => new(
        _words.Has('X') ? (incremental ? place.X : 0) + Length('X') : place.X,
        _words.Has('Y') ? (incremental ? place.Y : 0) + Length('Y') : place.Y,
        _words.Has('Z') ? (incremental ? place.Z : 0) + Length('Z') : place.Z);

    private AxisSet UnknownWords() => AxesOf(_words.Unknown);

    private static Vector3 Only(AxisSet axes, Vector3 v) => new(
        (axes & AxisSet.X) != AxisSet.None ? v.X : 0, (axes & AxisSet.Y) != AxisSet.None ? v.Y : 0, (axes & AxisSet.Z) != AxisSet.None ? v.Z : 0);
}
