using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The work offsets as far as the program itself sets them, and the selected one.</summary>
/// <param name="dialect">The control.</param>
internal sealed class WorkOffsets(NcDialect dialect)
{
    private readonly Dictionary<(int Code, int Number), WorkOrigin> _known = [];

    private readonly bool _turn = dialect.Ways.WorkOffsetsTurn;

    public (int Code, int Number) Chosen { get; private set; } = (dialect.FirstWorkOffset, 0);

    /// <summary>True if something unseen, or a value that only the machine knows, could have selected another one.</summary>
    public bool IsUnsure { get; set; }

    /// <summary>The origin of the selected one.</summary>
    public WorkOrigin Origin => IsUnsure ? Unknown : OriginOf(Chosen);

    private WorkOrigin Unknown => new(Vector3.Zero, AxisSet.All, _turn ? null : 0);

    public WorkOrigin OriginOf((int Code, int Number) offset) => _known.TryGetValue(NameOf(offset), out var known) ? known : Unknown;

    /// <summary>Whether it is the selected one, by any of its names; null if nobody knows.</summary>
    public bool? IsChosen((int Code, int Number) offset) =>
        IsUnsure ? null
        : NameOf(offset) == NameOf(Chosen) ? true
        : dialect.WorkOffsetOf(Chosen).IsInTable ? false
        : null;

    public void Write((int Code, int Number) offset, WorkOrigin origin) => _known[NameOf(offset)] = origin;

    public void Choose((int Code, int Number) offset, bool isKnown) => (Chosen, IsUnsure) = (offset, !isKnown);

    public void Forget()
    {
        _known.Clear();
        IsUnsure = true;
    }

    private (int Code, int Number) NameOf((int Code, int Number) offset) => dialect.WorkOffsetOf(offset).Offset;
}

/// <summary>Origin and rotation of a work offset: machine = place + rotation about Z of (work + shift).</summary>
/// <param name="Place">Its origin in machine coordinates, mm.</param>
/// <param name="Unknown">Axes in which only the machine knows the origin.</param>
/// <param name="Degrees">Its rotation in the XY plane; null if only the machine knows it.</param>
internal readonly record struct WorkOrigin(Vector3 Place, AxisSet Unknown, double? Degrees)
{
    private const AxisSet Flat = AxisSet.X | AxisSet.Y;

    /// <summary>True if it is the compared offset, written without a rotation: the rotation stays the same, whatever it is.</summary>
    public bool KeepsRotation { get; init; }

    /// <summary>A rotation mixes the two coordinates: if one is unknown, both become unknown.</summary>
    public static AxisSet Mixed(AxisSet unknown) => (unknown & Flat) != AxisSet.None ? unknown | Flat : unknown;

    /// <summary>A vector turned about Z.</summary>
    public static Vector3 Turned(Vector3 by, double degrees) =>
        degrees == 0 ? by : ProgramFrame.Rotation(CoordinatePlane.XY, default, degrees).Turn(by);

    /// <summary>The coordinates of a place after its work offset changes.</summary>
    /// <param name="place">The place in the old offset.</param>
    /// <param name="unknown">Its unknown coordinates.</param>
    /// <param name="was">The old offset.</param>
    /// <param name="now">The new offset.</param>
    /// <param name="unknownDifference">Axes in which the distance between the two is unknown.</param>
    /// <param name="shift">The shift on top of both (G92).</param>
    /// <param name="unknownShift">Axes in which that shift is unknown.</param>
    public static (Point3 Place, AxisSet Unknown) Reseen(
        Point3 place, AxisSet unknown, WorkOrigin was, WorkOrigin now, AxisSet unknownDifference, Vector3 shift, AxisSet unknownShift)
    {
        var by = was.Place - now.Place;
        if (was.Degrees is { } from && now.Degrees is { } to)
        {
            return from == to
                ? (place + Turned(by, -to), unknown | (to == 0 ? unknownDifference : Mixed(unknownDifference)))
                : (
                    default(Point3) + (Turned(Turned(place - default(Point3) + shift, from) + by, -to) - shift),
                    Mixed(unknown | unknownDifference | (unknownShift & Flat)));
        }

        var isStraight = now.KeepsRotation && by.X == 0 && by.Y == 0 && (unknownDifference & Flat) == AxisSet.None;
        return (place + by, unknown | unknownDifference | (isStraight ? AxisSet.None : Flat));
    }
}

/// <summary>Codes that select a work offset (G54) or write one (G10).</summary>
internal sealed class OffsetCodes(NcControl control)
{
    private readonly CoordinateLayers _layers = control.Layers;

    /// <summary>Selects an offset.</summary>
    /// <param name="chosen">The code times ten, and its P word.</param>
    /// <param name="isKnown">False if the P word is a value that only the machine knows.</param>
    public void Choose((int Code, int Number) chosen, bool isKnown)
    {
        if (chosen == _layers.Offsets.Chosen && !_layers.Offsets.IsUnsure && isKnown)
        {
            return;
        }

        var isSame = isKnown && _layers.Offsets.IsChosen(chosen) == true;
        var was = _layers.Offsets.Origin;
        _layers.Offsets.Choose(chosen, isKnown);
        if (!isSame)
        {
            var now = _layers.Offsets.Origin;
            _layers.SeeFrom(was, now, was.Unknown | now.Unknown, _layers.Shift.Vector);
        }

        _layers.NextFrame();
    }

