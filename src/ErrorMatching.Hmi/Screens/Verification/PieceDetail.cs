using ErrorMatching.Cell;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi;

/// <summary>One piece and the ones before it, formatted for display.</summary>
internal sealed class PieceDetail : Observable
{
    // Enough points to show where to look; the error and point tabs list all of them.
    private const int MostMissed = 6;

    private readonly StoredPiece _piece;
    private string? _next;
    private bool _isCut;
    private readonly IReadOnlyDictionary<string, string> _features;

    /// <summary>Formats the details.</summary>
    /// <param name="piece">The piece.</param>
    /// <param name="series">The last pieces of its job, in order of arrival.</param>
    public PieceDetail(StoredPiece piece, IReadOnlyList<StoredPiece> series)
    {
        _piece = piece ?? throw new ArgumentNullException(nameof(piece));
        _features = piece.Result.Boundaries.SelectMany(b => b.Points.Select(p => (p.Label, b.Name))).ToDictionary(
            p => p.Label, p => p.Name, StringComparer.Ordinal);
        Features = [.. piece.Result.Features.Select(Row)];
        Points = [.. piece.Result.Points.Select(Row)];
        Errors = ErrorsOf();
        Trend = TrendOf(series);
        (Before, After) = (GapDrawing.Before(piece), GapDrawing.After(piece));
        var predicted = piece is { IsMeasured: false, Match.Verdict: { } verdict } ? MatchVerdictText.Farthest(verdict) : null;
        Seat = GapDrawing.AtSeat(piece, Pair, piece.Verdict?.Worst ?? predicted) ?? After;
    }

    /// <summary>Number and serial number or file.</summary>
    public string Title => CorrectionLabel.Of(_piece.Correction);

    /// <summary>The workpiece's name.</summary>
    public string Job => _piece.JobName;

    public string Kind => KindOf(_piece);

    /// <summary>The origin of the results, in a sentence.</summary>
    public string Origin => Sentence.Joined(
        _piece.Counterpart is { } counterpart
            ? Texts.Current.With("Verify.Measured", CorrectionLabel.Of(counterpart))
            : Texts.Current["Verify.Predicted"],
        _piece.Before is { } before
            ? Texts.Current.With(_piece.IsMeasured ? "Verify.BeforeMeasured" : "Verify.BeforeOwn", Path.GetFileName(before.File))
            : Texts.Current["Verify.BeforeDesigned"]);

    /// <summary>The improvement, in a sentence with numbers.</summary>
    public string Summary
    {
        get
        {
            var (result, texts) = (_piece.Result, Texts.Current);
            var better = result.RmsImprovementPercent;
            var word = !_piece.TellsImprovement
                ? "Verdict.AgainstDesigned"
                : better is null
                ? "Verdict.Same"
                : IsWorse
                ? "Verdict.Worse"
                : _piece.IsMeasured
                ? "Verdict.Better"
                : "Verdict.BetterPredicted";
            return texts.With(word, Shown.Percent(Math.Abs(better ?? 0)))
                + texts.With(
                    "Verdict.Figures",
                    Shown.Mm(result.RmsBeforeMm),
                    Shown.Mm(result.RmsAfterMm),
                    Shown.Mm(result.MaxBeforeMm),
                    Shown.Mm(result.MaxAfterMm, _piece.LargestInterval95Mm));
        }
    }

    /// <summary>True if the piece is worse than without compensation.</summary>
    public bool IsWorse => _piece.TellsImprovement && _piece.Result.RmsImprovementPercent < 0;

    /// <summary>Whether all errors are within their limits, and which are not; once the counterpart is measured, with the risk.</summary>
    public string Verdict => _piece.Verdict is { } verdict
        ? Sentence.Joined(
            VerifyVerdictText.Of(verdict),
            PairText.Head(_piece.Pair, _piece.Result.Boundaries.Select(b => b.ErrorBand)),
            PushedOutOf(_piece))
        : VerdictOf(_piece);

    /// <summary>Number of warnings of its correction; null if there are none, or if the correction is unknown.</summary>
    public string? Warnings =>
        _piece.Match is { Warnings: { Count: > 0 } warnings } ? Texts.Current.With("Head.Warnings", warnings.Count) : null;

    /// <summary>Opens those warnings.</summary>
    public Command? ReadWarnings { get; init; }

