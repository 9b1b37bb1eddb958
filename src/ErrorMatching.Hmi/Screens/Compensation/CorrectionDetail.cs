namespace ErrorMatching.Hmi;

/// <summary>One correction with all that is known of it, in the words and figures of the screen.</summary>
public sealed class CorrectionDetail
{
    private readonly TimeProvider _clock;

    /// <summary>Puts it into words.</summary>
    public CorrectionDetail(KeptCorrection kept, TimeProvider clock)
    {
        Kept = kept ?? throw new ArgumentNullException(nameof(kept));
        _clock = clock;
        var report = kept.Report;
        Points = [.. report?.Points.Select(Row) ?? []];
        Quantities = [.. report?.Features.SelectMany(f => f.Quantities.Select(q => Row(f, q))) ?? []];
        Decisions = [.. report?.Features.Select(f => Row(report, f)) ?? []];
        Steps = [.. kept.Steps.Select(s => new StepRow(Shown.Time(s.At, clock), Texts.Current.Word(s.To), s.By, s.Basis))];
        if (report is not null)
        {
            var piece = KeptPiece.Predicted(kept.Correction, report);
            (Before, After) = (GapDrawing.Before(piece), GapDrawing.After(piece));
        }

        Surface = kept.Surface is { } surface ? new(surface) : null;
    }

    /// <summary>What the store keeps of it.</summary>
    public KeptCorrection Kept { get; }

    /// <summary>Number and serial number or file.</summary>
    public string Title => CorrectionLabel.Of(Kept.Correction);

    /// <summary>How far it has come, in a word.</summary>
    public string State => Texts.Current.Word(Kept.Correction.State);

    /// <summary>Why it came to that; null where there is no reason.</summary>
    public string? Reason => Kept.Correction.Code is { } code ? CodeText.Of(code, Kept.Correction.Reason) : null;

    /// <summary>Job, work order, gauge and file in a line.</summary>
    public string Origin => string.Join(" · ", new[] { Kept.Report?.JobName ?? Kept.Surface?.JobName ?? Kept.Correction.Job, Kept.Correction.WorkOrder ?? Kept.Report?.WorkOrder, Kept.Correction.Gauge, Kept.Correction.FileName, Shown.Time(Kept.Correction.ArrivedAt, _clock) }.Where(t => !string.IsNullOrEmpty(t)));

    /// <summary>The largest displacement.</summary>
    public string Largest => Kept.Correction.LargestMm is { } mm ? Texts.Current.With("Detail.Largest", Shown.Mm(mm)) : "";

    /// <summary>The key points.</summary>
    public IReadOnlyList<PointRow> Points { get; }

    /// <summary>Lengths and angles.</summary>
    public IReadOnlyList<QuantityRow> Quantities { get; }

    /// <summary>What was decided.</summary>
    public IReadOnlyList<DecisionRow> Decisions { get; }

    /// <summary>What became of it.</summary>
    public IReadOnlyList<StepRow> Steps { get; }

    /// <summary>The two programs; null where there are none, or one was made anew.</summary>
    public ProgramLines? Lines => Kept.Correction.BaseSha256 is null ? null : Kept.Lines;

    /// <summary>True where two programs are shown, once they are there.</summary>
    public bool ShowsProgram => !IsSurface || Lines is not null;

    /// <summary>True if there is a report of a mating to show.</summary>
    public bool HasReport => Kept.Report is not null;

    /// <summary>The figures and drawings of a surface; null for a mating.</summary>
    public SurfaceFigures? Surface { get; }

    /// <summary>True for a surface.</summary>
    public bool IsSurface => Surface is not null;

    /// <summary>True if something was proved, or computed to be so.</summary>
    public bool HasProof => HasReport || IsSurface;

    /// <summary>The assembly before compensation.</summary>
    public GapDrawing? Before { get; }

    /// <summary>The assembly behind it.</summary>
    public GapDrawing? After { get; }

    /// <summary>The exaggeration and the largest gap before.</summary>
    public string BeforeCaption => Before is null ? "" : Texts.Current.With("Detail.GapBefore", Shown.Mm(Before.LargestMm));

