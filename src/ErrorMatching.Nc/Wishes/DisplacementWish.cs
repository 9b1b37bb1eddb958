using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Names what to displace and by how much: the only input that the rewriter and the proof share.</summary>
public sealed class DisplacementWish
{
    private readonly Vector3[]? _byEach;

    private DisplacementWish(IReadOnlyList<ElementWish> elements, IReadOnlyList<int> endPoints, Vector3 by, Vector3[]? byEach = null)
    {
        Elements = elements;
        EndPoints = endPoints;
        By = by;
        _byEach = byEach;
    }

    /// <summary>Displaced elements, in path order; empty if end points move.</summary>
    public IReadOnlyList<ElementWish> Elements { get; }

    /// <summary>Motions whose end points move, in path order; empty if elements are displaced.</summary>
    public IReadOnlyList<int> EndPoints { get; }

    /// <summary>The vector by which the end points move, mm; zero if each has its own.</summary>
    public Vector3 By { get; }

    /// <summary>True if each end point has its own vector. Then no other end moves: no retract moves along, and no arc follows.</summary>
    public bool IsPointByPoint => _byEach is not null;

    /// <summary>The vector by which one of the end points moves, mm.</summary>
    /// <param name="index">Its position in <see cref="EndPoints"/>.</param>
    public Vector3 ByOf(int index) => _byEach is null ? By : _byEach[index];

    /// <summary>Creates a wish for elements: lines stay lines, arcs stay arcs, corners stay corners.</summary>
    /// <param name="elements">One wish per motion, in any order.</param>
    /// <exception cref="ArgumentException">Two wishes name the same motion.</exception>
    public static DisplacementWish OfElements(IReadOnlyList<ElementWish> elements)
    {
        ElementWish[] sorted = [.. elements];
        Array.Sort(sorted, (a, b) => a.Motion.CompareTo(b.Motion));
        return IsAscending(sorted)
            ? new(sorted, [], Vector3.Zero)
            : throw new ArgumentException("A motion has two wishes.", nameof(elements));
    }

    /// <summary>Creates a wish for end points: the ends of the named motions move by one vector.</summary>
    /// <param name="motions">The motions, in any order.</param>
    /// <param name="by">The vector, mm.</param>
    public static DisplacementWish OfEndPoints(IReadOnlyList<int> motions, Vector3 by) =>
        new([], InOrder(motions) ? [.. motions] : [.. motions.Distinct().Order()], by);

    /// <summary>Creates a wish for end points, each with its own vector: a path that follows a surface.</summary>
    /// <param name="points">One wish per motion, in any order.</param>
    /// <exception cref="ArgumentException">Two wishes name the same motion.</exception>
    public static DisplacementWish OfPoints(IReadOnlyList<PointWish> points)
    {
        PointWish[] sorted = [.. points];
        Array.Sort(sorted, (a, b) => a.Motion.CompareTo(b.Motion));
        for (var i = 1; i < sorted.Length; i++)
        {
            if (sorted[i - 1].Motion == sorted[i].Motion)
            {
                throw new ArgumentException("A motion has two wishes.", nameof(points));
            }
        }

        return new([], Array.ConvertAll(sorted, p => p.Motion), Vector3.Zero, Array.ConvertAll(sorted, p => p.By));
    }

    /// <summary>True if nothing moves.</summary>
    internal bool IsZero =>
        By == Vector3.Zero
            && (_byEach is null || _byEach.AsSpan().IndexOfAnyExcept(Vector3.Zero) < 0)
            && Elements.All(e => e.Start == Vector2.Zero && e.Middle == Vector2.Zero && e.End == Vector2.Zero);

    /// <summary>Creates a wish to displace all cutting motions of some blocks by one distance to the left of travel (negative:
    /// right). Vertical arcs among them are leads, and follow.</summary>
    /// <returns>The wish, or a refusal if the blocks have no cutting motion or have one that begins at an unknown place.</returns>
    public static Outcome<DisplacementWish> Normal(NcPath path, IReadOnlyList<int> blocks, double left)
    {
        var distinct = InOrder(blocks) ? blocks : [.. blocks.Distinct()];
        var (first, second) = distinct.Count < TwoThreads.Many
            ? (WishesOf(path, distinct, 0, distinct.Count, left), ([], null))
            : TwoThreads.Run(0, distinct.Count, (from, end) => WishesOf(path, distinct, from, end, left));
        if ((first.Refusal ?? second.Refusal) is { } refusal)
        {
            return refusal;
        }

        var elements = first.Elements;
        elements.AddRange(second.Elements);
        return elements.Count == 0
            ? NoMotion(path, blocks)
            : IsAscending(elements)
            ? new DisplacementWish(elements, [], Vector3.Zero)
            : OfElements(elements);
    }

