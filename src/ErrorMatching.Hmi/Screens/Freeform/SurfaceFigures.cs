using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>A stored surface report, formatted for display, with its drawings.</summary>
internal sealed class SurfaceFigures
{
    private readonly StoredSurface _stored;
    private readonly SurfaceFindings _findings;

    /// <summary>Formats the report.</summary>
    /// <param name="stored">The report.</param>
    /// <param name="isToBeCut">True if cutting is still a question.</param>
    public SurfaceFigures(StoredSurface stored, bool isToBeCut)
    {
        _stored = stored ?? throw new ArgumentNullException(nameof(stored));
        _findings = stored.Findings;
        Verdict = SurfaceVerdictText.Of(_findings, isToBeCut && stored.CallsTool != false);
        var map = _findings.Map;
        LimitMm = Rounded(_findings.Samples.Select(s => Math.Abs(s.ErrorMm)).Concat(map.BeforeMm.Select(Math.Abs)).DefaultIfEmpty().Max());
        Measured = Map(map.BeforeMm, [.. _findings.Samples.Select(s => s.ErrorMm)], "Freeform.AtMeasured");
        Mirror = Map(map.MirrorMm, _findings.Mirror.Errors, "Freeform.AtMirror");
        ToolRadius = Map(map.ToolRadiusMm, _findings.ToolRadius.Errors, "Freeform.AtToolRadius");
        Plan = new(
            map.Net,
            null,
            LimitMm,
            [.. _findings.Samples.Select(s => (Shown.Id(s.Point), Above(s.Nominal), PlanText(s.Point, s.Nominal)))],
            ShowsWay: true);
        Errors = ErrorsOf();
        Statistics =
        [
            Row("Freeform.Measured", _findings.Before, isChosen: false),
            Row("Freeform.ExpectedMirror", _findings.Mirror.Statistics, _findings.IsMirror),
            Row("Freeform.ExpectedToolRadius", _findings.ToolRadius.Statistics, !_findings.IsMirror),
        ];
    }

    /// <summary>The verdict by the job's profile tolerance: what a user decides by.</summary>
    public string Verdict { get; }

    /// <summary>The verdict on the piece as it was measured; null if it still had its stock, or the job states no tolerance.</summary>
    public string? Piece => _findings.Stage == CuttingStage.Finishing ? SurfaceVerdictText.OfPiece(_findings.Verdict) : null;

    public Severity PieceSeverity => SurfaceVerdictText.SeverityOfPiece(_findings.Verdict);

    /// <summary>True if the finished piece is in tolerance.</summary>
    public bool IsPieceWithin => _findings.Verdict?.Before.IsWithin == true;

    /// <summary>The tolerance and how it is applied; null if the job states none.</summary>
    public string? Tolerance => SurfaceVerdictText.OfTolerance(_findings.Verdict);

    /// <summary>True if the job states a tolerance.</summary>
    public bool IsJudged => _findings.Verdict is not null;

    public Severity VerdictSeverity => SurfaceVerdictText.SeverityOf(_findings.Verdict);

    /// <summary>True if the surface is expected in tolerance; false if the job states none.</summary>
    public bool IsWithin => _findings.Verdict?.Predicted.IsWithin == true;

    /// <summary>The absolute value of the last colors of all maps, in mm.</summary>
    public double LimitMm { get; }

    /// <summary>How far the limits of the job's tolerance are from zero, in mm; 0 if it states none.</summary>
    public double ToleranceMm => _findings.Verdict?.Tolerance.Limits.UpperMm ?? 0;

    /// <summary>The measured error.</summary>
    public SurfaceDrawing Measured { get; }

    /// <summary>The measured error in space, exaggerated.</summary>
    public SurfaceSolid Solid => field ??= new(Measured);

    /// <summary>How much it is exaggerated.</summary>
    public string SolidCaption => Texts.Current.With("Freeform.SolidCaption", Shown.Count((long)Solid.Factor));

    /// <summary>Error expected to remain after mirroring.</summary>
    public SurfaceDrawing Mirror { get; }