    /// <summary>Points where the prediction was off by more than measuring explains (twice the standard uncertainty); null if
    /// nothing can be compared.</summary>
    public string? Missed => _piece.Misses is not { Count: > 0 } all ? null
        : Significant is { Count: > 0 } missed && missed.MaxBy(m => Math.Abs(m.Mm)) is var worst
            ? Texts.Current.With(
                "Verdict.Missed",
                missed.Count,
                Listed(missed.Take(MostMissed).Select(m => m.Point)) + (missed.Count > MostMissed ? " …" : ""),
                Shown.Mm(Math.Abs(worst.Mm)),
                worst.Point)
            : Texts.Current.With("Verdict.Met", Shown.Mm(all.Max(m => Math.Abs(m.Mm))));

    /// <summary>True if the prediction was off at some point.</summary>
    public bool IsMissed => Significant.Count > 0;

    public Severity MissedSeverity => IsMissed ? Severity.Attention : Severity.Quiet;

    /// <summary>True if the details say what somebody should know.</summary>
    public bool NeedsReading => IsMissed || IsWorse || Warnings is not null;

    /// <summary>What the user should do now, in a sentence.</summary>
    public string ToDo
    {
        get
        {
            var (texts, outside) = (Texts.Current, _piece.Outside);
            var missed = outside.Intersect(Significant.Select(m => m.Point), StringComparer.Ordinal).ToArray();
            return (_piece.IsMeasured, IsWorse, outside.Count, missed.Length) switch
            {
                (false, _, 0, _) => _next ?? texts["Verdict.DoMeasure"],
                (false, _, _, _) => Sentence.Joined(_isCut ? "" : texts.With("Verdict.DoRead", Listed(outside)), _next ?? ""),
                (true, true, _, _) => texts["Verdict.DoStop"],
                (true, _, 0, _) => texts["Verdict.DoNothing"],
                (true, _, _, 0) => texts.With(outside.All(IsOnCorner) ? "Verdict.DoReachCorner" : "Verdict.DoReach", Listed(outside)),
                _ => texts.With("Verdict.DoLook", Listed(missed)),
            };
        }
    }

    public Severity Severity => SeverityOf(_piece);

    /// <summary>True if the measured counterpart is in tolerance.</summary>
    public bool IsGood => _piece.Verdict?.IsInTolerance == true;

    /// <summary>The error at each key point with its limits.</summary>
    public SeriesDrawing Errors { get; }

    /// <summary>The largest error and the root mean square, piece by piece.</summary>
    public SeriesDrawing Trend { get; }

    /// <summary>How to read the trend. Also says if the pieces are based on different counterparts.</summary>
    public string TrendCaption => Sentence.Joined(
        Texts.Current["Verify.TrendCaption"],
        Trend.IsHollow.Any(h => h) ? Texts.Current["Verify.TrendHollow"] : "",
        Trend.Lines.Any(l => l.Beginnings.Count > 0) ? Texts.Current["Verify.TrendBreaks"] : "");

    /// <summary>The assembly without compensation.</summary>
    public GapDrawing Before { get; }

    /// <summary>The assembly with compensation.</summary>
    public GapDrawing After { get; }

    /// <summary>The pair at its seat, as measured, or as predicted until it is; with compensation, if no seat is known.</summary>
    public GapDrawing Seat { get; }

    /// <summary>How the pair goes together, and what its picture shows.</summary>
    public string SeatCaption => Sentence.Joined(
        Pair is { } pair ? PairText.Of(pair, _piece.Result.Boundaries.Select(b => b.ErrorBand)) : "", Seat.Note);

    /// <summary>The largest gap or overlap without compensation.</summary>
    public string BeforeCaption => Texts.Current.With("Verify.AssemblyBefore", Before.LargestText);

    /// <summary>The largest gap or overlap with compensation.</summary>
    public string AfterCaption =>
        Texts.Current.With(_piece.IsMeasured ? "Verify.AssemblyAfter" : "Verify.AssemblyPredicted", After.LargestText);

    /// <summary>Note on the exaggeration, and on whether the drawing is turned.</summary>
    public string Exaggeration => Before.Note;

    /// <summary>The features' quantities.</summary>
    public IReadOnlyList<ImprovementRow> Features { get; }

    public IReadOnlyList<MatingErrorRow> Points { get; }

    /// <summary>Updates the next step of a prediction, which changes while all else stays the same.</summary>
    /// <param name="correction">The current correction.</param>
    /// <param name="next">The text of <see cref="NextStep"/>; null if there is none.</param>
    internal void Follow(Correction correction, string? next)
    {
        (_isCut, _next) = (correction.State == CorrectionState.Released, next);
        OnPropertyChanged(nameof(ToDo));
    }

    /// <summary>Measured or predicted, in a word.</summary>
    internal static string KindOf(StoredPiece piece) => Texts.Current[piece.IsMeasured ? "Verify.KindMeasured" : "Verify.KindPredicted"];

