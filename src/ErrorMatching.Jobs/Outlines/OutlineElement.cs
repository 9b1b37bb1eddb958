using ErrorMatching.Geometry;

namespace ErrorMatching.Jobs;

/// <summary>A stretch of an outline between two corners, or a round between two of its neighbors.</summary>
/// <param name="Kind">What it is.</param>
/// <param name="Curves">Its curves in order.</param>
internal sealed record OutlineElement(OutlineElementKind Kind, IReadOnlyList<DrawnCurve> Curves)
{
    // Directions that differ by no more go on: 1 degree, as drawings are rounded.
    private const double GoesOnSine = 0.0175;

    // Pieces of one line are nearly parallel.
    private const double SameLineSine = 0.002;

    // Shorter lines that go on in others are pieces of a curve, mm.
    private const double ShortMm = 2;

    // An arc of at most this radius between two lines that it is tangent to rounds their corner, mm.
    private const double RoundMm = 6;

    /// <summary>Its start.</summary>
    public Point2 From => Curves[0].From;

    /// <summary>Its end.</summary>
    public Point2 To => Curves[^1].To;

    /// <summary>Its length, mm.</summary>
    public double LengthMm => Curves.Sum(c => c.LengthMm);

    /// <summary>The place at a length from its start.</summary>
    public Point2 At(double mm)
    {
        foreach (var curve in Curves)
        {
            if (mm <= curve.LengthMm)
            {
                return curve.AtLength(Math.Max(mm, 0));
            }

            mm -= curve.LengthMm;
        }

        return To;
    }

    /// <summary>The place at a length from its start, and where the outline leads there.</summary>
    public OutlinePlace PlaceAt(double mm)
    {
        var step = Math.Min(0.01, LengthMm / 10);
        var (from, to) = (At(Math.Max(0, mm - step)), At(Math.Min(LengthMm, mm + step)));
        return new(At(mm), (to - from).Normalize());
    }

    /// <summary>The elements of a chain: lines, what bends between corners, rounds of corners, and whole circles.</summary>
    public static IReadOnlyList<OutlineElement> Of(OutlineChain chain)
    {
        if (chain.Curves is [DrawnArc { IsCircle: true }])
        {
            return [new(OutlineElementKind.Circle, chain.Curves)];
        }

        var elements = new List<OutlineElement>();
        foreach (var curve in Rotated(chain))
        {
            var kind = KindOf(curve);
            if (elements.Count > 0 && elements[^1] is var last && last.Kind == kind
                && GoesOn(
                    last.Curves[^1].DirectionAtEnd,
                    curve.DirectionAtStart,
                    kind == OutlineElementKind.Line ? SameLineSine : GoesOnSine))
            {
                elements[^1] = last with { Curves = [.. last.Curves, curve] };
            }
            else
            {
                elements.Add(new(kind, [curve]));
            }
        }

        for (var e = 0; e < elements.Count; e++)
        {
            if (elements[e].Curves is [DrawnLine])
            {
                elements[e] = elements[e] with { Kind = OutlineElementKind.Line };
            }
        }

        for (var e = 0; e < elements.Count; e++)
        {
            var (before, behind) = (Neighbor(e, -1), Neighbor(e, 1));
            if (elements[e] is { Kind: OutlineElementKind.Curve, Curves: [DrawnArc { Radius: <= RoundMm } arc] }
                && before?.Kind == OutlineElementKind.Line && behind?.Kind == OutlineElementKind.Line
                && GoesOn(before.Curves[^1].DirectionAtEnd, arc.DirectionAtStart)
                && GoesOn(arc.DirectionAtEnd, behind.Curves[0].DirectionAtStart))
            {
                elements[e] = elements[e] with { Kind = OutlineElementKind.Round };
            }
        }

        return elements;

        OutlineElement? Neighbor(int e, int step) => e + step >= 0 && e + step < elements.Count ? elements[e + step]
            : chain.IsClosed && elements.Count > 1 ? elements[(e + step + elements.Count) % elements.Count] : null;
    }

    // A closed chain begins at a corner, so that no element is cut in two by where it was drawn from.
    private static IEnumerable<DrawnCurve> Rotated(OutlineChain chain)
    {
        var first = 0;
        if (chain.IsClosed)
        {
            var n = chain.Curves.Count;
            first = Math.Max(0, Enumerable.Range(0, n).FirstOrDefault(
                c => KindOf(chain.Curves[c]) != KindOf(chain.Curves[(c + n - 1) % n])
                    || !GoesOn(chain.Curves[(c + n - 1) % n].DirectionAtEnd, chain.Curves[c].DirectionAtStart), 0));
        }

        return chain.Curves.Skip(first).Concat(chain.Curves.Take(first));
    }

    private static OutlineElementKind KindOf(DrawnCurve curve) =>
        curve is DrawnLine && curve.LengthMm > ShortMm ? OutlineElementKind.Line : OutlineElementKind.Curve;

    private static bool GoesOn(Vector2 one, Vector2 other, double sine = GoesOnSine) =>
        one.Dot(other) > 0 && Math.Abs(one.Cross(other)) <= sine;
}

/// <summary>What a stretch of an outline is.</summary>
internal enum OutlineElementKind
{
    /// <summary>Straight.</summary>
    Line,

    /// <summary>Bent, without a corner.</summary>
    Curve,

    /// <summary>An arc that rounds the corner of two lines.</summary>
    Round,

    /// <summary>A whole circle.</summary>
    Circle,
}

/// <summary>A place of an outline.</summary>
/// <param name="At">Where it is.</param>
/// <param name="Along">Unit vector along the outline there.</param>
internal readonly record struct OutlinePlace(Point2 At, Vector2 Along);
