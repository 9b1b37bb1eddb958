using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Compares two programs motion by motion, regardless of numbering and spelling. First aligns motions of the same kind, end and
/// center, in order. Then pairs the motions left between them so that their ends are close. The rest were inserted or removed.</summary>
/// <remarks>
/// Time grows with the length of the programs times the number of differences, up to the length times 1024: programs of 100,000 blocks
/// with few differences take a fraction of a second, wholly displaced ones about one second.
/// </remarks>
public sealed class MotionComparison
{
    // Far below any increment: the rounding of equal decimals after sums of increments.
    private const double Same = 1e-9;

    private readonly List<MotionDifference> _differences = [];
    private readonly List<(int Before, int After)> _pairs;
    private readonly FunctionWords _wordsBefore;
    private readonly FunctionWords _wordsAfter;

    private MotionComparison(NcPath before, NcPath after)
    {
        (Before, After) = (before, after);
        (_wordsBefore, _wordsAfter) = (new(before), new(after));
        _pairs = Align(before, after);
        Walk();
        AtEnd = FunctionsOf(before.Motions.Length, after.Motions.Length);
    }

    /// <summary>The first program, interpreted.</summary>
    public NcPath Before { get; }

    /// <summary>The second program, interpreted.</summary>
    public NcPath After { get; }

    /// <summary>The motions that differ, in program order.</summary>
    public IReadOnlyList<MotionDifference> Differences => _differences;

    /// <summary>Words that move nothing after the last motions, if they differ; otherwise null.</summary>
    public FunctionChange? AtEnd { get; }

    /// <summary>Number of motions that are equal in both programs.</summary>
    public int Identical => Before.Motions.Length - _differences.Count(d => d.Before >= 0);

    /// <summary>True if no motion differs and no word after the last one.</summary>
    public bool IsSame => _differences.Count == 0 && AtEnd is null;

    /// <summary>The motion with the largest displacement of its end or center, the first if several are equal; null if none
    /// moved.</summary>
    public MotionDifference? Furthest => _differences.Where(d => d.Change == MotionChange.Moved).MaxBy(d => Math.Round(DistanceMm(d), 9));

    /// <summary>Pairs of corresponding motions, ascending in both programs.</summary>
    internal IReadOnlyList<(int Before, int After)> Pairs => _pairs;

    /// <summary>Compares two programs.</summary>
    public static MotionComparison Of(NcPath before, NcPath after) => new(before, after);

    /// <summary>Displacement of a motion's end or center, whichever is larger, mm.</summary>
    public static double DistanceMm(MotionDifference difference) =>
        Math.Max(difference.Displacement.Length, difference.CenterDisplacement.Length);

    private static List<(int Before, int After)> Align(NcPath before, NcPath after)
    {
        var known = new Dictionary<MotionPlace, int>();
        var nearest = new NearestMotions(before, after);
        var pairs = new List<(int, int)>();
        var (b, a) = (0, 0);
        foreach (var (i, j) in CommonSubsequence.Of(
            MotionPlace.Numbers(before, known), MotionPlace.Numbers(after, known)).Append((before.Motions.Length, after.Motions.Length)))
        {
            if (i > b && j > a)
            {
                pairs.AddRange(nearest.Pair(b..i, a..j));
            }

            pairs.Add((i, j));
            (b, a) = (i + 1, j + 1);
        }

        // Removes the pair of the two ends, which only closed the last stretch.
        pairs.RemoveAt(pairs.Count - 1);
        return pairs;
    }

    private void Walk()
    {
        var (b, a) = (0, 0);
        foreach (var (i, j) in _pairs.Append((Before.Motions.Length, After.Motions.Length)))
        {
            for (; b < i; b++)
            {
                _wordsBefore.Collect(b);
                _differences.Add(new(
                    MotionChange.Removed,
                    b,
                    -1,
                    Vector3.Zero,
                    Vector2.Zero,
                    _wordsBefore.Texts is { Count: > 0 } words ? new(words, []) : null));
            }

            for (; a < j; a++)
            {
                _wordsAfter.Collect(a);
                _differences.Add(new(
                    MotionChange.Inserted,
                    -1,
                    a,
                    Vector3.Zero,
                    Vector2.Zero,
                    _wordsAfter.Texts is { Count: > 0 } words ? new([], words) : null));
            }

            if (i < Before.Motions.Length && j < After.Motions.Length)
            {
                Compare(i, j);
            }

            (b, a) = (i + 1, j + 1);
        }
    }

    private void Compare(int i, int j)
    {
        var (was, now) = (Before.Motions[i], After.Motions[j]);
        var center = was.IsArc && now.IsArc ? now.Center - was.Center : Vector2.Zero;
        var functions = FunctionsOf(i, j);
        MotionChange? change = was.Kind != now.Kind || was.Plane != now.Plane ? MotionChange.Replaced
            : (now.End - was.End).Length > Same || center.Length > Same || was.Turns != now.Turns || was.UnknownEnd != now.UnknownEnd
                ? MotionChange.Moved
            : Math.Abs(was.Feed - now.Feed) > Same ? MotionChange.Feed
            : functions is not null ? KindOf(functions)
            : null;
        if (change is { } found)
        {
            _differences.Add(new(found, i, j, now.End - was.End, center, functions));
        }
    }

    private FunctionChange? FunctionsOf(int i, int j)
    {
        if (_wordsBefore.Bytes(i).SequenceEqual(_wordsAfter.Bytes(j)))
        {
            return null;
        }

        _wordsBefore.Collect(i);
        _wordsAfter.Collect(j);
        return _wordsBefore.SameAs(_wordsAfter) ? null : new(_wordsBefore.Texts, _wordsAfter.Texts);
    }

    private static MotionChange KindOf(FunctionChange functions)
    {
        string[] differing = [
            .. functions.Before.Except(functions.After, StringComparer.Ordinal),
            .. functions.After.Except(functions.Before, StringComparer.Ordinal)];
        return differing.Any(w => w is "M6" || w is ['T', ..]) ? MotionChange.Tool
            : differing.Any(w => w is "M3" or "M4" or "M5" || w is ['S', ..]) ? MotionChange.Spindle
            : MotionChange.Words;
    }
}

/// <summary>Identifies equal motions regardless of their position in a program: kind, plane, end and center on a grid so fine that only
/// equal decimals coincide.</summary>
internal readonly record struct MotionPlace(
    MotionKind Kind, CoordinatePlane Plane, int Turns, long X, long Y, long Z, long CenterX, long CenterY)
{
    private const double StepsPerMm = 1e7;

    /// <summary>The place of a motion.</summary>
    public static MotionPlace Of(in NcMotion m) => m.IsArc
        ? new(m.Kind, m.Plane, m.Turns, Step(m.End.X), Step(m.End.Y), Step(m.End.Z), Step(m.Center.X), Step(m.Center.Y))
        : new(m.Kind, m.Plane, 0, Step(m.End.X), Step(m.End.Y), Step(m.End.Z), 0, 0);

    /// <summary>A number for each motion, equal for equal places.</summary>
    public static int[] Numbers(NcPath path, Dictionary<MotionPlace, int> known)
    {
        var numbers = new int[path.Motions.Length];
        for (var i = 0; i < numbers.Length; i++)
        {
            var place = Of(path.Motions[i]);
            if (!known.TryGetValue(place, out numbers[i]))
            {
                numbers[i] = known.Count;
                known.Add(place, numbers[i]);
            }
        }

        return numbers;
    }

    // A coordinate beyond the range of a long saturates: no machine has such a place.
    private static long Step(double millimeters) => (long)Math.Round(millimeters * StepsPerMm);
}
