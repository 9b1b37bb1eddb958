using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>A kept report of a surface in the words, figures and drawings of the screen.</summary>
public sealed class SurfaceFigures
{
    private readonly KeptSurface _kept;

    /// <summary>Puts it into words.</summary>
    public SurfaceFigures(KeptSurface kept)
    {
        _kept = kept ?? throw new ArgumentNullException(nameof(kept));
        LimitMm = Rounded(kept.Points.Select(p => Math.Abs(p.ErrorMm)).Concat(kept.Map.BeforeMm.Select(Math.Abs)).DefaultIfEmpty().Max());
        Measured = Map(kept.Map.BeforeMm, p => p.ErrorMm, "Freeform.AtMeasured");
        Mirror = Map(kept.Map.MirrorMm, p => p.MirrorMm, "Freeform.AtMirror");
        ToolRadius = Map(kept.Map.ToolRadiusMm, p => p.ToolRadiusMm, "Freeform.AtToolRadius");
        Plan = new(kept.Map.Net, null, LimitMm, [.. kept.Points.Select(p => (Shown.Id(p.Number), Above(p.Nominal), PlanText(p.Number, p.Nominal)))], ShowsWay: true);
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

    /// <summary>The error as measured.</summary>
    public SurfaceDrawing Measured { get; }

    /// <summary>What mirroring is expected to leave.</summary>
    public SurfaceDrawing Mirror { get; }

    /// <summary>What a modified tool radius is expected to leave.</summary>
    public SurfaceDrawing ToolRadius { get; }

    /// <summary>What the way of compensating that was chosen is expected to leave.</summary>
    public SurfaceDrawing Expected => _kept.IsMirror ? Mirror : ToolRadius;

    /// <summary>Where it was touched, in which order.</summary>
    public SurfaceDrawing Plan { get; }

    /// <summary>How many points the plan has.</summary>
    public string PlanCaption => Texts.Current.With("Freeform.PlanMeasured", Shown.Count(_kept.Points.Count));

    /// <summary>The error at each point, as measured and as expected.</summary>
    public SeriesDrawing Errors { get; }

    /// <summary>What the errors come to, as measured and as expected by either way.</summary>
    public IReadOnlyList<StatisticsRow> Statistics { get; }

    /// <summary>Standard deviation and profile, before and expected.</summary>
    public string Summary => Texts.Current.With(
        "Freeform.Summary", Shown.Micrometers(_kept.Before.StandardDeviationMm), Shown.Micrometers(_kept.Expected.StandardDeviationMm), Shown.Micrometers(_kept.Before.ProfileIsoMm), Shown.Micrometers(_kept.Expected.ProfileIsoMm));

    /// <summary>How it is compensated, by how much, and after which stage it was measured.</summary>
    public string How => Texts.Current.With(
        _kept.IsMirror ? "Freeform.HowMirror" : "Freeform.HowToolRadius", Shown.Mm(_kept.LargestMoveMm), Shown.Number(_kept.Gain), Texts.Current[_kept.IsFinished ? "Freeform.Finishing" : "Freeform.SemiFinishing"]);

    /// <summary>How far the expected error can be trusted.</summary>
    public string Trust => Texts.Current.With("Freeform.Trust", Shown.Micrometers(_kept.PointUncertaintyMm), Texts.Current[_kept.IsSystematic switch { true => "Freeform.Systematic", false => "Freeform.Noise", null => "Freeform.Undetermined" }]);

    /// <summary>What is above the map of mirroring.</summary>
    public string MirrorCaption => Caption("Freeform.ExpectedMirror", _kept.Mirror, _kept.IsMirror);

    /// <summary>What is above the map of a modified tool radius.</summary>
    public string ToolRadiusCaption => Caption("Freeform.ExpectedToolRadius", _kept.ToolRadius, !_kept.IsMirror);

    /// <summary>What the way of compensating that was chosen is called.</summary>
    public string ExpectedName => Texts.Current[_kept.IsMirror ? "Freeform.ExpectedMirror" : "Freeform.ExpectedToolRadius"];

    /// <summary>What is above the map as measured.</summary>
    public string MeasuredCaption => Caption("Freeform.Measured", _kept.Before, isChosen: false);

    /// <summary>What is above the map of what is expected.</summary>
    public string ExpectedCaption => _kept.IsMirror ? MirrorCaption : ToolRadiusCaption;

    /// <summary>What was proved about the program, in a sentence or two.</summary>
    public string Proof => (_kept.Proof, _kept.ToolPath) switch
    {
        ({ } proof, _) => Texts.Current.With(proof.Holds ? "Head.Proved" : "Head.NotProved", Shown.Count(proof.Motions), Shown.Count(proof.MovedMotions), Shown.Mm(proof.MaxDeviationFromWantedMm)),
        (_, { } path) => Sentence.Joined(
            Texts.Current.With("Freeform.Path", Shown.Count(path.Passes), Shown.Count(path.Points), Shown.Count((long)Math.Round(path.LengthMm)), Shown.Micrometers(path.ChordMm), Shown.Micrometers(path.ScallopMm)),
            path.RaisedPoints == 0 ? Texts.Current.With("Freeform.NoGouge", Shown.Micrometers(path.GougeMm)) : Texts.Current.With("Freeform.Raised", Shown.Count(path.RaisedPoints), Shown.Micrometers(path.RaisedMm))),
        _ => "",
    };

    /// <summary>A proof that does not hold is an alarm, material that is left asks for attention.</summary>
    public Severity ProofSeverity => _kept.Proof is { Holds: false } ? Severity.Alarm : _kept.ToolPath is { RaisedPoints: > 0 } ? Severity.Attention : Severity.Quiet;

    /// <summary>What a person should know before using the program.</summary>
    public IReadOnlyList<string> Warnings => _kept.Warnings;

    /// <summary>True if there are warnings.</summary>
    public bool HasWarnings => Warnings.Count > 0;

    /// <summary>What is told under the finger of a point of a plan.</summary>
    internal static string PlanText(int number, Point3 at) => Texts.Current.With("Freeform.AtPlan", Shown.Id(number), Shown.Mm(at.X), Shown.Mm(at.Y), Shown.Mm(at.Z));

    /// <summary>A place seen from above.</summary>
    internal static Point2 Above(Point3 at) => new(at.X, at.Y);

    // A round limit that is not much larger than what is shown: a tenth of it is 1, 2 or 5 times a power of ten.
    private static double Rounded(double limitMm)
    {
        var limit = Math.Max(limitMm, 1e-4);
        var step = RoundNumber.AtLeast(limit / 10);
        return Math.Ceiling(limit / step) * step;
    }

    private SurfaceDrawing Map(IReadOnlyList<double> valuesMm, Func<KeptSurfacePoint, double> valueMm, string text) => new(
        _kept.Map.Net, valuesMm, LimitMm, [.. _kept.Points.Select(p => (Shown.ShortMicrometers(valueMm(p)), Above(p.Nominal), Texts.Current.With(text, Shown.Id(p.Number), Shown.SignedMicrometers(valueMm(p)))))], ShowsWay: false);

    private SeriesDrawing ErrorsOf()
    {
        var texts = Texts.Current;
        Func<KeptSurfacePoint, double> expected = _kept.IsMirror ? p => p.MirrorMm : p => p.ToolRadiusMm;
        return new(
            [.. _kept.Points.Select(p => Shown.Id(p.Number))],
            [.. _kept.Points.Select(p => texts.With("Freeform.AtError", Shown.Id(p.Number), Shown.SignedMicrometers(p.ErrorMm), Shown.SignedMicrometers(expected(p))))],
            [
                new(SeriesKind.Before, texts["Freeform.Measured"], [.. _kept.Points.Select(p => (double?)(1000 * p.ErrorMm))]),
                new(SeriesKind.After, texts[_kept.IsMirror ? "Freeform.ExpectedMirror" : "Freeform.ExpectedToolRadius"], [.. _kept.Points.Select(p => (double?)(1000 * expected(p)))]),
            ],
            [],
            [],
            Unit: "µm");
    }

    private static string Caption(string name, DeviationStatistics statistics, bool isChosen) =>
        Texts.Current.With(isChosen ? "Freeform.CaptionChosen" : "Freeform.Caption", Texts.Current[name], Shown.Micrometers(statistics.StandardDeviationMm), Shown.Micrometers(statistics.ProfileIsoMm));

    private static StatisticsRow Row(string name, DeviationStatistics s, bool isChosen) => new(
        isChosen ? Texts.Current.With("Freeform.Chosen", Texts.Current[name]) : Texts.Current[name],
        Shown.Count(s.Count), Shown.SignedMicrometers(s.MeanMm), Shown.Micrometers(s.StandardDeviationMm), Shown.Micrometers(s.ProfileIsoMm), Shown.Micrometers(s.ProfileRangeMm), isChosen);
}