    /// <summary>Error expected to remain with a modified tool radius.</summary>
    public SurfaceDrawing ToolRadius { get; }

    /// <summary>Error expected to remain after the chosen compensation.</summary>
    public SurfaceDrawing Expected => _findings.IsMirror ? Mirror : ToolRadius;

    /// <summary>Where it was probed, and in which order.</summary>
    public SurfaceDrawing Plan { get; }

    /// <summary>Number of points of the plan.</summary>
    public string PlanCaption => Texts.Current.With("Freeform.PlanMeasured", Shown.Count(_findings.Samples.Count));

    /// <summary>The error at each point, measured and expected.</summary>
    public SeriesDrawing Errors { get; }

    /// <summary>Statistics of the errors, measured and expected for either way.</summary>
    public IReadOnlyList<StatisticsRow> Statistics { get; }

    /// <summary>Standard deviation and profile, before and expected.</summary>
    public string Summary => Texts.Current.With(
        "Freeform.Summary",
        Shown.Micrometers(_findings.Before.StandardDeviationMm),
        Shown.Micrometers(_findings.Predicted.Statistics.StandardDeviationMm),
        Shown.Micrometers(_findings.Before.ProfileIsoMm),
        Shown.Micrometers(_findings.Predicted.Statistics.ProfileIsoMm));

    /// <summary>How and by how much it is compensated, and after which stage it was measured.</summary>
    public string How => Texts.Current.With(
        _findings.IsMirror ? "Freeform.HowMirror" : "Freeform.HowToolRadius",
        Shown.Mm(_findings.LargestMoveMm),
        Shown.Number(_findings.Gain),
        Texts.Current[_findings.Stage == CuttingStage.Finishing ? "Freeform.Finishing" : "Freeform.SemiFinishing"]);

    /// <summary>How reliable the expected error is.</summary>
    public string Trust => Texts.Current.With(
        "Freeform.Trust",
        Shown.Micrometers(_findings.Mirror.PointUncertaintyMm),
        Texts.Current[
            _findings.Structure.Verdict switch
            {
                SpatialVerdict.Systematic => "Freeform.Systematic",
                SpatialVerdict.Noise => "Freeform.Noise",
                _ => "Freeform.Undetermined",
            }]);

    /// <summary>Caption of the map for mirroring.</summary>
    public string MirrorCaption => Caption("Freeform.ExpectedMirror", _findings.Mirror.Statistics, _findings.IsMirror);

    /// <summary>Caption of the map for a modified tool radius.</summary>
    public string ToolRadiusCaption => Caption("Freeform.ExpectedToolRadius", _findings.ToolRadius.Statistics, !_findings.IsMirror);

    /// <summary>Caption of the map of the measured error.</summary>
    public string MeasuredCaption => Caption("Freeform.Measured", _findings.Before, isChosen: false);

    /// <summary>Caption of the map of the expected error.</summary>
    public string ExpectedCaption => _findings.IsMirror ? MirrorCaption : ToolRadiusCaption;

    /// <summary>What was proved about the program, in one or two sentences.</summary>
    public string Proof => (_stored.Proof, _stored.ToolPath) switch
    {
        ({ } proof, _) => Texts.Current.With(
            proof.Holds ? "Head.Proved" : "Head.NotProved",
            Shown.Count(proof.Motions),
            Shown.Count(proof.MovedMotions),
            Shown.Mm(proof.MaxDeviationFromWantedMm)),
        (_, { } path) => Sentence.Joined(
            Texts.Current.With(
                "Freeform.Path",
                Shown.Count(path.Passes),
                Shown.Count(path.Points),
                Shown.Count((long)Math.Round(path.LengthMm)),
                Shown.Micrometers(path.ChordMm),
                Shown.Micrometers(path.ScallopMm)),
            path.RaisedPoints == 0
                ? Texts.Current.With("Freeform.NoGouge", Shown.Micrometers(path.GougeMm))
                : Texts.Current.With("Freeform.Raised", Shown.Count(path.RaisedPoints), Shown.Micrometers(path.RaisedMm))),
        _ => "",
    };

