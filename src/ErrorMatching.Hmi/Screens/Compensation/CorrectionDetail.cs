using ErrorMatching.Cell;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi;

/// <summary>One correction with all that is known of it, in the words and figures of the screen.</summary>
public sealed class CorrectionDetail
{
    private readonly TimeProvider _clock;
    private readonly KeptPiece? _piece;

    /// <summary>Puts it into words. This takes its time, and may be done beside the screen.</summary>
    public CorrectionDetail(KeptCorrection kept, TimeProvider clock)
    {
        Kept = kept ?? throw new ArgumentNullException(nameof(kept));
        _clock = clock;
        var report = kept.Report;
        Quantities = [.. report?.Features.SelectMany(f => f.Quantities.Select(q => Row(f, q))) ?? []];
        Decisions = [.. report?.Features.Select(f => Row(report, f)) ?? []];
        Steps = [.. Enumerable.Reverse(kept.Steps).Select(s => new StepRow(Shown.Time(s.At, clock), Texts.Current.Word(s.To), RecordedText.Who(s.By), BasisOf(s)))];
        if (report is not null)
        {
            _piece = KeptPiece.Predicted(kept.Correction, report);
            Points = [.. report.Points.Zip(_piece.Result.Points, Row)];
            (Before, After) = (GapDrawing.Before(_piece), GapDrawing.After(_piece));
        }

        Surface = kept.Surface is { } surface ? new(surface) : null;
    }

    /// <summary>What the store keeps of it.</summary>
    public KeptCorrection Kept { get; }

    /// <summary>The language of its words.</summary>
    public Language Language { get; } = Texts.Current.Language;

    /// <summary>The same in the language of the screen, which may have changed while this was put into words.</summary>
    public CorrectionDetail Now() => Language == Texts.Current.Language ? this : new(Kept, _clock) { IsOfChangedJob = IsOfChangedJob };

    /// <summary>True if it waits, and was made with its job as it was before somebody changed that.</summary>
    public bool IsOfChangedJob { get; init; }

    /// <summary>True if somebody came to read its warnings: they are what is seen first.</summary>
    public bool IsAtWarnings { get; internal set; }

    /// <summary>Number and serial number or file.</summary>
    public string Title => CorrectionLabel.Of(Kept.Correction);

    /// <summary>How far it has come, in a word.</summary>
    public string State => Texts.Current.Word(Kept.Correction.State);

    /// <summary>Why it came to that; null where there is no reason.</summary>
    public string? Reason => Kept.Correction.Code is { } code ? CodeText.Of(code, Kept.Correction.Reason) : null;

    /// <summary>What people call the job: the workpiece.</summary>
    public string? Job => Kept.JobName;

    /// <summary>Machine, slot and file of its program in a sentence; null where none goes to a machine.</summary>
    public string? Target => CorrectionLabel.Target(Kept.Correction);

    /// <summary>Work order, gauge and file in a line.</summary>
    public string Origin => string.Join(" · ", new[] { Kept.Correction.WorkOrder ?? Kept.Report?.WorkOrder, Kept.Correction.Gauge, Kept.Correction.FileName, Shown.Time(Kept.Correction.ArrivedAt, _clock) }.Where(t => !string.IsNullOrEmpty(t)));

    /// <summary>By how much the program moves at most, and where; null before it is computed.</summary>
    public string? Largest => Kept.Correction.LargestMm is not > 0 ? null : (Kept.TriedAt is { } at ? KeptMove.PlaceOf(at) : KeptMove.PlaceOf(Kept.Steps)) is { } place
        ? Texts.Current.With("Head.LargestAt", Shown.Mm(Kept.Correction.LargestMm), place)
        : Texts.Current.With("Head.Largest", Shown.Mm(Kept.Correction.LargestMm));

    /// <summary>What is predicted to be left over, at most, and which points will be outside of their limits; null where nothing is predicted.</summary>
    public string? LeftOver
    {
        get
        {
            if (_piece is null)
            {
                return null;
            }

            var worst = _piece.Result.Points.MaxBy(p => Math.Abs(p.AfterError.NormalMm))!;
            var most = Texts.Current.With("Head.LeftOver", Shown.Mm(Math.Abs(worst.AfterError.NormalMm)), worst.Label);
            var (outside, pushed) = (_piece.Outside, _piece.PushedOut);
            return most + (outside.Count == 0 ? Texts.Current["Head.NoneOutside"]
                : pushed.Count == outside.Count ? Texts.Current.With("Head.AllPushedOut", Texts.Current.Listed(pushed))
                : Texts.Current.Counted("Head.Outside", outside.Count, outside.Count, Texts.Current.Listed(outside)) + (pushed.Count > 0 ? Texts.Current.With("Head.PushedOut", Texts.Current.Listed(pushed)) : ""));
        }
    }

    /// <summary>A point that will be outside of its limits asks for attention.</summary>
    public Severity LeftOverSeverity => IsWithin ? Severity.Quiet : Severity.Attention;

    /// <summary>True unless a point will be outside of its limits.</summary>
    public bool IsWithin => _piece?.IsWithin ?? true;

