using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>
/// Displaces elements: every named line or arc becomes its displaced line or arc, and the joints become their intersections. What happens at the
/// ends of a run of named motions is in <c>ElementDisplacer.Borders</c>.
/// </summary>
internal sealed partial class ElementDisplacer
{
    /// <summary>Sine of the angle below which two elements are taken to run into each other tangentially: 5.7 degrees.</summary>
    private const double TangentSine = 0.1;

    /// <summary>How different the displacements of two elements may be where they meet tangentially, mm: less than half a least increment.</summary>
    private const double TangentStep = 0.0004;

    /// <summary>An intersection further from the joint than this multiple of the displacement is not nearby.</summary>
    private const double Nearby = 12;

    private readonly NcPath path;
    private readonly PathChange change;
    private readonly Dictionary<int, ElementWish> wishes = [];
    private readonly Dictionary<int, Carrier> carriers = [];

    private ElementDisplacer(NcPath path)
    {
        this.path = path;
        change = new(path);
    }

    /// <summary>Computes the new joints and centers for a wish.</summary>
    public static NcOutcome<PathChange> Run(NcPath path, DisplacementWish wish)
    {
        var displacer = new ElementDisplacer(path);
        return displacer.Displace(wish.Elements) is { } refusal ? refusal : displacer.change;
    }

    private NcRefusal? Displace(IReadOnlyList<ElementWish> elements)
    {
        foreach (var element in WithNeighborFillets(elements))
        {
            if (Add(element) is { } refusal)
            {
                return refusal;
            }
        }

        foreach (var element in wishes.Values.Where(w => w.IsFillet).OrderBy(w => w.Motion))
        {
            if (Round(element) is { } refusal)
            {
                return refusal;
            }
        }

        foreach (var (first, last) in Runs())
        {
            if (Joints(first, last) is { } refusal)
            {
                return refusal;
            }
        }

        SetCenters();
        return FollowWithArcs() ?? CheckSense();
    }

    private NcRefusal? Add(ElementWish element)
    {
        var motion = path.Motions[element.Motion];
        if (Obstacles.Of(path, element.Motion) is { } obstacle)
        {
            return obstacle;
        }

        if (!motion.IsKnownInPlane)
        {
            return Obstacles.UnknownPlace(path, element.Motion);
        }

        if (Carrier.Displaced(motion, element) is not { } carrier)
        {
            return At(motion, NcRefusalCodes.ElementFlips, "displaced as asked, this element would vanish or turn round. The displacement is larger than the element can take.");
        }

        // Both ends of a full circle are one place, to the last bit.
        var isClosed = motion.PlaneStart.DistanceTo(motion.PlaneEnd) < 1e-9 && (element.End - element.Start).Length < 1e-9;
        wishes.Add(element.Motion, isClosed ? element with { End = element.Start } : element);
        carriers.Add(element.Motion, carrier);
        return null;
    }

    // A fillet that the wish leaves out although both its flanks are displaced must stay tangent to both, or the tool would leave a mark.
    private IEnumerable<ElementWish> WithNeighborFillets(IReadOnlyList<ElementWish> elements)
    {
        for (var i = 0; i < elements.Count; i++)
        {
            yield return elements[i];
            var motion = elements[i].Motion + 1;
            if (i + 1 < elements.Count && elements[i + 1].Motion == motion + 1 && IsTangentFillet(motion))
            {
                var (before, behind) = (elements[i].End, elements[i + 1].Start);
                yield return new(motion, before, (before + behind) / 2, behind, IsFillet: true);
            }
        }
    }

    private bool IsTangentFillet(int motion)
    {
        var motions = path.Motions;
        return motions[motion].IsArc && motions[motion - 1].Kind == MotionKind.Line && motions[motion + 1].Kind == MotionKind.Line
            && IsTangent(motions[motion - 1].TangentAt(1), motions[motion].TangentAt(0))
            && IsTangent(motions[motion].TangentAt(1), motions[motion + 1].TangentAt(0));
    }

    private static bool IsTangent(Vector2 before, Vector2 behind) => Math.Abs(before.Cross(behind)) < TangentSine && before.Dot(behind) > 0;

    // Both flanks offset by the new radius meet in the new center; its feet on them are the new tangent points (method of the fillet in a wedge).
    private NcRefusal? Round(ElementWish element)
    {
        var motion = path.Motions[element.Motion];
        if (!carriers.TryGetValue(element.Motion - 1, out var before) || !carriers.TryGetValue(element.Motion + 1, out var behind)
            || before.Line is not { } first || behind.Line is not { } second || !IsTangentFillet(element.Motion))
        {
            return null;
        }

        var arc = motion.Arc;
        var left = (wishes[element.Motion - 1].End.Dot(first.Normal) + wishes[element.Motion + 1].Start.Dot(second.Normal)) / 2;
        var towardCenter = arc.IsCounterClockwise ? 1 : -1;
        var radius = arc.Radius - (towardCenter * left);
        var center = radius > 0 ? Intersect.Lines(first.Offset(towardCenter * radius), second.Offset(towardCenter * radius)).Nearest(arc.Center) : null;
        if (center is not { } c)
        {
            return At(motion, NcRefusalCodes.ElementFlips, "the fillet is smaller than the displacement of its flanks.");
        }

        change.SetCenter(element.Motion, c);
        carriers[element.Motion] = new(null, new(c, radius));
        change.Move(element.Motion, motion.Plane, first.Foot(c) - motion.PlaneStart);
        change.Move(element.Motion + 1, motion.Plane, second.Foot(c) - motion.PlaneEnd);
        return null;
    }