    /// <summary>Whether all errors of a piece are within their limits, and which are not.</summary>
    internal static string VerdictOf(StoredPiece piece) =>
        piece.Outside is not { Count: > 0 } outside ? Texts.Current["Verify.AllWithin"] : Sentence.Joined(
        Texts.Current.Counted("Verify.Outside", outside.Count, outside.Count, Listed(outside)),
        PushedOutOf(piece));

    private static string PushedOutOf(StoredPiece piece) =>
        piece.PushedOut is { Count: > 0 } worse ? Texts.Current.With("Verify.PushedOut", Listed(worse)) : "";

    internal static Severity SeverityOf(StoredPiece piece) => piece.Verdict is { } verdict ? VerifyVerdictText.SeverityOf(verdict)
        : piece.IsWithin ? Severity.Quiet
        : Severity.Attention;

    // No program can meet its deviation, but other limits or another point may help: the correction warned of it.
    private bool IsOnCorner(string point) => _piece.Match?.OnCorners.Contains(point, StringComparer.Ordinal) == true;

    private PairAssembly? Pair => _piece.Pair ?? (_piece.IsMeasured ? null : _piece.Match?.Pair);

    private IReadOnlyList<PredictionMiss> Significant => [.. _piece.Misses.Where(m => m.IsSignificant)];

    private static string Listed(IEnumerable<string> labels) => Texts.Current.Listed(labels);

    private SeriesDrawing ErrorsOf()
    {
        var (texts, result, points) = (Texts.Current, _piece.Result, _piece.Result.Points);
        var (bands, beginnings) = (new List<SeriesBand>(), new HashSet<int>());
        for (var (i, first) = (0, 0); i < points.Count; i++)
        {
            var band = result.BandOf(points[i].Label);
            if (i + 1 == points.Count || result.BoundaryOf(points[i + 1].Label)?.Name != result.BoundaryOf(points[i].Label)?.Name)
            {
                bands.AddRange(band is { } limits ? [new SeriesBand(first, i, limits.LowerMm, limits.UpperMm)] : Array.Empty<SeriesBand>());
                beginnings.Add(first = i + 1);
            }
        }

        return new(
            [.. points.Select(p => p.Label)],
            [.. Points.Select(p => texts.With("Verify.At", p.Point, p.Before, p.After, p.Low, p.High))],
            [
                new(
                    SeriesKind.Before,
                    texts[_piece.IsBeforeMeasured ? "Verify.LineBefore" : "Verify.LineBeforeDesigned"],
                    [.. points.Select(p => (double?)p.BeforeError.NormalMm)]),
                new(
                    SeriesKind.After,
                    texts[_piece.IsMeasured ? "Verify.LineAfter" : "Verify.LineAfterPredicted"],
                    [.. points.Select(p => (double?)p.AfterError.NormalMm)]),
            ],
            bands,
            [])
        {
            Beginnings = beginnings,
        };
    }

    private static string BaseOf(StoredPiece piece) =>
        piece.Before is { } before
            ? Texts.Current.With("Verify.TrendBefore", Path.GetFileName(before.File))
            : Texts.Current["Verify.TrendBeforeDesigned"];

    private static SeriesDrawing TrendOf(IReadOnlyList<StoredPiece> series)
    {
        var texts = Texts.Current;

        // Errors based on different counterparts cannot be compared.
        var breaks = Enumerable.Range(0, series.Count).Where(i => i > 0 && series[i].Before != series[i - 1].Before).ToHashSet();
        return new(
            [.. series.Select(p => p.Correction.Serial ?? "#" + Shown.Id(p.Correction.Id))],
            [
                .. series.Select(p => texts.With(
                    "Verify.TrendAt",
                    CorrectionLabel.Of(p.Correction),
                    KindOf(p),
                    Shown.Mm(p.Result.MaxBeforeMm),
                    Shown.Mm(p.Result.MaxAfterMm, p.LargestInterval95Mm),
                    Shown.Mm(p.Result.RmsBeforeMm),
                    Shown.Mm(p.Result.RmsAfterMm),
                    BaseOf(p)))],
            [
                new(SeriesKind.Before, texts["Verify.LargestBefore"], [.. series.Select(p => (double?)p.Result.MaxBeforeMm)])
                {
                    Beginnings = breaks
                },
                new(SeriesKind.After, texts["Verify.LargestAfter"], [.. series.Select(p => (double?)p.Result.MaxAfterMm)]),
                new(SeriesKind.BeforeMean, texts["Verify.RmsBefore"], [.. series.Select(p => (double?)p.Result.RmsBeforeMm)])
                {
                    Beginnings = breaks
                },
                new(SeriesKind.AfterMean, texts["Verify.RmsAfter"], [.. series.Select(p => (double?)p.Result.RmsAfterMm)]),
            ],
            [],
            [.. series.Select(p => !p.IsMeasured)],
            IsMagnitude: true);
    }

