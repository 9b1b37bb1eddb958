using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Builds arcs from the words of a block: center words, a radius, an opening angle, an intermediate point, or the direction of
/// the previous motion.</summary>
internal sealed class Arcs(NcControl control, Corners corners, StatedPole pole)
{
    private const double Kilometer = 1e6;

    private readonly record struct FoundArc(MotionKind Kind, Point2 Center, MotionFlags Flags, Point2? End = null);

    public void Turn(MotionKind kind, MotionFlags flags, Point3 end, AxisSet unknownEnd)
    {
        var plane = control.State.Plane;
        var (start, to) = (plane.Project(control.State.Position), plane.Project(end));
        var isKnown = ((control.State.Unknown | unknownEnd) & plane.Axes()) == AxisSet.None;
        var arc = FindArc(kind, start, to, plane.Height(end), isKnown);
        if (arc.End is { } found)
        {
            end = plane.Lift(found, plane.Height(end));
        }

        flags |= arc.Flags | control.TakeSwitch(movesInPlane: true);
        var (center, turned) = (arc.Center, arc.Kind);
        if (control.Layers.Transforms.Frame is not null)
        {
            var (stays, turnsOver) = control.Layers.Transforms.Frame.OnCircles(plane);
            flags |= stays ? MotionFlags.None : BadArc("the frame that is active makes it an ellipse or tilts it out of its plane");
            center = plane.Project(control.Layers.Transforms.Frame.Apply(plane.Lift(center, plane.Height(end))));
            turned = turnsOver ? Opposite(turned) : turned;
        }

        corners.Cut(turned, flags, end, unknownEnd, center);
        if (isKnown && start.DistanceTo(arc.Center) >= Kilometer)
        {
            control.Result.Note("huge-arc",
                "The radius of an arc is a kilometer or more: it is nearly a line, and a wrong word looks like this. "
                + "Controls have a limit for radii, and this one's is not known here.");
        }

        control.Moves.Append(turned, flags, end, unknownEnd, center, Turns());
    }

    private static MotionKind Opposite(MotionKind kind) =>
        kind == MotionKind.ArcClockwise ? MotionKind.ArcCounterClockwise : MotionKind.ArcClockwise;

    private int Turns() =>
        control.Words.Has(NcAddress.Turn) ? (int)Math.Clamp(control.Words.Value(NcAddress.Turn), 0, 100_000)
        : pole.Turns() is > 0 and var turns ? turns
        : control.Dialect.TurnsLetter != 0 && control.Words.Has(control.Dialect.TurnsLetter)
            ? (int)Math.Clamp(control.Words.Value(control.Dialect.TurnsLetter) - 1, 0, 100_000)
        : 0;

    private FoundArc FindArc(MotionKind kind, Point2 start, Point2 end, double endHeight, bool isKnown)
    {
        if ((control.Words.Unknown & BlockWords.GeometryWords & ~BlockWords.LinearAxes) != 0)
        {
            return new(kind, start.Lerp(end, 0.5), MotionFlags.BadArc);
        }

        if (control.State.Form == NcMeaning.ArcAboutPole)
        {
            return AboutPole(kind, start, end, isKnown);
        }

        if (control.State.Form == NcMeaning.ArcThrough)
        {
            return Through(start, end, endHeight, isKnown);
        }

        if (control.State.Form == NcMeaning.TangentArc)
        {
            return Tangent(start, end, isKnown);
        }

        if (control.Words.Has('R') && control.Dialect.RoleOf((byte)'R') == LetterRole.Radius)
        {
            return ByRadius(kind, start, end, control.Values.Length('R'), isKnown);
        }

        if (control.Words.Has(NcAddress.CircleRadius))
        {
            return ByRadius(kind, start, end, control.Values.Length(NcAddress.CircleRadius), isKnown);
        }

        var (first, second) = control.State.Plane switch
        {
            CoordinatePlane.ZX => ('K', 'I'),
            CoordinatePlane.YZ => ('J', 'K'),
            _ => ('I', 'J')
        };
        var hasCenter = control.Words.Has(first) || control.Words.Has(second);
        if (control.Words.Has(NcAddress.OpeningAngle))
        {
            return ByAngle(
                kind, start, end, control.Words.Value(NcAddress.OpeningAngle), hasCenter ? Center(start, first, second) : null, isKnown);
        }

        if (!hasCenter)
        {
            return new(kind, start.Lerp(end, 0.5), BadArc($"the arc has neither a radius nor {first} and {second}"));
        }

        var center = Center(start, first, second);
        return new(kind, center, Mismatch(start, end, center, isKnown));
    }

    private MotionFlags Mismatch(Point2 start, Point2 end, Point2 center, bool isKnown)
    {
        var radius = start.DistanceTo(center);
        var tolerance = Math.Max(control.Dialect.ArcMismatchMm, control.Dialect.ArcMismatchOfRadius * radius);
        var mismatch = ArcCenter.Mismatch(start, end, center);
        return isKnown && !(mismatch <= tolerance && radius > 0)
            ? BadArc(FormattableString.Invariant($"the radii at start and end differ by {mismatch:0.####} mm"))
            : MotionFlags.None;
    }

    private FoundArc AboutPole(MotionKind kind, Point2 start, Point2 end, bool isKnown)
    {
        if (!pole.IsKnown)
        {
            return new(kind, start.Lerp(end, 0.5), MotionFlags.CenterBefore | BadArc("its center is not known"));
        }

        var center = control.State.Pole.Place;
        return new(kind, center, MotionFlags.CenterBefore | Mismatch(start, end, center, isKnown));
    }

