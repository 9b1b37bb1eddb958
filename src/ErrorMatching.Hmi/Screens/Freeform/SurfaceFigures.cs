using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>A stored surface report, formatted for display, with its drawings.</summary>
public sealed class SurfaceFigures
{
    private readonly KeptSurface _kept;

    /// <summary>Formats the report.</summary>
    public SurfaceFigures(KeptSurface kept)
    {
        _kept = kept ?? throw new ArgumentNullException(nameof(kept));
        LimitMm = Rounded(kept.Points.Select(p => Math.Abs(p.ErrorMm)).Concat(kept.Map.BeforeMm.Select(Math.Abs)).DefaultIfEmpty().Max());
        Measured = Map(kept.Map.BeforeMm, p => p.ErrorMm, "Freeform.AtMeasured");
        Mirror = Map(kept.Map.MirrorMm, p => p.MirrorMm, "Freeform.AtMirror");
        ToolRadius = Map(kept.Map.ToolRadiusMm, p => p.ToolRadiusMm, "Freeform.AtToolRadius");
        Plan = new(
            kept.Map.Net,
            null,
            LimitMm,
            [.. kept.Points.Select(p => (Shown.Id(p.Number), Above(p.Nominal), PlanText(p.Number, p.Nominal)))],
            ShowsWay: true);
        Errors = ErrorsOf();
        Statistics =
        [
            Row("Freeform.Measured", kept.Before, isChosen: false),
            Row("Freeform.ExpectedMirror", kept.Mirror, kept.IsMirror),
            Row("Freeform.ExpectedToolRadius", kept.ToolRadius, !kept.IsMirror),
        ];
    }

    /// <summary>The absolute value of the last colors of all maps, in mm.</summary>
    public double LimitMm { get; }

    /// <summary>The measured error.</summary>
    public SurfaceDrawing Measured { get; }

    /// <summary>Error expected to remain after mirroring.</summary>
    public SurfaceDrawing Mirror { get; }

    /// <summary>Error expected to remain with a modified tool radius.</summary>
    public SurfaceDrawing ToolRadius { get; }

    /// <summary>Error expected to remain after the chosen compensation.</summary>
    public SurfaceDrawing Expected => _kept.IsMirror ? Mirror : ToolRadius;

    /// <summary>Where it was probed, and in which order.</summary>
    public SurfaceDrawing Plan { get; }

    /// <summary>Number of points of the plan.</summary>
    public string PlanCaption => Texts.Current.With("Freeform.PlanMeasured", Shown.Count(_kept.Points.Count));

    /// <summary>The error at each point, measured and expected.</summary>
    public SeriesDrawing Errors { get; }

    /// <summary>Statistics of the errors, measured and expected for either way.</summary>
    public IReadOnlyList<StatisticsRow> Statistics { get; }

    /// <summary>Standard deviation and profile, before and expected.</summary>
    public string Summary => Texts.Current.With(
        "Freeform.Summary",
        Shown.Micrometers(_kept.Before.StandardDeviationMm),
        Shown.Micrometers(_kept.Expected.StandardDeviationMm),
        Shown.Micrometers(_kept.Before.ProfileIsoMm),
        Shown.Micrometers(_kept.Expected.ProfileIsoMm));

    /// <summary>How and by how much it is compensated, and after which stage it was measured.</summary>
    public string How => Texts.Current.With(
        _kept.IsMirror ? "Freeform.HowMirror" : "Freeform.HowToolRadius",
        Shown.Mm(_kept.LargestMoveMm),
        Shown.Number(_kept.Gain),
        Texts.Current[_kept.IsFinished ? "Freeform.Finishing" : "Freeform.SemiFinishing"]);

    /// <summary>How reliable the expected error is.</summary>
    public string Trust => Texts.Current.With(
        "Freeform.Trust",
        Shown.Micrometers(_kept.PointUncertaintyMm),
        Texts.Current[
            _kept.IsSystematic switch { true => "Freeform.Systematic", false => "Freeform.Noise", null => "Freeform.Undetermined" }]);

    /// <summary>Caption of the map for mirroring.</summary>
    public string MirrorCaption => Caption("Freeform.ExpectedMirror", _kept.Mirror, _kept.IsMirror);

    /// <summary>Caption of the map for a modified tool radius.</summary>
    public string ToolRadiusCaption => Caption("Freeform.ExpectedToolRadius", _kept.ToolRadius, !_kept.IsMirror);

    /// <summary>Name of the chosen way of compensation.</summary>
    public string ExpectedName => Texts.Current[_kept.IsMirror ? "Freeform.ExpectedMirror" : "Freeform.ExpectedToolRadius"];

    /// <summary>Caption of the map of the measured error.</summary>
    public string MeasuredCaption => Caption("Freeform.Measured", _kept.Before, isChosen: false);

    /// <summary>Caption of the map of the expected error.</summary>
    public string ExpectedCaption => _kept.IsMirror ? MirrorCaption : ToolRadiusCaption;

    /// <summary>What was proved about the program, in one or two sentences.</summary>
    public string Proof => (_kept.Proof, _kept.ToolPath) switch
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
        _kept.Proof is { Holds: false } ? Severity.Alarm : _kept.ToolPath is { RaisedPoints: > 0 } ? Severity.Attention : Severity.Quiet;

    /// <summary>What the user should know before using the program.</summary>
    public IReadOnlyList<string> Warnings => _kept.Warnings;

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

    private SurfaceDrawing Map(IReadOnlyList<double> valuesMm, Func<KeptSurfacePoint, double> valueMm, string text) => new(
        _kept.Map.Net,
        valuesMm,
        LimitMm,
        [
            .. _kept.Points.Select(
                p => (
                    Shown.ShortMicrometers(valueMm(p)),
                    Above(p.Nominal),
                    Texts.Current.With(text, Shown.Id(p.Number), Shown.SignedMicrometers(valueMm(p)))))],
        ShowsWay: false);

    private SeriesDrawing ErrorsOf()
    {
        var texts = Texts.Current;
        Func<KeptSurfacePoint, double> expected = _kept.IsMirror ? p => p.MirrorMm : p => p.ToolRadiusMm;
        return new(
            [.. _kept.Points.Select(p => Shown.Id(p.Number))],
            [
                .. _kept.Points.Select(p => texts.With(
                    "Freeform.AtError", Shown.Id(p.Number), Shown.SignedMicrometers(p.ErrorMm), Shown.SignedMicrometers(expected(p))))],
            [
                new(SeriesKind.Before, texts["Freeform.Measured"], [.. _kept.Points.Select(p => (double?)(1000 * p.ErrorMm))]),
                new(
                    SeriesKind.After,
                    texts[_kept.IsMirror ? "Freeform.ExpectedMirror" : "Freeform.ExpectedToolRadius"],
                    [.. _kept.Points.Select(p => (double?)(1000 * expected(p)))]),
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
