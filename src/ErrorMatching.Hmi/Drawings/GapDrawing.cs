using System.Collections.ObjectModel;
using ErrorMatching.Geometry;
using ErrorMatching.Mating;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>The two boundaries of a mating as lines, with exaggerated deviations: the measured part, and the counterpart that a
/// program cuts. In the part's frame, or turned by 90 degrees if the part is tall, so that its long side is horizontal.</summary>
/// <param name="Part">The part's boundary, one line per feature, mm.</param>
/// <param name="Counterpart">The counterpart's boundary, one line per feature, mm.</param>
/// <param name="Points">The key points on the part's boundary, mm: label, position, opposite position on the counterpart, gap,
/// deviation of the part, and whether the mating error is outside its limits.</param>
/// <param name="Extent">Extent of both drawings, without and with compensation, so that they share one scale.</param>
/// <param name="Factor">Factor by which deviations are enlarged.</param>
/// <param name="LargestMm">The largest absolute gap or overlap at a key point.</param>
/// <param name="IsLong">True if one side is much longer than the other.</param>
/// <param name="IsTurned">True if it is turned clockwise by 90 degrees.</param>
internal sealed record GapDrawing(
    IReadOnlyList<IReadOnlyList<Point2>> Part,
    IReadOnlyList<IReadOnlyList<Point2>> Counterpart,
    IReadOnlyList<(string Label, Point2 At, Point2 Opposite, double GapMm, double PartMm, bool IsOutside)> Points,
    PlotBox Extent,
    double Factor,
    double LargestMm,
    bool IsLong,
    bool IsTurned)
{
    // Places of one boundary that are further apart than this part of the outline belong to different lines.
    private const double ApartShare = 0.2;

    // Share of the drawing that the largest deviation takes.
    private const double Share = 0.08;

    // A part is long if its sides differ by this factor.
    private const double LongFactor = 1.5;

    /// <summary>Half the 95 % interval about each error, by label; empty if it is not known.</summary>
    public IReadOnlyDictionary<string, double> Intervals95Mm { get; private init; } = ReadOnlyDictionary<string, double>.Empty;

    /// <summary>The places where the pair touches, or is tightest, at its seat: position, feature, and the block that cuts it.</summary>
    public IReadOnlyList<(Point2 At, string Feature, string Block)> Contacts { get; private init; } = [];

    /// <summary>The gap along the boundary at the seat, negative for an overlap; empty unless the pair is drawn at its seat.</summary>
    public IReadOnlyList<(Point2 At, string Feature, double GapMm)> Seat { get; private init; } = [];

    /// <summary>The place where the error is largest, or least known, with what is said of it; null if it is not marked.</summary>
    public (Point2 At, string Text)? Worst { get; private init; }

    /// <summary>The largest mating error without sign, with its interval if that is known.</summary>
    public string LargestText =>
        Shown.Mm(LargestMm, Interval95Mm(Points.Count == 0 ? "" : Points.MaxBy(p => Math.Abs(p.GapMm)).Label));

    /// <summary>Note below the drawing: the exaggeration, and whether it is turned.</summary>
    public string Note
    {
        get
        {
            var note = Seat.Count > 0
                ? Texts.Current.With("Detail.AtSeat", Shown.Count((long)Factor))
                : Factor == 1
                ? Texts.Current["Detail.TrueToScale"]
                : Texts.Current.With("Detail.Exaggerated", Shown.Count((long)Factor));
            return IsTurned ? Texts.Current.With("Detail.NoteTurned", note) : note;
        }
    }

    /// <summary>The assembly without compensation.</summary>
    public static GapDrawing Before(StoredPiece piece) => Of(piece, p => p.BeforeError);

    /// <summary>The assembly with compensation.</summary>
    public static GapDrawing After(StoredPiece piece) => Of(piece, p => p.AfterError) with { Intervals95Mm = piece.Intervals95Mm };

    /// <summary>The pair at its seat, with its gaps exaggerated on their own; null if no seat is known.</summary>
    /// <param name="piece">The key points.</param>
    /// <param name="pair">The pair at its seat.</param>
    /// <param name="worst">The worst error that is left; null if it is not known.</param>
    public static GapDrawing? AtSeat(StoredPiece piece, PairAssembly? pair, ErrorLeft? worst)
    {
        if (pair is not { Gaps: { Count: > 1 } gaps })
        {
            return null;
        }

        var all = PlotBox.Of(gaps.Select(g => g.Place));
        var (width, height) = (all.Right - all.Left, all.High - all.Low);
        var (largest, isTurned) = (gaps.Max(g => Math.Abs(g.GapMm)), height >= LongFactor * width);
        var factor = largest == 0 ? 1 : Math.Max(1, RoundNumber.AtMost(Share * Math.Max(width, height) / largest));
        var lines = Lines(gaps, ApartShare * Math.Sqrt((width * width) + (height * height)));
        var drawn = After(piece);
        var features = gaps.Select(g => g.Feature).ToHashSet(StringComparer.Ordinal);
        return drawn with
        {
            Part = [.. lines.Select(l => (IReadOnlyList<Point2>)[.. l.Select(g => Lying(g.Place))])],
            Counterpart = [.. lines.Select(l => (IReadOnlyList<Point2>)[.. l.Select(g => Lying(Opposite(g)))])],
            Points = [
                .. piece.Result.Boundaries.SelectMany(b => b.Points.Select(p => (Feature: b.Name, Place: Lying(p.Theoretical))))
                    .Zip(drawn.Points)
                    .Where(p => features.Contains(p.First.Feature))
                    .Select(p => p.Second with { At = p.First.Place, Opposite = p.First.Place })],
            Extent = PlotBox.Of(gaps.SelectMany(g => new[] { Lying(g.Place), Lying(Opposite(g)) })),
            Factor = factor,
            LargestMm = largest,
            IsTurned = isTurned,
            Contacts = [.. pair.Contacts.Select(c => (Lying(c.Place), c.Feature, c.Block))],
            Seat = [.. gaps.Select(g => (Lying(g.Place), g.Feature, g.GapMm))],
            Worst = worst is null ? null : (Lying(worst.Place), MatchVerdictText.At(worst)),
        };

        // The part is where it is, and the counterpart gives way: what is shown as a gap is one.
        Point2 Opposite(PairGap gap) => gap.Place - (factor * gap.GapMm * gap.Normal);

        Point2 Lying(Point2 place) => isTurned ? new(place.Y, -place.X) : place;
    }

    // The places of a feature follow one another along its boundary.
    private static List<List<PairGap>> Lines(IReadOnlyList<PairGap> gaps, double apart)
    {
        List<List<PairGap>> lines = [[gaps[0]]];
        foreach (var (before, gap) in gaps.Zip(gaps.Skip(1)))
        {
            if (gap.Feature != before.Feature || gap.Place.DistanceTo(before.Place) > apart)
            {
                lines.Add([]);
            }

            lines[^1].Add(gap);
        }

        return lines;
    }

    /// <summary>Half the 95 % interval about the error at a key point; null if it is not known.</summary>
    public double? Interval95Mm(string label) => Intervals95Mm.TryGetValue(label, out var half) ? half : null;

    // A mating error is counterpart - part along the normal. The gap has the opposite sign: part - counterpart.
    private static GapDrawing Of(StoredPiece piece, Func<VerifiedPoint, MatingError> error)
    {
        var factor = FactorOf(piece);
        var (width, height) = SizeOf(piece);
        var (isLong, isTurned) = (Math.Max(width, height) >= LongFactor * Math.Min(width, height), height >= LongFactor * width);
        var (part, counterpart, labels) = (
            new List<IReadOnlyList<Point2>>(),
            new List<IReadOnlyList<Point2>>(),
            new List<(string, Point2, Point2, double, double, bool)>());
        var all = new List<Point2>();
        var byLabel = piece.Result.Points.ToDictionary(p => p.Label, StringComparer.Ordinal);
        foreach (var boundary in piece.Result.Boundaries)
        {
            var points = boundary.Points.Select(
                p => (Point: byLabel[p.Label], p.Theoretical, PartMm: (byLabel[p.Label].Part - p.Theoretical).Dot(byLabel[p.Label].Normal)))
                .ToArray();
            labels.AddRange(points.Select(
                p => (
                    p.Point.Label,
                    Off(p.Theoretical, p.Point, p.PartMm),
                    Off(p.Theoretical, p.Point, p.PartMm + error(p.Point).NormalMm),
                    -error(p.Point).NormalMm,
                    p.PartMm,
                    piece.Result.IsOutside(p.Point.Label, error(p.Point).NormalMm))));
            all.AddRange(points.SelectMany(
                p => new[]
                {
                    0,
                    p.Point.BeforeError.NormalMm,
                    p.Point.AfterError.NormalMm
                }.Select(e => Off(p.Theoretical, p.Point, p.PartMm + e))));
            if (boundary.Outline.Count > 1)
            {
                var outline = new DisplacedOutline(boundary.Outline, [.. points.Select(p => (p.Theoretical, p.Point.Normal))]);
                part.Add(By(_ => 0));
                counterpart.Add(By(p => error(p).NormalMm));
                all.AddRange([.. part[^1], .. By(p => p.BeforeError.NormalMm), .. By(p => p.AfterError.NormalMm)]);

                Point2[] By(Func<VerifiedPoint, double> further) =>
                    [.. outline.By([.. points.Select(p => factor * (p.PartMm + further(p.Point)))]).Select(Lying)];
            }
        }

        return new(
            part,
            counterpart,
            labels,
            PlotBox.Of(all),
            factor,
            piece.Result.Points.Select(p => Math.Abs(error(p).NormalMm)).DefaultIfEmpty().Max(),
            isLong,
            isTurned);

        Point2 Off(Point2 place, VerifiedPoint point, double mm) => Lying(place + (factor * mm * point.Normal));

        Point2 Lying(Point2 place) => isTurned ? new(place.Y, -place.X) : place;
    }

    private static (double Width, double Height) SizeOf(StoredPiece piece) =>
        PlotBox.Of(piece.Result.Boundaries.SelectMany(b => b.Points.Select(p => p.Theoretical).Concat(b.Outline))) is { IsEmpty: false } box
            ? (box.Right - box.Left, box.High - box.Low)
            : (0, 0);

    // The same before and after, so that the two can be compared.
    private static double FactorOf(StoredPiece piece)
    {
        var places = PlotBox.Of(piece.Result.Boundaries.SelectMany(b => b.Points).Select(p => p.Theoretical));
        var byLabel = piece.Result.Points.ToDictionary(p => p.Label, StringComparer.Ordinal);
        var largest = piece.Result.Boundaries.SelectMany(b => b.Points)
            .Select(p => Math.Max(
                Math.Abs((byLabel[p.Label].Part - p.Theoretical).Dot(byLabel[p.Label].Normal)),
                Math.Abs(byLabel[p.Label].BeforeError.NormalMm)))
            .DefaultIfEmpty()
            .Max();

        // A round number, so that the factor can be shown.
        return largest == 0 || places.IsEmpty
            ? 1
            : Math.Max(1, RoundNumber.AtMost(Share * Math.Max(places.Right - places.Left, places.High - places.Low) / largest));
    }
}