    /// <summary>What the program does not have and the machine needs, in words; null if nothing.</summary>
    public string? Missing => Kept.Missing;

    /// <summary>The key points.</summary>
    public IReadOnlyList<PointRow> Points { get; } = [];

    /// <summary>What the errors in <see cref="Points"/> mean.</summary>
    public string PointsNote => Texts.Current[_piece?.IsBeforeMeasured == true ? "Detail.PointsNoteMeasured" : "Detail.PointsNote"];

    /// <summary>Lengths and angles.</summary>
    public IReadOnlyList<QuantityRow> Quantities { get; }

    /// <summary>What was decided.</summary>
    public IReadOnlyList<DecisionRow> Decisions { get; }

    /// <summary>By which convention its deviations have their sign, with one of them as an example; empty where there is none.</summary>
    public string DecisionsNote => Kept.Report?.Features.MaxBy(f => Math.Abs(f.LargestMm)) is { } example ? Texts.Current.With("Detail.DecisionsNote", Shown.SignedMm(example.LargestMm), Shown.SignedMm(-example.LargestMm)) : "";

    /// <summary>What became of it, the latest first.</summary>
    public IReadOnlyList<StepRow> Steps { get; }

    /// <summary>True if it has come to where it is step by step: what was only tried has not.</summary>
    public bool HasCourse => Steps.Count > 0;

    /// <summary>The two programs; null where there are none, or one was made anew, as only a surface's is.</summary>
    public ProgramLines? Lines => IsSurface && Kept.Correction.BaseSha256 is null ? null : Kept.Lines;

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

    /// <summary>How much deviations are exaggerated, and whether the drawing is turned.</summary>
    public string Exaggeration => Before?.Note ?? "";

    /// <summary>True unless a proof does not hold.</summary>
    public bool IsProved => ProofSeverity != Severity.Alarm;

    /// <summary>A proof that does not hold is an alarm.</summary>
    public Severity ProofSeverity => Surface?.ProofSeverity ?? (Kept.Report is { Proof.Holds: true } ? Severity.Quiet : Severity.Alarm);

    /// <summary>What was proved, in a sentence or two.</summary>
    public string Proof => Kept.Report is not { Proof: var proof } ? Surface?.Proof ?? "" : Texts.Current.With(
        proof.Holds ? "Head.Proved" : "Head.NotProved", Shown.Count(proof.Motions), Shown.Count(proof.MovedMotions), Shown.Mm(proof.MaxDeviationFromWantedMm));

    /// <summary>How much of the program differs.</summary>
    public string Changed => Kept.Report is not { } report ? "" : Texts.Current.With("Detail.Changed", Shown.Count(report.ChangedBlocks));

    /// <summary>What a person should know before using the program.</summary>
    public IReadOnlyList<string> Warnings => [.. Kept.Report?.Warnings.Select(w => w.Text) ?? Surface?.Warnings ?? []];

    /// <summary>True if there are warnings.</summary>
    public bool HasWarnings => Warnings.Count > 0;

    /// <summary>How many there are, and where.</summary>
    public string WarningCount => Texts.Current.With("Head.Warnings", Warnings.Count);

    /// <summary>What is signed for where this is approved: how far the program moves, what is left over, and whatever is not as it should be.</summary>
    public IReadOnlyList<Fact> Facts => [.. new[]
    {
        HasProof && !IsProved ? new Fact(Proof, ProofSeverity) : null,
        Largest is { } largest ? new(largest, Severity.Quiet) : null,
        LeftOver is { } left ? new(left, LeftOverSeverity) : null,
        Missing is { } missing ? new(missing, Severity.Attention) : null,
        IsOfChangedJob ? new(Texts.Current["Head.ChangedJob"], Severity.Attention) : null,
        HasWarnings ? new(WarningCount, Severity.Attention) : null,
    }.OfType<Fact>()];

    // Its warnings stand in the record of the step as well; they are read where they are told, and counted here.
    private string BasisOf(CorrectionStep step)
    {
        string[] recorded = [.. Kept.Report?.Warnings.Select(w => w.Message) ?? Kept.Surface?.Warnings ?? []];
        var told = recorded.Where(w => step.Basis.Contains(" " + w, StringComparison.Ordinal)).ToArray();
        var basis = RecordedText.Of(told.Aggregate(step.Basis, (b, w) => b.Replace(" " + w, "", StringComparison.Ordinal)), Kept.Correction);
        return told.Length == 0 ? basis : Sentence.Joined(basis, Texts.Current.With("Head.Warnings", told.Length));
    }

    // The errors are the piece's, as the verification has them: one convention for both screens.
    private PointRow Row(KeptPoint p, VerifiedPoint errors) => new(
        p.Point, p.Feature, Shown.Mm(p.Theoretical.X), Shown.Mm(p.Theoretical.Y), Shown.Mm(p.Actual.X), Shown.Mm(p.Actual.Y), Shown.SignedMm(p.Correction.X), Shown.SignedMm(p.Correction.Y),
        Shown.SignedMm(errors.BeforeError.NormalMm), Shown.SignedMm(errors.AfterError.NormalMm), _piece!.IsOutside(p.Point, errors.AfterError.NormalMm));

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
