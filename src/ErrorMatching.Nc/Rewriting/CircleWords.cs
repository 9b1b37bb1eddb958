using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>The words of arcs: centers on the grid of increments, and radii as long as they can describe the arc.</summary>
/// <param name="change">New joints and centers.</param>
/// <param name="grid">The numbers that words can express.</param>
/// <param name="edit">The opened block.</param>
internal sealed class CircleWords(PathChange change, IncrementGrid grid, BlockEdit edit)
{
    /// <summary>How far an arc may be from where it is wanted, in increments: its ends and its center are rounded.</summary>
    private const double MostRounding = 1.6;

    private readonly NcPath _path = change.Path;

    /// <summary>The words of centers that other blocks state.</summary>
    public PoleWords Poles { get; } = new(change, grid);

    /// <summary>Sets the words of an arc.</summary>
    /// <returns>The reason why they cannot be set, or null.</returns>
    public Refusal? Set(int index, in NcMotion motion)
    {
        var (start, end) = (grid.Rounded(motion.Start, index, motion.Plane), grid.Rounded(motion.End, index + 1, motion.Plane));
        var exact = change.CenterOf(index, motion);
        var isShift = IsShift(index, motion, exact - motion.Center);

        // An end at an angle about a center goes along with that, in each form.
        var flags = isShift && motion.Has(MotionFlags.PolarEnd) ? motion.Flags & ~(MotionFlags.PolarEnd | MotionFlags.Transformed)
            : motion.Flags;
        if (motion.Has(MotionFlags.CenterBefore) && Obstacles.Of(_path, motion with { Flags = flags }) is { } obstacle)
        {
            return obstacle;
        }

        if (isShift)
        {
            return ShiftCenter(index, motion);
        }

        var wanted = Arc2.Between(
            motion.PlaneStart + change.PlaneMoveOf(index, motion.Plane),
            motion.PlaneEnd + change.PlaneMoveOf(index + 1, motion.Plane),
            exact,
            motion.Kind == MotionKind.ArcCounterClockwise);
        if (start == motion.PlaneStart && end == motion.PlaneEnd && motion.Arc.FurthestFrom(wanted.Circle) < grid.Increment)
        {
            // The control cannot resolve so small a wish.
            return null;
        }

        var (first, second) = CenterLetters(motion.Plane);
        foreach (var letter in (ReadOnlySpan<byte>)[first, second, (byte)'R', NcAddress.CircleRadius])
        {
            if (edit.Computed(letter) is not null)
            {
                return Obstacles.Computed(_path, motion);
            }
        }

        if (motion.Has(MotionFlags.ByRadius))
        {
            return SetRadius(index, motion, start, end, wanted);
        }

        if (motion.Has(MotionFlags.CenterBefore))
        {
            var (x, y) = CenterGrid.Choose(motion.Center, start, end, wanted, default(Vector2), grid.Increment);
            Poles.Want(index, new((x ?? 0, y ?? 0), (start, end, exact)));
            return Stray(index, motion, start, end, At(motion.Center, x ?? 0, y ?? 0), wanted);
        }

        var origin = CenterOrigin(motion, start, first, second);
        var was = new Vector2((edit.Number(first)?.Value ?? 0) * grid.Unit, (edit.Number(second)?.Value ?? 0) * grid.Unit);
        var (i, j) = CenterGrid.Choose(origin, start, end, wanted, was, grid.Increment);
        SetCenterWord(first, i);
        SetCenterWord(second, j);
        return Stray(index, motion, start, end, i is null ? origin + was : At(origin, i.Value, j!.Value), wanted);
    }

    private Point2 At(Point2 origin, long first, long second) => origin + new Vector2(first * grid.Increment, second * grid.Increment);

    // What rounding may leave of an arc anywhere between its ends is little. An arc of more than half a turn that follows one of its ends
    // can move by several times as much between them: its center moves by what turns the short chord, times its distance from that.
    private Refusal? Stray(int index, in NcMotion motion, Point2 start, Point2 end, Point2 center, Arc2 wanted)
    {
        var arc = Arc2.Between(start, end, center, wanted.IsCounterClockwise);
        var allowed = (MostRounding * grid.Increment) + ArcCenter.Mismatch(motion.PlaneStart, motion.PlaneEnd, motion.Center);
        if (arc.FurthestFrom(wanted.Circle) > allowed)
        {
            return BlockRefusal.At(
                _path.Program, motion.Block, NcRefusalCodes.ArcForm,
                "no center that its words can state leaves it where it is wanted everywhere. Post it as two arcs.");
        }

        if (!change.Follows(index))
        {
            return null;
        }

        var ends = Math.Max(change.PlaneMoveOf(index, motion.Plane).Length, change.PlaneMoveOf(index + 1, motion.Plane).Length);
        return arc.FurthestFrom(motion.Arc.Circle) is var moved && moved > ends + allowed
            ? BlockRefusal.At(
                _path.Program, motion.Block, NcRefusalCodes.ElementFlips,
                FormattableString.Invariant($"this arc follows its end, which moves by {ends:0.000} mm; between its ends it would move by ")
                    + FormattableString.Invariant($"{moved:0.000} mm. Name it and the block beside it as well, or post it as two arcs."))
            : null;
    }