    // The wishes for some of the blocks; the list has capacity for the blocks after them too.
    private static (List<ElementWish> Elements, Refusal? Refusal) WishesOf(
        NcPath path, IReadOnlyList<int> blocks, int from, int end, double left)
    {
        var elements = new List<ElementWish>(blocks.Count - from);
        var recent = 0;
        for (var i = from; i < end; i++)
        {
            for (var run = 0; path.RunOf(blocks[i], run, ref recent) is >= 0 and var motion; run++)
            {
                var m = path.Motions[motion];
                if (!m.IsCut || m.IsVertical || !MayMoveInPlane(path, motion, m))
                {
                    continue;
                }

                if (!m.IsKnownInPlane)
                {
                    return (elements, Obstacles.Of(path, motion) ?? Obstacles.UnknownPlace(path, motion));
                }

                elements.Add(ElementWish.AlongNormals(m, motion, left, left, left));
            }
        }

        return (elements, null);
    }

    // The coordinates do not show whether a motion between unknown places moves; its words do.
    private static bool MayMoveInPlane(NcPath path, int motion, in NcMotion m) => m.MovesInPlane
        || (!m.IsKnownInPlane && (m.Has(MotionFlags.Expression | MotionFlags.UnknownWord)
            || (motion > 0 && m.Plane.Project(path.Motions.AssumedEnd(motion)) != m.Plane.Project(path.Motions.AssumedEnd(motion - 1)))));

    /// <summary>Creates a wish to move the end points of all motions of some blocks by one vector.</summary>
    /// <returns>The wish, or a refusal if the blocks have no motion.</returns>
    public static Outcome<DisplacementWish> EndsBy(NcPath path, IReadOnlyList<int> blocks, Vector3 by)
    {
        var motions = new List<int>(blocks.Count);
        foreach (var block in blocks)
        {
            for (var run = 0; path.RunOf(block, run) is >= 0 and var motion; run++)
            {
                motions.Add(motion);
            }
        }

        return motions.Count > 0 ? OfEndPoints(motions, by) : NoMotion(path, blocks);
    }

    private static bool InOrder(IReadOnlyList<int> positions)
    {
        for (var i = 1; i < positions.Count; i++)
        {
            if (positions[i - 1] >= positions[i])
            {
                return false;
            }
        }

        return true;
    }

    private static bool IsAscending(IReadOnlyList<ElementWish> elements)
    {
        for (var i = 1; i < elements.Count; i++)
        {
            if (elements[i - 1].Motion >= elements[i].Motion)
            {
                return false;
            }
        }

        return true;
    }

    private static Refusal NoMotion(NcPath path, IReadOnlyList<int> blocks) => path.Refusal is { } stopped ? stopped : blocks.Count > 0
        ? BlockRefusal.At(
            path.Program,
            blocks[0],
            NcRefusalCodes.NoMotion,
            blocks.Any(b => path.MotionOf(b) is >= 0 and var motion && path.Motions.IsVertical(motion))
                ? "the named blocks hold no motion that could be displaced: "
                    + "an upright arc (G18, G19) leads to a contour and follows it. Name "
                    + "the blocks that cut the boundary."
                : "the named blocks hold no motion that could be displaced. Name the blocks that cut the boundary.")
        : new(NcRefusalCodes.NoMotion, "No blocks are named.");
}

/// <summary>Wish for the end of one motion.</summary>
/// <param name="Motion">Position of the motion in the path.</param>
/// <param name="By">The displacement of its end, mm.</param>
public readonly record struct PointWish(int Motion, Vector3 By);

/// <summary>Wish for one cutting motion: the displacement of its carrying line or circle in its plane, at its start, middle and
/// end.</summary>
/// <param name="Motion">Position of the motion in the path.</param>
/// <param name="Start">Displacement at its start, mm.</param>
/// <param name="Middle">Displacement halfway, mm. Ignored for lines, whose middle follows from the ends.</param>
/// <param name="End">Displacement at its end, mm.</param>
/// <param name="IsFillet">True for an arc that joins two displaced lines and must stay tangent to both: its radius changes by the mean of
/// the two ends.</param>
public readonly record struct ElementWish(int Motion, Vector2 Start, Vector2 Middle, Vector2 End, bool IsFillet = false)
{
    /// <summary>Creates a wish to displace a motion along its own normals by signed amounts, mm, positive to the left of travel.</summary>
    /// <exception cref="GeometryException">The motion does not move in its plane.</exception>
    public static ElementWish AlongNormals(NcPath path, int motion, double start, double middle, double end, bool isFillet = false)
    {
        var m = path.Motions[motion];
        return AlongNormals(m, motion, start, middle, end, isFillet);
    }

    /// <summary>Creates the same wish for a motion that the caller has already read.</summary>
    internal static ElementWish AlongNormals(in NcMotion m, int motion, double start, double middle, double end, bool isFillet = false)
    {
        if (m.IsArc)
        {
            return new(motion, m.TangentAt(0).Left * start, m.TangentAt(0.5).Left * middle, m.TangentAt(1).Left * end, isFillet);
        }

        var normal = m.TangentAt(0).Left;
        return new(motion, normal * start, normal * middle, normal * end, isFillet);
    }
}
