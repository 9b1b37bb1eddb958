using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <content>Offsets that the program writes (G10).</content>
public sealed partial class NcInterpreter
{
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

        var offset = WrittenOffset(table, isLinuxCnc);
        if (offset == default || (_words.Unknown & (BlockWords.Bit('P') | BlockWords.Bit('L'))) != 0 || (_words.Has('R') && !isLinuxCnc))
        {
            // An external offset, or one that only the machine knows.
            ForgetOrigins();
            NextFrame();
            _state.Unknown = AxisSet.All;
            return;
        }

        if (table == 20 && isLinuxCnc)
        {
            TouchOff(offset);
        }
        else
        {
            WriteOffset(offset, _state.Incremental && !isLinuxCnc, isLinuxCnc);
        }
    }

    private (int Code, int Number) WrittenOffset(int table, bool isLinuxCnc)
    {
        var number = _words.Has('P') ? (int)Math.Clamp(_words.Value('P'), -1, 10_000) : -1;
        return number switch
        {
            0 when isLinuxCnc => _workOffset,
            >= 1 and <= 6 when table == 2 || isLinuxCnc => (530 + (10 * number), 0),
            >= 7 and <= 9 when isLinuxCnc => (584 + number, 0),
            >= 1 when table == 20 => (541, number),
            _ => default,
        };
    }

    private void WriteOffset((int Code, int Number) offset, bool incremental, bool isLinuxCnc)
    {
        var given = GivenAxes();
        var was = OriginOf(offset);
        var turns = _words.Has('R') || (_words.Unknown & BlockWords.Bit('R')) != 0;
        var now = new WorkOrigin(
            Given(default(Point3) + was.Place, incremental) - default(Point3),
            (incremental ? was.Unknown : was.Unknown & ~given) | UnknownWords(),
            !turns ? was.Degrees : (_words.Unknown & BlockWords.Bit('R')) == 0 ? _words.Value('R') : null);
        _origins[offset] = now;
        if (offset == _workOffset)
        {
            // Measured with rs274: what it rotates is the place less the shift of G92.
            var difference = (incremental ? AxisSet.None : was.Unknown & given) | UnknownWords();
            SeeFrom(was, now with { KeepsRotation = !turns }, difference, isLinuxCnc ? Vector3.Zero : _shift);
            NextFrame();
        }
    }

    // The offset is moved so that the place where the tool stands has the given coordinates in it.
    private void TouchOff((int Code, int Number) offset)
    {
        var given = GivenAxes();
        var (was, current) = (OriginOf(offset), OriginOf(_workOffset));
        var (place, unknown) = Work(_state.Position, _state.Unknown);
        var isCurrent = offset == _workOffset;
        if (was.Degrees == 0 && current.Degrees == 0)
        {
            var now = was.Place + Only(given, current.Place + (place - Given(place, incremental: false)) - was.Place);
            _origins[offset] = new(now, (was.Unknown & ~given) | ((unknown | current.Unknown) & given) | UnknownWords(), 0);
        }
        else
        {
            var (seen, unknownSeen) = isCurrent ? (place, unknown) : WorkOrigin.Reseen(place, unknown, current, was, current.Unknown | was.Unknown, _shift, _unknownShift);
            var by = seen - Given(seen, incremental: false);
            var plane = given & (AxisSet.X | AxisSet.Y);
            var unknownBy = WorkOrigin.Mixed((unknownSeen & given) | UnknownWords() | (was.Degrees is null ? plane : AxisSet.None));
            _origins[offset] = was with { Place = was.Place + WorkOrigin.Turned(by, was.Degrees ?? 0), Unknown = was.Unknown | unknownBy };
        }

        if (isCurrent)
        {
            SetWork(Given(place, incremental: false), (unknown & ~given) | UnknownWords());
            NextFrame();
        }
    }
}