    // Origin of the center words: the start, or the origin of the program's coordinates.
    private Point2 CenterOrigin(in NcMotion motion, Point2 start, byte first, byte second)
    {
        var zero = motion.Plane.Project(default(Point3) + _path.Frames[motion.Frame].ProgramShift);
        return new(IsAbsolute(motion, first) ? zero.X : start.X, IsAbsolute(motion, second) ? zero.Y : start.Y);
    }

    private bool IsAbsolute(in NcMotion motion, byte letter) =>
        edit.Distance(letter) switch
        {
            WordDistance.Absolute => true,
            WordDistance.Incremental => false,
            _ => motion.Has(MotionFlags.AbsoluteCenter)
        };

    // An arc that moves as a whole keeps its words, even if its radii already disagreed; absolute center words move along.
    private bool IsShift(int index, in NcMotion motion, Vector2 centerMove) =>
        (change.PlaneMoveOf(index, motion.Plane) - centerMove).Length < 1e-9
            && (change.PlaneMoveOf(index + 1, motion.Plane) - centerMove).Length < 1e-9;

    private Refusal? ShiftCenter(int index, in NcMotion motion)
    {
        if (motion.Has(MotionFlags.CenterBefore))
        {
            var plane = motion.Plane;
            var steps = plane.Project(new(grid.Steps(index, (byte)'X'), grid.Steps(index, (byte)'Y'), grid.Steps(index, (byte)'Z')));
            Poles.Want(index, new(((long)steps.X, (long)steps.Y), null));
        }

        if (motion.Has(MotionFlags.ByRadius) || motion.Has(MotionFlags.CenterBefore))
        {
            return null;
        }

        var (first, second) = CenterLetters(motion.Plane);
        foreach (var letter in (ReadOnlySpan<byte>)[first, second])
        {
            var distance = edit.Computed(letter);
            var isAbsolute = distance is null or WordDistance.Modal ? IsAbsolute(motion, letter) : distance == WordDistance.Absolute;
            if (!isAbsolute || grid.Steps(index, (byte)(letter - 'I' + 'X')) is not (not 0 and var steps))
            {
                continue;
            }

            if (distance is null)
            {
                edit.Set(letter, (edit.Number(letter) ?? new NcNumber(0, 0)) + grid.Number(steps));
            }
            else if (!edit.Add(letter, grid.Number(steps)))
            {
                return Obstacles.Computed(_path, motion);
            }
        }

        return null;
    }

    private void SetCenterWord(byte letter, long? steps)
    {
        if (steps is { } value && (value != 0 || edit.Number(letter) is not null))
        {
            edit.Set(letter, grid.Number(value));
        }
    }

    // A radius keeps its word, or gets a new one, while that leaves the arc where it is wanted. Near half a turn, the arc's height depends
    // on the radius by a square root, so a center is more accurate.
    private Refusal? SetRadius(int index, in NcMotion motion, Point2 start, Point2 end, Arc2 wanted)
    {
        var letter = edit.Number((byte)'R') is null ? NcAddress.CircleRadius : (byte)'R';
        var old = edit.Number(letter)!.Value;
        if (ByRadius(start, end, old.Value * grid.Unit, wanted) is { } kept
            && Math.Abs(wanted.Radius - Math.Abs(old.Value * grid.Unit)) < grid.Increment / 2
            && kept.FurthestFrom(wanted.Circle) < grid.Increment)
        {
            return Stray(index, motion, start, end, kept.Center, wanted);
        }

        var steps = NcNumber.Round(wanted.Radius / grid.Increment, 0).Digits;
        while (2 * steps * grid.Increment < start.DistanceTo(end))
        {
            steps++;
        }

        steps *= Math.Abs(wanted.Sweep.Radians) > Math.PI + 1e-9 ? -1 : 1;
        if (ByRadius(start, end, steps * grid.Increment, wanted) is { } arc && arc.FurthestFrom(wanted.Circle) < grid.Increment)
        {
            edit.Set(letter, grid.Number(steps));
            return Stray(index, motion, start, end, arc.Center, wanted);
        }

        if (_path.Dialect.BlocksNameMotions)
        {
            return BlockRefusal.At(
                _path.Program, motion.Block, NcRefusalCodes.ArcForm,
                "near half a turn, its radius does not say closely enough where it lies. Post it with its center.");
        }

        var (first, second) = CenterLetters(motion.Plane);
        var origin = CenterOrigin(motion, start, first, second);
        var (i, j) = CenterGrid.Choose(origin, start, end, wanted, null, grid.Increment);
        edit.Replace(letter, (first, grid.Number(i!.Value)), (second, grid.Number(j!.Value)));
        return Stray(index, motion, start, end, At(origin, i.Value, j.Value), wanted);
    }

    private static Arc2? ByRadius(Point2 start, Point2 end, double radius, Arc2 wanted) =>
        ArcCenter.ByRadius(start, end, radius, wanted.IsCounterClockwise, 0) is { } center
            ? Arc2.Between(start, end, center, wanted.IsCounterClockwise)
            : null;

    private static (byte First, byte Second) CenterLetters(CoordinatePlane plane) => plane switch
    {
        CoordinatePlane.ZX => ((byte)'K', (byte)'I'),
        CoordinatePlane.YZ => ((byte)'J', (byte)'K'),
        _ => ((byte)'I', (byte)'J'),
    };
}