    // Angles have as many decimals as lengths, so that they align.
    private ImprovementRow Row(VerifiedFeature f)
    {
        // Compares the displayed values: a difference that rounds to zero counts as none.
        var known = _piece.TellsImprovement ? f.ImprovementPercent : null;
        var isWorse = known is { } percent && Math.Round(percent) < 0;
        var improvement = isWorse ? Texts.Current.With("Verify.WorseBy", Shown.Percent(-known)) : Shown.Percent(known);
        var (quantity, unit) = (Texts.Current["VerifiedQuantity." + f.Quantity.Word], f.Quantity.Unit);
        if (!f.Quantity.IsDeviation)
        {
            return new(f.Name, quantity, Shown.Mm(f.Wanted), Shown.Mm(f.Before), Shown.Mm(f.After), improvement, unit, isWorse);
        }

        // The points of a feature are known; a comparison lists its own.
        var isComparison = f.Points.Count > 0 && _piece.Result.Boundaries.All(b => b.Name != f.Name);
        return new(
            f.Name, isComparison ? Texts.Current.With("Verify.OfPoints", quantity, LabelList.Short(f.Points)) : quantity, Shown.Nothing,
            Deviation(f, f.Before, p => p.BeforeError, _ => null),
            Deviation(f, f.After, p => p.AfterError, _piece.Interval95Mm), improvement, unit, isWorse);
    }

    // With its sign and its interval, if the report names the point.
    private string Deviation(
        VerifiedFeature f, double largestMm, Func<VerifiedPoint, MatingError> error, Func<string, double?> interval95Mm)
    {
        var worst = _piece.Result.Points.Where(p => f.Points.Contains(p.Label)).MaxBy(p => Math.Abs(Of(p)));
        return worst is null ? Shown.Mm(largestMm) : Shown.SignedMm(Of(worst), interval95Mm(worst.Label));

        double Of(VerifiedPoint p) => f.Quantity == VerifiedQuantity.DeviationX ? error(p).Vector.X : error(p).NormalMm;
    }

    private MatingErrorRow Row(VerifiedPoint p)
    {
        var band = _piece.Result.BandOf(p.Label);
        var isOutside = _piece.Result.IsOutside(p.Label, p.AfterError.NormalMm);
        return new(
            p.Label,
            _features.GetValueOrDefault(p.Label, ""),
            Shown.SignedMm(band?.LowerMm),
            Shown.SignedMm(band?.UpperMm),
            Shown.SignedMm(p.BeforeError.NormalMm),
            Shown.SignedMm(p.AfterError.NormalMm, _piece.Interval95Mm(p.Label)),
            Texts.Current[isOutside ? "Verify.PointOutside" : "Verify.PointWithin"], isOutside);
    }
}

/// <summary>A key point in a table of mating errors; lengths in mm along the normal.</summary>
/// <param name="Point">Its label.</param>
/// <param name="Feature">Its feature.</param>
/// <param name="Low">The lower limit of the error.</param>
/// <param name="High">The upper limit of the error.</param>
/// <param name="Before">The error without compensation.</param>
/// <param name="After">The error with compensation.</param>
/// <param name="Verdict">Whether it is within its limits, in a word.</param>
/// <param name="IsOutside">True if it is outside its limits.</param>
internal sealed record MatingErrorRow(
    string Point, string Feature, string Low, string High, string Before, string After, string Verdict, bool IsOutside);

/// <summary>A quantity of a feature, without and with compensation.</summary>
/// <param name="Feature">Its feature or comparison.</param>
/// <param name="Quantity">The compared quantity, with the points of a comparison.</param>
/// <param name="Wanted">The part's value; a dash for deviations, which are relative to the part.</param>
/// <param name="Before">The value of the counterpart without compensation. A deviation is the worst point's, counterpart - part.</param>
/// <param name="After">The value of the counterpart with compensation, likewise.</param>
/// <param name="Improvement">Reduction of the error in percent of the error before, or a text that it has grown and by how much.</param>
/// <param name="Unit">mm or degrees.</param>
/// <param name="IsWorse">True if the error has grown.</param>
internal sealed record ImprovementRow(
    string Feature, string Quantity, string Wanted, string Before, string After, string Improvement, string Unit, bool IsWorse);