    public Point2 Center(Point2 start, char first, char second) => new(CenterWord(start.X, first), CenterWord(start.Y, second));

    // A missing center word means the start's own coordinate, or zero if centers are positions.
    private double CenterWord(double start, char letter)
    {
        var bit = BlockWords.Bit(letter);
        var absolute = (control.State.AbsoluteCenters && (control.Words.Incremental & bit) == 0) || (control.Words.Absolute & bit) != 0;
        return (absolute ? 0 : start) + (control.Words.Has(letter) ? control.Values.Length(letter) : 0);
    }

    private FoundArc ByRadius(MotionKind kind, Point2 start, Point2 end, double radius, bool isKnown) =>
        ArcCenter.ByRadius(start, end, radius, kind == MotionKind.ArcCounterClockwise, control.Dialect.ArcMismatchMm) is { } center
            ? new(kind, center, MotionFlags.ByRadius)
            : new(
                kind,
                start.Lerp(end, 0.5),
                MotionFlags.ByRadius | (isKnown ? BadArc("no circle of this radius reaches from the start to the end") : MotionFlags.None));

    // An opening angle with a center gives the end; with an end, it gives the center.
    private FoundArc ByAngle(MotionKind kind, Point2 start, Point2 end, double degrees, Point2? center, bool isKnown)
    {
        var counterClockwise = kind == MotionKind.ArcCounterClockwise;
        if (!(degrees is > 0 and < 360))
        {
            return new(
                kind, start.Lerp(end, 0.5), isKnown ? BadArc("the opening angle must lie between 0 and 360 degrees") : MotionFlags.BadArc);
        }

        if (center is { } c)
        {
            var from = start - c;
            var (sin, cos) = Elementary.SinCos((counterClockwise ? degrees : -degrees) * Math.PI / 180);
            return new(
                kind, c, MotionFlags.OtherArcForm, c + new Vector2((from.X * cos) - (from.Y * sin), (from.X * sin) + (from.Y * cos)));
        }

        var chord = end - start;
        var height = chord.Length / 2 / Elementary.Tan(degrees * Math.PI / 360);
        return chord.Length > 0
            ? new(
                kind, start.Lerp(end, 0.5) + (chord.Left / chord.Length * (counterClockwise ? height : -height)), MotionFlags.OtherArcForm)
            : new(kind, start, isKnown ? BadArc("start and end are one place") : MotionFlags.BadArc);
    }

    private FoundArc Through(Point2 start, Point2 end, double endHeight, bool isKnown)
    {
        var at = control.State.Position;
        var way = new Point3(Way(NcAddress.ThroughX, at.X), Way(NcAddress.ThroughY, at.Y), Way(NcAddress.ThroughZ, at.Z));
        var (through, height) = (control.State.Plane.Project(way), control.State.Plane.Height(at));
        var side = (through - start).Cross(end - through);
        var kind = side < 0 ? MotionKind.ArcClockwise : MotionKind.ArcCounterClockwise;
        if (control.State.Plane.Height(way) != height || endHeight != height)
        {
            return new(
                kind,
                start.Lerp(end, 0.5),
                isKnown ? BadArc("its three points lie at different heights; an arc in space is not followed") : MotionFlags.BadArc);
        }

        try
        {
            return new(kind, Circle2.Through(start, through, end).Center, MotionFlags.OtherArcForm);
        }
        catch (GeometryException)
        {
            return new(
                kind, start.Lerp(end, 0.5), isKnown ? BadArc("start, intermediate point and end lie on one line") : MotionFlags.BadArc);
        }
    }

    public double Way(byte letter, double at)
    {
        var bit = BlockWords.Bit(letter);
        var incremental = (control.State.Incremental && (control.Words.Absolute & bit) == 0) || (control.Words.Incremental & bit) != 0;
        return control.Words.Has(letter) ? (incremental ? at : 0) + control.Values.Length(letter) : at;
    }

    private FoundArc Tangent(Point2 start, Point2 end, bool isKnown)
    {
        var motions = control.Result.Motions;
        if (motions.Length > 0
            && InPlane(motions[motions.Length - 1]) is { IsCut: true, IsKnownInPlane: true, MovesInPlane: true } before
            && before.Plane == control.State.Plane
            && (control.Layers.Transforms.Frame?.OnCircles(control.State.Plane).StayCircles ?? true))
        {
            var plane = control.State.Plane;
            var direction = plane.Lift(Point2.Origin + before.TangentAt(1), 0) - default(Point3);
            var programmed = control.Layers.Transforms.Inverse?.Turn(direction) ?? direction;
            var tangent = (plane.Project(default(Point3) + programmed) - Point2.Origin).Normalize();
            var chord = end - start;
            var side = tangent.Cross(chord);
            if (Math.Abs(side) > 1e-9 * chord.Length)
            {
                var radius = chord.Dot(chord) / (2 * side);
                return new(
                    side > 0 ? MotionKind.ArcCounterClockwise : MotionKind.ArcClockwise,
                    start + (tangent.Left * radius),
                    MotionFlags.OtherArcForm);
            }
        }

        return new(
            MotionKind.ArcClockwise,
            start.Lerp(end, 0.5),
            isKnown ? BadArc("no motion before it gives a direction to continue, or its end lies straight ahead") : MotionFlags.BadArc);
    }

    // A line has a direction in each plane.
    private NcMotion InPlane(in NcMotion motion) => motion.IsArc ? motion : motion with { Plane = control.State.Plane };

    private MotionFlags BadArc(string why) => control.Result.Problem("bad-arc", $"Not an arc: {why}.", MotionFlags.BadArc);
}
