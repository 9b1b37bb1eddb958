using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>
/// Compares what two programs do, motion by motion. Programs with as many motions are aligned by their order. Otherwise equal motions are aligned first (the longest common
/// subsequence of kind, end and center), between them those of the same kind and block number; the rest was inserted or removed.
/// </summary>
/// <param name="Before">The first program, interpreted.</param>
/// <param name="After">The second program, interpreted.</param>
/// <param name="Differences">The motions that differ, in the order of the programs.</param>
public sealed record MotionComparison(NcPath Before, NcPath After, IReadOnlyList<MotionDifference> Differences)
{
    // Far below any increment: what is left of the same decimals after sums of increments.
    private const double Same = 1e-9;

    /// <summary>Compares two programs.</summary>
    public static MotionComparison Of(NcPath before, NcPath after)
    {
        var differences = new List<MotionDifference>();
        var (m, n) = (before.Motions.Length, after.Motions.Length);
        if (m == n)
        {
            for (var i = 0; i < m; i++)
            {
                Compare(before, after, i, i, differences);
            }
        }
        else
        {
            Walk(before, after, differences);
        }

        return new(before, after, differences);
    }

    private static void Walk(NcPath before, NcPath after, List<MotionDifference> differences)
    {
        var (m, n) = (before.Motions.Length, after.Motions.Length);
        var (namesBefore, namesAfter) = (Keys(before, Name), Keys(after, Name));
        var (b, a) = (0, 0);
        foreach (var (nextBefore, nextAfter) in CommonSubsequence.Of(Keys(before, Place), Keys(after, Place)).Append((m, n)))
        {
            var alike = CommonSubsequence.Of(namesBefore.AsSpan(b..nextBefore), namesAfter.AsSpan(a..nextAfter));
            foreach (var (i, j) in alike.ConvertAll(p => (p.First + b, p.Second + a)).Append((nextBefore, nextAfter)))
            {
                for (; b < i; b++)
                {
                    differences.Add(new(MotionChange.Removed, b, -1, Vector3.Zero, Vector2.Zero));
                }

                for (; a < j; a++)
                {
                    differences.Add(new(MotionChange.Inserted, -1, a, Vector3.Zero, Vector2.Zero));
                }

                if (i < m && j < n)
                {
                    Compare(before, after, i, j, differences);
                    (b, a) = (i + 1, j + 1);
                }
            }
        }
    }

    private static void Compare(NcPath before, NcPath after, int i, int j, List<MotionDifference> differences)
    {
        var (was, now) = (before.Motions[i], after.Motions[j]);
        var center = was.IsArc && now.IsArc ? now.Center - was.Center : Vector2.Zero;
        MotionChange? change = was.Kind != now.Kind || was.Plane != now.Plane ? MotionChange.Replaced
            : (now.End - was.End).Length > Same || center.Length > Same || was.Turns != now.Turns || was.UnknownEnd != now.UnknownEnd ? MotionChange.Moved
            : Math.Abs(was.Feed - now.Feed) > Same ? MotionChange.Feed
            : null;
        if (change is { } found)
        {
            differences.Add(new(found, i, j, now.End - was.End, center));
        }
    }

    private static object[] Keys(NcPath path, Func<NcPath, NcMotion, object> key)
    {
        var keys = new object[path.Motions.Length];
        for (var i = 0; i < keys.Length; i++)
        {
            keys[i] = key(path, path.Motions[i]);
        }

        return keys;
    }

    // Grid steps, so that equal places are equal keys.
    private static object Place(NcPath path, NcMotion m) => (m.Kind, m.Plane, Step(m.End.X), Step(m.End.Y), Step(m.End.Z), m.IsArc ? (Step(m.Center.X), Step(m.Center.Y)) : default);

    // Motions of blocks without a number have nothing in common but their kind, which is no reason to take them for one another.
    private static object Name(NcPath path, NcMotion m) => path.Program.NumberOf(path.Program[m.Block]) is { Length: > 0 } number ? (m.Kind, number) : new object();

    private static double Step(double millimeters) => Math.Round(millimeters * 1e7);
}