    private IEnumerable<(int First, int Last)> Runs()
    {
        int? first = null;
        var last = 0;
        foreach (var motion in wishes.Keys.Order())
        {
            if (first is { } from && motion != last + 1)
            {
                yield return (from, last);
                first = motion;
            }

            first ??= motion;
            last = motion;
        }

        if (first is { } begin)
        {
            yield return (begin, last);
        }
    }

    private NcRefusal? Joints(int first, int last)
    {
        for (var joint = first + 1; joint <= last; joint++)
        {
            var motion = path.Motions[joint];
            if (motion.Plane != path.Motions[first].Plane)
            {
                return At(motion, NcRefusalCodes.PlaneChange, "the plane changes inside the named blocks. Name the blocks of each plane as a feature of its own.");
            }

            if (motion.Frame != path.Motions[first].Frame)
            {
                return At(motion, NcRefusalCodes.FrameChange, "the work offset or origin changes inside the named blocks.");
            }

            if (!change.IsSet(joint))
            {
                var (move, refusal) = Vertex(joint - 1, joint);
                if (refusal is not null)
                {
                    return refusal;
                }

                change.Move(joint, motion.Plane, move);
            }
        }

        return Borders(first, last);
    }

    /// <summary>Where the joint between two displaced elements goes, as a displacement of the end of the first.</summary>
    private (Vector2 Move, NcRefusal? Refusal) Vertex(int before, int behind)
    {
        var (a, b) = (path.Motions[before], path.Motions[behind]);
        var (moveA, moveB) = (wishes[before].End, wishes[behind].Start);
        if ((moveA - moveB).Length <= 1e-9)
        {
            return (moveA, null);
        }

        var (tangentA, tangentB) = (a.TangentAt(1), b.TangentAt(0));
        var (left, right) = (moveA.Dot(tangentA.Left), moveB.Dot(tangentB.Left));
        if (IsTangent(tangentA, tangentB))
        {
            if (Math.Abs(left - right) > TangentStep)
            {
                return (default, At(b, NcRefusalCodes.NoIntersection, FormattableString.Invariant($"it runs on tangentially from {path.Program.NameOf(path.Program[a.Block])}, but the two are displaced by different amounts ({left:0.000} and {right:0.000} mm) and would no longer meet. Put both into one feature.")));
            }

            var normals = tangentA.Left + tangentB.Left;
            return (normals * ((left + right) / 2 / (1 + tangentA.Dot(tangentB))), null);
        }

        var joint = a.PlaneEnd;
        var guess = joint + Corner(tangentA.Left, left, tangentB.Left, right);
        var meeting = carriers[before].Meet(carriers[behind], guess);
        return meeting is { } point && IsNear(point, joint, guess, Math.Max(Math.Abs(left), Math.Abs(right)))
            ? (point - joint, null)
            : (default, At(b, NcRefusalCodes.NoIntersection, $"displaced as asked, it no longer meets {path.Program.NameOf(path.Program[a.Block])}."));
    }

    // The displacement with given components along two normals.
    private static Vector2 Corner(Vector2 normalA, double a, Vector2 normalB, double b) =>
        ((normalB.Left * -a) + (normalA.Left * b)) / normalA.Cross(normalB);

    private static bool IsNear(Point2 point, Point2 joint, Point2 guess, double amount) =>
        point.DistanceTo(joint) <= (Nearby * amount) + 1e-6 && point.DistanceTo(guess) <= (Nearby * amount) + 1e-6;

    private void SetCenters()
    {
        foreach (var (motion, carrier) in carriers)
        {
            if (carrier.Circle is { } circle)
            {
                change.SetCenter(motion, circle.Center);
            }
        }
    }

    // Arcs that were not named and whose ends left their circle: a lead-in that is an arc, or an arc beside a run that it does not meet.
    private NcRefusal? FollowWithArcs()
    {
        var motions = path.Motions;
        for (var i = 0; i < motions.Length; i++)
        {
            if (motions[i].IsArc && !carriers.ContainsKey(i) && (change.IsSet(i) || change.IsSet(i + 1)) && !SlidesOnCircle(i) && change.FollowWithArc(i) is { } refusal)
            {
                return refusal;
            }
        }

        return null;
    }

    private bool SlidesOnCircle(int motion)
    {
        var arc = path.Motions[motion];
        var circle = arc.Arc.Circle;
        return IsAlong(arc.PlaneStart, change.PlaneMoveOf(motion, arc.Plane)) && IsAlong(arc.PlaneEnd, change.PlaneMoveOf(motion + 1, arc.Plane));

        // An end whose radius differs from the start's, as far as a control accepts that, is on the circle all the same.
        bool IsAlong(Point2 end, Vector2 move) => Math.Abs(circle.SignedDistance(end + move)) <= Math.Abs(circle.SignedDistance(end)) + 1e-6;
    }

    // No element may turn round: that is a loop in the path, and a mark on the piece.
    private NcRefusal? CheckSense()
    {
        var motions = path.Motions;
        for (var i = 0; i < motions.Length; i++)
        {
            if (motions[i] is not { IsCut: true, MovesInPlane: true } motion || !(change.IsSet(i) || change.IsSet(i + 1)))
            {
                continue;
            }

            if (!change.KeepsSense(i))
            {
                return At(motion, NcRefusalCodes.ElementFlips, "displaced as asked, this element would turn round: it is shorter than its neighbors' displacement needs. Leave it out of the program, or displace less.");
            }
        }

        return null;
    }

    private NcRefusal At(in NcMotion motion, string code, string message) => NcRefusal.At(path.Program, motion.Block, code, message);
}
