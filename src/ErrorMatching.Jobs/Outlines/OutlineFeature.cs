using ErrorMatching.Geometry;
using ErrorMatching.Mating;

namespace ErrorMatching.Jobs;

/// <summary>A feature that an outline proposes: what the program cuts of one of its elements.</summary>
/// <param name="Kind">Its kind.</param>
/// <param name="Lists">Places to touch, in the drawing's frame, in the order of cutting: one list for each part of the kind.</param>
internal sealed record OutlineFeature(FeatureKind Kind, IReadOnlyList<IReadOnlyList<Point2>> Lists)
{
    /// <summary>The elements of the outline that it is of.</summary>
    public required IReadOnlyList<OutlineElement> Elements { get; init; }

    // Shorter stretches are left out: no probe tells their direction, mm.
    private const double LeastMm = 2;

    // From here on a line gets a third point, which tells how it bows, and one more for each of so many.
    private const double ThreePointsMm = 4;
    private const double LineSpacingMm = 15;

    // One point for each 5 mm of a curve (Wang 2021, section 2.1), and at least five.
    private const double CurveSpacingMm = 5;
    private const int LeastOfCurve = 5;
    private const int MostPoints = 60;
    private const int OfCircle = 8;

    // Where a flank of a slot is touched, as shares of its length.
    private static readonly double[] _ofFlank = [0.2, 0.5, 0.8];

    // What is cut is searched at this distance, mm.
    private const double StepMm = 0.25;

    /// <summary>The features of a chain, in the order of cutting.</summary>
    /// <param name="elements">Its elements.</param>
    /// <param name="laying">Where it lies on the program.</param>
    /// <param name="cuts">What the program cuts.</param>
    /// <param name="notes">Gets a sentence for each element that is left out.</param>
    public static IReadOnlyList<(OutlineFeature Feature, int Motion)> Of(
        IReadOnlyList<OutlineElement> elements, OutlineLaying laying, CutPath cuts, List<string> notes)
    {
        if (SlotOf(elements, laying, cuts) is { } slot)
        {
            return [slot];
        }

        var features = new List<(OutlineFeature, int)>();
        foreach (var element in elements.Where(e => e.Kind != OutlineElementKind.Round))
        {
            if (CutStretch(element, laying, cuts) is not var (from, to) || to - from < LeastMm)
            {
                notes.Add($"{element.Curves[0].Entity} is left out: the program cuts less than {LeastMm} mm of it.");
                continue;
            }

            if (from > StepMm || to < element.LengthMm - StepMm)
            {
                notes.Add(FormattableString.Invariant(
                    $"{element.Curves[0].Entity} is cut from {from:0.0} to {to:0.0} of its {element.LengthMm:0.0} mm."));
            }

            Point2[] points = [.. Places(element, from, to, laying.RadiusMm).Select(element.At)];
            var (first, last) = (MotionAt(points[0]), MotionAt(points[^1]));
            if (first > last || (first == last && IsAgainst(points)))
            {
                Array.Reverse(points);
            }

            features.Add((
                new(
                    element.Kind switch
                    {
                        OutlineElementKind.Line => FeatureKinds.Of("line"),
                        OutlineElementKind.Circle => FeatureKinds.Of("circle"),
                        _ => FeatureKinds.Of("curve"),
                    },
                    [points])
                {
                    Elements = [element],
                },
                Math.Min(first, last)));
        }

        return features;

        int MotionAt(Point2 drawn) => cuts.FootOf(laying.Frame.Apply(drawn), laying.RadiusMm + OutlineLaying.CoverMm)!.Value.Motion;

        // On one motion, the order is that of its direction.
        bool IsAgainst(Point2[] points)
        {
            var (one, other) = (Foot(points[0]), Foot(points[1]));
            return (other.At - one.At).Dot(-one.Left.Left) < 0;
        }

        CutFoot Foot(Point2 drawn) => cuts.FootOf(laying.Frame.Apply(drawn), laying.RadiusMm + OutlineLaying.CoverMm)!.Value;
    }