    /// <summary>A failed proof is an alarm; material left over needs attention.</summary>
    public Severity ProofSeverity =>
        _stored.Proof is { Holds: false } ? Severity.Alarm
        : _stored.ToolPath is { RaisedPoints: > 0 } ? Severity.Attention
        : Severity.Quiet;

    /// <summary>What the user should know before using the program.</summary>
    public IReadOnlyList<string> Warnings => [.. _stored.Warnings.Select(WarningText.Of)];

    public bool HasWarnings => Warnings.Count > 0;

    /// <summary>The text shown on tapping a point of a plan.</summary>
    internal static string PlanText(int number, Point3 at) =>
        Texts.Current.With("Freeform.AtPlan", Shown.Id(number), Shown.Mm(at.X), Shown.Mm(at.Y), Shown.Mm(at.Z));

    /// <summary>A position seen from above.</summary>
    internal static Point2 Above(Point3 at) => new(at.X, at.Y);

    // A round limit slightly above the largest value: a tenth of it is 1, 2 or 5 times a power of ten.
    private static double Rounded(double limitMm)
    {
        var limit = Math.Max(limitMm, 1e-4);
        var step = RoundNumber.AtLeast(limit / 10);
        return Math.Ceiling(limit / step) * step;
    }

    private SurfaceDrawing Map(IReadOnlyList<double> valuesMm, IReadOnlyList<double> atPointsMm, string text) => new(
        _findings.Map.Net,
        valuesMm,
        LimitMm,
        [
            .. _findings.Samples.Zip(atPointsMm, (s, mm) => (
                Shown.ShortMicrometers(mm),
                Above(s.Nominal),
                Texts.Current.With(text, Shown.Id(s.Point), Shown.SignedMicrometers(mm))))],
        ShowsWay: false);

    private SeriesDrawing ErrorsOf()
    {
        var (texts, samples, expected) = (Texts.Current, _findings.Samples, _findings.Predicted.Errors);
        return new(
            [.. samples.Select(s => Shown.Id(s.Point))],
            [
                .. samples.Zip(expected, (s, mm) => texts.With(
                    "Freeform.AtError", Shown.Id(s.Point), Shown.SignedMicrometers(s.ErrorMm), Shown.SignedMicrometers(mm)))],
            [
                new(SeriesKind.Before, texts["Freeform.Measured"], [.. samples.Select(s => (double?)(1000 * s.ErrorMm))]),
                new(
                    SeriesKind.After,
                    texts[_findings.IsMirror ? "Freeform.ExpectedMirror" : "Freeform.ExpectedToolRadius"],
                    [.. expected.Select(mm => (double?)(1000 * mm))]),
            ],
            [],
            [],
            Unit: "µm");
    }

    private static string Caption(string name, DeviationStatistics statistics, bool isChosen) =>
        Texts.Current.With(
            isChosen ? "Freeform.CaptionChosen" : "Freeform.Caption",
            Texts.Current[name],
            Shown.Micrometers(statistics.StandardDeviationMm),
            Shown.Micrometers(statistics.ProfileIsoMm));

    private static StatisticsRow Row(string name, DeviationStatistics s, bool isChosen) => new(
        isChosen ? Texts.Current.With("Freeform.Chosen", Texts.Current[name]) : Texts.Current[name],
        Shown.Count(s.Count),
        Shown.SignedMicrometers(s.MeanMm),
        Shown.Micrometers(s.StandardDeviationMm),
        Shown.Micrometers(s.ProfileIsoMm),
        Shown.Micrometers(s.ProfileRangeMm),
        isChosen);
}

/// <summary>Statistics of surface errors; lengths in µm.</summary>
/// <param name="Name">Name of the errors.</param>
/// <param name="Count">Number of points.</param>
/// <param name="Mean">Mean with its sign.</param>
/// <param name="Deviation">Standard deviation.</param>
/// <param name="Profile">Profile of a surface by ISO 1101.</param>
/// <param name="Range">Largest minus smallest.</param>
/// <param name="IsChosen">True for the chosen way of compensation.</param>
internal sealed record StatisticsRow(string Name, string Count, string Mean, string Deviation, string Profile, string Range, bool IsChosen);
