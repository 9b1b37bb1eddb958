namespace ErrorMatching.Nc;

/// <summary>Pairs the motions of two stretches that have none in common: in order, with the least sum of the distances between their
/// ends. An equal block number favors a pair.</summary>
/// <remarks>
/// A table along the diagonal, as wide as the difference of the lengths plus <see cref="Slack"/> on both sides. If it would have more
/// than <see cref="MostCells"/> cells, motions with the same kind and block number are paired.
/// </remarks>
internal sealed class NearestMotions(NcPath before, NcPath after)
{
    private const int Slack = 24;
    private const long MostCells = 8_000_000;
    private const float Alone = 1;
    private const float SameNumber = 0.2f;
    private const float Never = float.MaxValue / 4;

    private enum Step : byte
    {
        Pair,
        Remove,
        Insert,
    }

    /// <summary>Pairs of positions, ascending in both.</summary>
    public List<(int Before, int After)> Pair(Range ofBefore, Range ofAfter)
    {
        var (b, n) = ofBefore.GetOffsetAndLength(before.Motions.Length);
        var (a, m) = ofAfter.GetOffsetAndLength(after.Motions.Length);
        if (n == 0 || m == 0)
        {
            return [];
        }

        return (n + 1L) * (Math.Abs(n - m) + (2 * Slack) + 1) <= MostCells ? ByDistance(b, n, a, m) : ByNumber(b, n, a, m);
    }

    private List<(int, int)> ByDistance(int b, int n, int a, int m)
    {
        var (low, width) = (Math.Min(0, m - n) - Slack, Math.Abs(m - n) + (2 * Slack) + 1);
        var steps = new Step[(n + 1) * width];
        var (row, previous) = (new float[width], new float[width]);
        for (var i = 0; i <= n; i++)
        {
            for (var c = 0; c < width; c++)
            {
                var j = i + low + c;
                row[c] = Never;
                if (j < 0 || j > m)
                {
                    continue;
                }

                var step = Step.Pair;
                row[c] = i == 0 && j == 0 ? 0 : Never;
                if (i > 0 && j > 0)
                {
                    row[c] = previous[c] + Cost(b + i - 1, a + j - 1);
                }

                if (i > 0 && c + 1 < width && previous[c + 1] + Alone < row[c])
                {
                    (row[c], step) = (previous[c + 1] + Alone, Step.Remove);
                }

                if (j > 0 && c > 0 && row[c - 1] + Alone < row[c])
                {
                    (row[c], step) = (row[c - 1] + Alone, Step.Insert);
                }

                steps[(i * width) + c] = step;
            }

            (row, previous) = (previous, row);
        }

        return Back(steps, low, width, b, n, a, m);
    }

    private static List<(int, int)> Back(Step[] steps, int low, int width, int b, int n, int a, int m)
    {
        var pairs = new List<(int, int)>();
        var (i, j) = (n, m);
        while (i > 0 || j > 0)
        {
            switch (steps[(i * width) + j - i - low])
            {
                case Step.Pair:
                    pairs.Add((b + --i, a + --j));
                    break;
                case Step.Remove:
                    i--;
                    break;
                default:
                    j--;
                    break;
            }
        }

        pairs.Reverse();
        return pairs;
    }

    // From 0 for equal motions to just below the cost of a removal and an insertion, so that motions of one kind count as moved, not
    // replaced.
    private float Cost(int i, int j)
    {
        var (was, now) = (before.Motions[i], after.Motions[j]);
        var distance = (now.End - was.End).Length;
        distance = was.IsArc && now.IsArc ? Math.Max(distance, now.Center.DistanceTo(was.Center)) : distance;
        var cost = (float)(1.99 * distance / (distance + 1)) + (was.Kind == now.Kind && was.Plane == now.Plane ? 0 : 1);
        return HasSameNumber(was, now) ? cost - SameNumber : cost;
    }

    private bool HasSameNumber(in NcMotion was, in NcMotion now) =>
        before.Program.TryNumber(before.Program[was.Block], out var a)
            && after.Program.TryNumber(after.Program[now.Block], out var b)
            && a.Number.SameValue(b.Number);

    private List<(int, int)> ByNumber(int b, int n, int a, int m)
    {
        var known = new Dictionary<(MotionKind, NcNumber), int>();
        var pairs = CommonSubsequence.Of(Numbers(before, b, n, known, -1), Numbers(after, a, m, known, -2 - n));
        return pairs.ConvertAll(p => (p.First + b, p.Second + a));
    }

    // Motions of blocks without a number share only their kind, which is no reason to pair them.
    private static int[] Numbers(NcPath path, int first, int count, Dictionary<(MotionKind, NcNumber), int> known, int own)
    {
        var numbers = new int[count];
        for (var i = 0; i < count; i++)
        {
            var motion = path.Motions[first + i];
            if (!path.Program.TryNumber(path.Program[motion.Block], out var number))
            {
                numbers[i] = own - i;
            }
            else if (!known.TryGetValue((motion.Kind, number.Number.Trim()), out numbers[i]))
            {
                numbers[i] = known.Count;
                known.Add((motion.Kind, number.Number.Trim()), numbers[i]);
            }
        }

        return numbers;
    }
}