    /// <summary>The largest gap that is predicted.</summary>
    public string AfterCaption => After is null ? "" : Texts.Current.With("Detail.GapAfter", Shown.Mm(After.LargestMm));

    /// <summary>How much deviations are exaggerated.</summary>
    public string Exaggeration => Before is null ? "" : Before.Factor == 1 ? Texts.Current["Detail.TrueToScale"] : Texts.Current.With("Detail.Exaggerated", Shown.Count((long)Before.Factor));

    /// <summary>True unless a proof does not hold.</summary>
    public bool IsProved => ProofSeverity != Severity.Alarm;

    /// <summary>A proof that does not hold is an alarm.</summary>
    public Severity ProofSeverity => Surface?.ProofSeverity ?? (Kept.Report is { Proof.Holds: true } ? Severity.Quiet : Severity.Alarm);

    /// <summary>What was proved, in a sentence or two.</summary>
    public string Proof => Kept.Report is not { Proof: var proof } ? Surface?.Proof ?? "" : Texts.Current.With(
        proof.Holds ? "Detail.ProofHolds" : "Detail.ProofFails", Shown.Count(proof.Motions), Shown.Count(proof.MovedMotions), Shown.Mm(proof.MaxDeviationFromWantedMm));

    /// <summary>How much of the program differs.</summary>
    public string Changed => Kept.Report is not { } report ? "" : Texts.Current.With("Detail.Changed", Shown.Count(report.ChangedBlocks), Shown.Count(report.ChangedWords));

    /// <summary>What a person should know before using the program.</summary>
    public IReadOnlyList<string> Warnings => [.. Kept.Report?.Warnings.Select(w => w.Text) ?? []];

    /// <summary>True if there are warnings.</summary>
    public bool HasWarnings => Warnings.Count > 0;

    /// <summary>How many there are, and where.</summary>
    public string WarningCount => Texts.Current.With("Detail.Warnings", Warnings.Count);

    private static PointRow Row(KeptPoint p) => new(
        p.Point, p.Feature, Shown.Mm(p.Theoretical.X), Shown.Mm(p.Theoretical.Y), Shown.Mm(p.Actual.X), Shown.Mm(p.Actual.Y), Shown.SignedMm(p.Correction.X), Shown.SignedMm(p.Correction.Y), Shown.SignedMm(p.NormalMm), Shown.SignedMm(p.PredictedMm));

    private static QuantityRow Row(KeptFeature feature, KeptQuantity q)
    {
        Func<double?, string> number = q.IsAngle ? Shown.Degrees : Shown.Mm;
        return new(feature.Name, Texts.Current.Or("Quantity." + q.Name, q.Name), number(q.Theoretical), number(q.Actual), number(q.Corrected), q.IsAngle ? "°" : "mm");
    }

    private static DecisionRow Row(KeptReport report, KeptFeature feature)
    {
        var texts = Texts.Current;
        var outside = report.Points.Where(p => p.Feature == feature.Name && p.ExcessMm != 0).OrderByDescending(p => Math.Abs(p.ExcessMm)).ToArray();
        var beyond = outside is [var worst, ..] ? texts.With("Decision.Beyond", outside.Length, worst.Point, Shown.Mm(Math.Abs(worst.ExcessMm))) : texts["Decision.Outside"];
        var reason = feature.Decision switch
        {
            "within-tolerance" => texts.With("Decision.Within", Shown.SignedMm(feature.LowerMm), Shown.SignedMm(feature.UpperMm)),
            "not-significant" => texts.With("Decision.NotSignificant", beyond, Shown.Mm(feature.UncertaintyMm)),
            _ => texts.With(report.FollowsWhole ? "Decision.FollowsWhole" : "Decision.FollowsExcess", beyond),
        };
        return new($"{feature.Name} · {texts["Kind." + feature.Kind]}", texts["Decided." + feature.Decision], reason, Shown.SignedMm(feature.LargestMm));
    }
}