    /// <summary>G10: writes what the dialect says of its L word. If that is not known, neither is the tool's place.</summary>
    public void Write()
    {
        var letters = BlockWords.Bit('L') | BlockWords.Bit('P');
        var isKnown = control.Words.Has('L') && ((control.Words.Unknown | control.Words.Repeated) & letters) == 0;
        var table = isKnown ? control.Dialect.OffsetTableOf((int)Math.Clamp(control.Words.Value('L'), -1, 10_000)) : null;
        if (table is { Means: OffsetWriting.Tool })
        {
            control.State.Unknown |= _layers.Length.UnknownIn(control.State);
            return;
        }

        if (table is null or { Means: OffsetWriting.Unknown } || WrittenOffset(table) is not { } offset
            || (control.Words.Has('R') && !Turns)
            || (table.Means == OffsetWriting.AbsoluteOrigin && control.State.Incremental))
        {
            // An offset of the machine, or one that only it knows.
            _layers.ForgetOrigins();
            _layers.NextFrame();
            control.State.Unknown = AxisSet.All;
            return;
        }

        if (table.Means == OffsetWriting.TouchOff)
        {
            if (table.IsAssumed)
            {
                control.Result.Note("touch-off",
                    "G10 L20 is taken to give the tool's place the coordinates of its block, as on LinuxCNC and grbl. "
                    + "Controls of Fanuc's kind write another offset by it.");
            }

            TouchOff(offset);
        }
        else
        {
            WriteTo(offset, control.State.Incremental && table.Means == OffsetWriting.OriginByDistance);
        }
    }

    private bool Turns => control.Dialect.Ways.WorkOffsetsTurn;

    private (int Code, int Number)? WrittenOffset(OffsetTable table)
    {
        var number = control.Words.Has('P') ? control.Words.Value('P') : -1;
        return number == 0 && table.ZeroIsActive && !_layers.Offsets.IsUnsure ? _layers.Offsets.Chosen
            : number is >= 1 and <= 10_000 && number == Math.Floor(number) ? table.Offset((int)number)
            : null;
    }

    private void WriteTo((int Code, int Number) offset, bool incremental)
    {
        var isChosen = _layers.Offsets.IsChosen(offset);
        var given = control.Values.GivenAxes();
        var was = _layers.Offsets.OriginOf(offset);
        var turns = control.Words.Has('R') || (control.Words.Unknown & BlockWords.Bit('R')) != 0;
        var now = new WorkOrigin(
            control.Values.Given(default(Point3) + was.Place, incremental) - default(Point3),
            (incremental ? was.Unknown : was.Unknown & ~given) | control.Values.UnknownWords(),
            !turns ? was.Degrees : (control.Words.Unknown & BlockWords.Bit('R')) == 0 ? control.Words.Value('R') : null);
        _layers.Offsets.Write(offset, now);
        if (isChosen is null)
        {
            control.State.Unknown = AxisSet.All;
            _layers.NextFrame();
        }
        else if (isChosen == true)
        {
            // Measured with rs274: it rotates the place minus the shift of G92.
            var difference = (incremental ? AxisSet.None : was.Unknown & given) | control.Values.UnknownWords();
            _layers.SeeFrom(was, now with { KeepsRotation = !turns }, difference, Turns ? Vector3.Zero : _layers.Shift.Vector);
            _layers.NextFrame();
        }
    }

    // Moves the offset so that the tool's current place has the given coordinates in it.
    private void TouchOff((int Code, int Number) offset)
    {
        var given = control.Values.GivenAxes();
        var (was, current) = (_layers.Offsets.OriginOf(offset), _layers.Offsets.Origin);
        var (shift, (place, unknown)) = (_layers.Shift, _layers.Tool());
        if (_layers.Offsets.IsChosen(offset) is not { } isCurrent)
        {
            _layers.Offsets.Write(offset, was with { Unknown = AxisSet.All });
            control.State.Unknown = AxisSet.All;
            _layers.NextFrame();
            return;
        }

        if (was.Degrees == 0 && current.Degrees == 0)
        {
            var now = was.Place + given.PartOf(current.Place + (place - control.Values.Given(place, incremental: false)) - was.Place);
            _layers.Offsets.Write(offset,
                new(now, (was.Unknown & ~given) | ((unknown | current.Unknown) & given) | control.Values.UnknownWords(), 0));
        }
        else
        {
            var (seen, unknownSeen) = isCurrent ? (place, unknown)
                : WorkOrigin.Reseen(place, unknown, current, was, current.Unknown | was.Unknown, shift.Vector, shift.Unknown);
            var by = seen - control.Values.Given(seen, incremental: false);
            var unknownTurn = was.Degrees is null ? given & (AxisSet.X | AxisSet.Y) : AxisSet.None;
            var unknownBy = WorkOrigin.Mixed((unknownSeen & given) | control.Values.UnknownWords() | unknownTurn);
            _layers.Offsets.Write(offset,
                was with { Place = was.Place + WorkOrigin.Turned(by, was.Degrees ?? 0), Unknown = was.Unknown | unknownBy });
        }

        if (isCurrent)
        {
            _layers.SetTool(control.Values.Given(place, incremental: false), (unknown & ~given) | control.Values.UnknownWords());
            _layers.NextFrame();
        }
    }
}