    // Lengths along an element at which it is touched: clear of its ends, where the tool rounds a corner.
    private static IEnumerable<double> Places(OutlineElement element, double from, double to, double radius)
    {
        var length = to - from;
        if (element.Kind == OutlineElementKind.Circle)
        {
            return Enumerable.Range(0, OfCircle).Select(k => element.LengthMm * (k + 0.5) / OfCircle);
        }

        var margin = element.Kind == OutlineElementKind.Line ? Math.Min(length / 4, radius + 1) : Math.Min(length / 10, 1);
        var count = element.Kind == OutlineElementKind.Line
            ? length < ThreePointsMm ? 2 : 3 + (int)(length / LineSpacingMm)
            : Math.Max(LeastOfCurve, 1 + (int)Math.Ceiling(length / CurveSpacingMm));
        count = Math.Min(count, MostPoints);
        return Enumerable.Range(0, count).Select(k => from + margin + ((length - (2 * margin)) * k / (count - 1)));
    }

    // The longest stretch of an element that the program cuts without a gap.
    private static (double From, double To)? CutStretch(OutlineElement element, OutlineLaying laying, CutPath cuts)
    {
        var n = Math.Max(2, (int)Math.Ceiling(element.LengthMm / StepMm));
        var (best, start) = (((double, double)?)null, -1);
        for (var k = 0; k <= n; k++)
        {
            var isCut = laying.LeftOver(element.PlaceAt(element.LengthMm * k / n), cuts) is not null;
            start = !isCut ? -1 : start < 0 ? k : start;
            if (isCut && (best is not var (from, to) || k - start > (to - from) * n / element.LengthMm))
            {
                best = (element.LengthMm * start / n, element.LengthMm * k / n);
            }
        }

        return best;
    }

    // Two equal parallel lines and half circles between them. The cut begins with a flank.
    private static (OutlineFeature Feature, int Motion)? SlotOf(
        IReadOnlyList<OutlineElement> elements, OutlineLaying laying, CutPath cuts)
    {
        if (elements.Count != 4)
        {
            return null;
        }

        var first = elements[0].Kind == OutlineElementKind.Line ? 0 : 1;
        OutlineElement[] turned = [.. Enumerable.Range(first, 4).Select(e => elements[e % 4])];
        if (turned[0].Kind != OutlineElementKind.Line || turned[2].Kind != OutlineElementKind.Line
            || turned[1].Curves is not [DrawnArc one] || turned[3].Curves is not [DrawnArc other]
            || Math.Abs(Math.Abs(one.Sweep) - Math.PI) > 0.01 || Math.Abs(Math.Abs(other.Sweep) - Math.PI) > 0.01
            || Math.Abs(one.Radius - other.Radius) > OutlineChain.JoinMm)
        {
            return null;
        }

        Point2[][] lists = [
            .. turned.Select(e => e.Kind == OutlineElementKind.Line
                ? _ofFlank.Select(s => e.At(s * e.LengthMm)).ToArray()
                : [e.At(e.LengthMm / 2)])];
        var feet = lists.Select(l => l.Select(p => cuts.FootOf(
            laying.Frame.Apply(p), laying.RadiusMm + OutlineLaying.CoverMm)).ToArray()).ToArray();
        if (feet.Any(l => Array.Exists(l, f => f is null)))
        {
            return null;
        }

        var against = (feet[0][1]!.Value.At - feet[0][0]!.Value.At).Dot(-feet[0][0]!.Value.Left.Left) < 0;
        if (against)
        {
            lists = [lists[0], lists[3], lists[2], lists[1]];
            Array.ForEach(lists, Array.Reverse);
        }

        return (new(FeatureKinds.Of("slot"), lists) { Elements = elements }, feet.SelectMany(f => f).Min(f => f!.Value.Motion));
    }
}
