using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Codes that select a work offset (G54) or write one (G10).</summary>
internal sealed class OffsetCodes(ControlState control, BlockValues values, CoordinateLayers layers)
{
    /// <summary>Selects an offset.</summary>
    /// <param name="chosen">The code times ten, and its P word.</param>
    /// <param name="isKnown">False if the P word is a value that only the machine knows.</param>
    public void Choose((int Code, int Number) chosen, bool isKnown)
    {
        if (chosen == layers.Offsets.Chosen && !layers.Offsets.IsUnsure && isKnown)
        {
            return;
        }

        var (was, now) = (layers.Offsets.Origin, layers.Offsets.OriginOf(chosen));
        layers.Offsets.Choose(chosen);
        layers.SeeFrom(was, now, was.Unknown | now.Unknown, layers.Shift.Vector);
        layers.NextFrame();
    }

    /// <summary>G10 L2 writes an offset; LinuxCNC's L20 writes it so that the tool gets the given coordinates. Other tables (tools) do
    /// not move an origin.</summary>
    public void Write()
    {
        var table = values.Words.Has('L') ? (int)Math.Clamp(values.Words.Value('L'), -1, 10_000) : 2;
        var isLinuxCnc = values.Dialect.Syntax == NcSyntax.LinuxCnc;
        if (table is not (2 or 20))
        {
            control.State.Unknown |= control.State.LengthOffset ? AxisSet.Z : AxisSet.None;
            return;
        }

        var offset = WrittenOffset(table, isLinuxCnc);
        if (offset == default || (values.Words.Unknown & (BlockWords.Bit('P') | BlockWords.Bit('L'))) != 0
            || (values.Words.Has('R') && !isLinuxCnc))
        {
            // An external offset, or one that only the machine knows.
            layers.ForgetOrigins();
            layers.NextFrame();
            control.State.Unknown = AxisSet.All;
            return;
        }

        if (table == 20 && isLinuxCnc)
        {
            TouchOff(offset);
        }
        else
        {
            WriteTo(offset, control.State.Incremental && !isLinuxCnc, isLinuxCnc);
        }
    }

    private (int Code, int Number) WrittenOffset(int table, bool isLinuxCnc)
    {
        var number = values.Words.Has('P') ? (int)Math.Clamp(values.Words.Value('P'), -1, 10_000) : -1;
        return number switch
        {
            0 when isLinuxCnc => layers.Offsets.Chosen,
            >= 1 and <= 6 when table == 2 || isLinuxCnc => (530 + (10 * number), 0),
            >= 7 and <= 9 when isLinuxCnc => (584 + number, 0),
            >= 1 when table == 20 => (541, number),
            _ => default,
        };
    }

    private void WriteTo((int Code, int Number) offset, bool incremental, bool isLinuxCnc)
    {
        var given = values.GivenAxes();
        var was = layers.Offsets.OriginOf(offset);
        var turns = values.Words.Has('R') || (values.Words.Unknown & BlockWords.Bit('R')) != 0;
        var now = new WorkOrigin(
            values.Given(default(Point3) + was.Place, incremental) - default(Point3),
            (incremental ? was.Unknown : was.Unknown & ~given) | values.UnknownWords(),
            !turns ? was.Degrees : (values.Words.Unknown & BlockWords.Bit('R')) == 0 ? values.Words.Value('R') : null);
        layers.Offsets.Write(offset, now);
        if (offset == layers.Offsets.Chosen)
        {
            // Measured with rs274: it rotates the place minus the shift of G92.
            var difference = (incremental ? AxisSet.None : was.Unknown & given) | values.UnknownWords();
            layers.SeeFrom(was, now with { KeepsRotation = !turns }, difference, isLinuxCnc ? Vector3.Zero : layers.Shift.Vector);
            layers.NextFrame();
        }
    }

    // Moves the offset so that the tool's current place has the given coordinates in it.
    private void TouchOff((int Code, int Number) offset)
    {
        var given = values.GivenAxes();
        var (was, current) = (layers.Offsets.OriginOf(offset), layers.Offsets.Origin);
        var (place, unknown) = layers.Tool();
        var isCurrent = offset == layers.Offsets.Chosen;
        if (was.Degrees == 0 && current.Degrees == 0)
        {
            var now = was.Place + given.PartOf(current.Place + (place - values.Given(place, incremental: false)) - was.Place);
            layers.Offsets.Write(offset,
                new(now, (was.Unknown & ~given) | ((unknown | current.Unknown) & given) | values.UnknownWords(), 0));
        }
        else
        {
            var (seen, unknownSeen) = isCurrent ? (place, unknown)
                : WorkOrigin.Reseen(place, unknown, current, was, current.Unknown | was.Unknown, layers.Shift.Vector, layers.Shift.Unknown);
            var by = seen - values.Given(seen, incremental: false);
            var plane = given & (AxisSet.X | AxisSet.Y);
            var unknownBy = WorkOrigin.Mixed((unknownSeen & given) | values.UnknownWords() | (was.Degrees is null ? plane : AxisSet.None));
            layers.Offsets.Write(offset,
                was with { Place = was.Place + WorkOrigin.Turned(by, was.Degrees ?? 0), Unknown = was.Unknown | unknownBy });
        }

        if (isCurrent)
        {
            layers.SetTool(values.Given(place, incremental: false), (unknown & ~given) | values.UnknownWords());
            layers.NextFrame();
        }
    }
}
