using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>All details of one correction, formatted for display.</summary>
internal sealed class CorrectionDetail
{
    private readonly TimeProvider _clock;
    private readonly StoredPiece? _piece;
    private readonly MatchVerdict? _verdict;
    private Task<ProgramPicture?>? _picture;

    /// <summary>Formats the details. Slow; may run off the UI thread.</summary>
    public CorrectionDetail(StoredCorrection kept, TimeProvider clock)
    {
        Stored = kept ?? throw new ArgumentNullException(nameof(kept));
        _clock = clock;
        var report = kept.Report;
        Quantities = [.. report?.Features.SelectMany(f => f.Quantities.Select(q => Row(f, q))) ?? []];
        Decisions = [.. report?.Features.Select(f => Row(report, f)) ?? []];
        Steps = [
            .. Enumerable.Reverse(kept.Steps).Select(s => new StepRow(
                Shown.Time(s.At, clock), Texts.Current.Word(s.To), RecordedText.Who(s.By), BasisOf(s)))];
        if (report is not null)
        {
            (_piece, _verdict) = (StoredPiece.Predicted(kept.Correction, report), report.Verdict);
            Points = [.. report.KeyPoints.Zip(_piece.Result.Points, Row)];
            (Before, After) = (GapDrawing.Before(_piece), GapDrawing.After(_piece));
            Seat = GapDrawing.AtSeat(_piece, _verdict.Pair, MatchVerdictText.Farthest(_verdict)) ?? After;
            Counterparts = [.. report.KeyPoints.Where(p => p.InProgram is not null).Select(Row)];
        }

        Surface = kept.Surface is { } surface ? new(surface, kept.Correction.IsToBeCut) : null;
    }

    public StoredCorrection Stored { get; }

    /// <summary>The language of its texts.</summary>
    public Language Language { get; } = Texts.Current.Language;

    /// <summary>The same in the current display language, which may have changed while this was being formatted.</summary>
    public CorrectionDetail Now() => Language == Texts.Current.Language ? this : new(Stored, _clock) { IsOfChangedJob = IsOfChangedJob };

    /// <summary>True if it waits, and its job was changed after it was computed.</summary>
    public bool IsOfChangedJob { get; init; }

    /// <summary>True if the user opened it to read its warnings, which are then shown first.</summary>
    public bool IsAtWarnings { get; internal set; }

    /// <summary>Number and serial number or file.</summary>
    public string Title => CorrectionLabel.Of(Stored.Correction);

    public string State => Texts.Current.Word(Stored.Correction.State);

    /// <summary>The reason for that state; null if there is none.</summary>
    public string? Reason => Stored.Correction.Code is { } code ? CodeText.Of(code, Stored.Correction.Reason) : null;

    /// <summary>The workpiece's name.</summary>
    public string? Job => Stored.JobName;

    /// <summary>Machine, slot and file of its program in a sentence; null if none goes to a machine.</summary>
    public string? Target => CorrectionLabel.Target(Stored.Correction);

    /// <summary>Work order, gauge and file in one line.</summary>
    public string Origin => string.Join(
        " · ",
        new[]
        {
            Stored.Correction.WorkOrder ?? Stored.Report?.Job.WorkOrder,
            Stored.Correction.Gauge,
            Stored.Correction.FileName,
            Shown.Time(Stored.Correction.ArrivedAt, _clock)
        }.Where(t => !string.IsNullOrEmpty(t)));

    /// <summary>The largest displacement of the program and its place; null before it is computed.</summary>
    public string? Largest =>
        Stored.Correction.LargestMm is not > 0
            ? null
            : (Stored.TriedAt is { } at ? StoredMove.PlaceOf(at) : StoredMove.PlaceOf(Stored.Steps)) is { } place
        ? Texts.Current.With("Head.LargestAt", Shown.Mm(Stored.Correction.LargestMm), place)
        : Texts.Current.With("Head.Largest", Shown.Mm(Stored.Correction.LargestMm));

    /// <summary>The offset of the control that the program sets, its step and its total; null if the program is one that cuts.</summary>
    public string? Offset => Stored.Correction.Offset is { } offset ? RecordedText.Of(offset, Stored.Correction) : null;

    /// <summary>The verdict on the pair or the surface: what a user decides by; null without a prediction, and for a surface without a
    /// tolerance. Whether to cut is answered until the piece is cut or given up.</summary>
    public string? Verdict => _verdict is not null ? MatchVerdictText.Of(_verdict, Stored.Correction.IsToBeCut)
        : Surface is { IsJudged: true } surface ? surface.Verdict
        : null;

    public Severity VerdictSeverity =>
        _verdict is null ? Surface?.VerdictSeverity ?? Severity.Quiet : MatchVerdictText.SeverityOf(_verdict.Code);

    /// <summary>True if every place will be within its limits.</summary>
    public bool IsWithin => _verdict is null ? Surface?.IsWithin == true : _verdict.Code == VerdictCode.Within;

    /// <summary>The largest errors predicted to remain, the risk, and the points that compensation drives out of their limits; null without
    /// a prediction.</summary>
    public string? LeftOver => _verdict is null ? null : Sentence.Joined(
        MatchVerdictText.Worst(_verdict) ?? "",
        MatchVerdictText.Risk(Stored.Report!) ?? "",
        PairText.Head(_verdict.Pair, _verdict.AllLimits),
        _piece!.PushedOut is { Count: > 0 } pushed ? Texts.Current.With("Verify.PushedOut", Texts.Current.Listed(pushed)) : "");

    /// <summary>What the machine needs and the program lacks, in words; null if nothing.</summary>
    public string? Missing => Stored.Missing;

    public IReadOnlyList<PointRow> Points { get; } = [];

    /// <summary>Where the counterpart is to be cut; empty for a report of an earlier version.</summary>
    public IReadOnlyList<CounterpartRow> Counterparts { get; } = [];

    public bool HasCounterparts => Counterparts.Count > 0;

    /// <summary>What the errors in <see cref="Points"/> mean.</summary>
    public string PointsNote => Texts.Current[_piece?.IsBeforeMeasured == true ? "Detail.PointsNoteMeasured" : "Detail.PointsNote"];

    /// <summary>Lengths and angles.</summary>
    public IReadOnlyList<QuantityRow> Quantities { get; }

    public IReadOnlyList<DecisionRow> Decisions { get; }

    /// <summary>The sign convention of the deviations, with one of them as an example; empty if there are none.</summary>
    public string DecisionsNote =>
        Stored.Report?.Features.MaxBy(f => Math.Abs(f.LargestMm)) is { } example
            ? Texts.Current.With(
                IsFromCounterpart(Stored.Report) ? "Detail.DecisionsNoteMeasured" : "Detail.DecisionsNote",
                Shown.SignedMm(example.LargestMm),
                Shown.SignedMm(Stored.Report.PointsOf(example).MaxBy(p => Math.Abs(p.DecidedMm))?.UncompensatedMm))
            : "";

    /// <summary>Its history, latest first.</summary>
    public IReadOnlyList<StepRow> Steps { get; }

    /// <summary>True if it has a history: a trial run has none.</summary>
    public bool HasCourse => Steps.Count > 0;

    /// <summary>The two programs; null if there are none, or if the program was newly generated, as only a surface's can be.</summary>
    public ProgramLines? Lines => IsSurface && Stored.Correction.BaseSha256 is null ? null : Stored.Lines;

    /// <summary>The path of the new program, to be drawn beside its text; null where its control is not known, as of a surface. Slow, and
    /// read once.</summary>
    public Task<ProgramPicture?> PictureAsync() => _picture ??= Task.Run(() =>
    {
        try
        {
            return Lines is { } lines && Stored is { Report: not null, JobFile: { } file }
                ? new ProgramPicture(OpenedProgram.Read(lines.Modified, InputFile.DialectOf(new JobFiles(file).Job))) { IsReadOnly = true }
                : null;
        }
        catch (Exception e) when (e is InputException or ArgumentException)
        {
            // The job or its dialect was changed since: the text is shown without a path.
            return null;
        }
    });

    /// <summary>True if two programs are shown, once they exist.</summary>
    public bool ShowsProgram => !IsSurface || Lines is not null;

    /// <summary>True if there is a report of a mating.</summary>
    public bool HasReport => Stored.Report is not null;

    /// <summary>The results and drawings of a surface; null for a mating.</summary>
    public SurfaceFigures? Surface { get; }

    public bool IsSurface => Surface is not null;

    /// <summary>True if there is a proof, or a computed tool path.</summary>
    public bool HasProof => HasReport || IsSurface;

    /// <summary>The assembly without compensation.</summary>
    public GapDrawing? Before { get; }

    /// <summary>The assembly with compensation.</summary>
    public GapDrawing? After { get; }

    /// <summary>The pair at its seat; with compensation, as predicted, if no seat is known.</summary>
    public GapDrawing? Seat { get; }

    /// <summary>How the pair goes together, and what its picture shows.</summary>
    public string SeatCaption => Seat is null ? "" : Sentence.Joined(
        _verdict!.Pair is { } pair ? PairText.Of(pair, _verdict.AllLimits) : "", Seat.Note);

    /// <summary>The exaggeration and the largest gap without compensation.</summary>
    public string BeforeCaption => Before is null ? "" : Texts.Current.With("Detail.GapBefore", Before.LargestText);

    /// <summary>The largest predicted gap.</summary>
    public string AfterCaption => After is null ? "" : Texts.Current.With("Detail.GapAfter", After.LargestText);

    /// <summary>Note on the exaggeration, and on whether the drawing is turned.</summary>
    public string Exaggeration => Before?.Note ?? "";

    /// <summary>True unless a proof fails.</summary>
    public bool IsProved => ProofSeverity != Severity.Alarm;

    /// <summary>True if a proof fails.</summary>
    public bool IsDisproved => HasProof && !IsProved;

    public Severity ProofSeverity => Surface?.ProofSeverity ?? (Stored.Report is { Proof.Holds: true } ? Severity.Quiet : Severity.Alarm);

    /// <summary>What was proved, in one or two sentences.</summary>
    public string Proof => Stored.Report is not { Proof: var proof } ? Surface?.Proof ?? "" : Texts.Current.With(
        proof.Holds ? "Head.Proved" : "Head.NotProved",
        Shown.Count(proof.Motions),
        Shown.Count(proof.MovedMotions),
        Shown.Mm(proof.MaxDeviationFromWantedMm));

    /// <summary>How much of the program differs, or what a program of offsets sets.</summary>
    public string Changed => Offset is { } offset ? offset
        : Stored.Report is not { Program: var program } ? "" : Texts.Current.With("Detail.Changed", Shown.Count(program.ChangedBlocks));

    /// <summary>What the user should know before using the program.</summary>
    public IReadOnlyList<string> Warnings => [.. Stored.Report?.Warnings.Select(WarningText.Of) ?? Surface?.Warnings ?? []];

    public bool HasWarnings => Warnings.Count > 0;

    /// <summary>How many there are, and where.</summary>
    public string WarningCount => Texts.Current.With("Head.Warnings", Warnings.Count);

    /// <summary>What the approver signs for: the verdict, the displacement of the program, the remaining error, and every
    /// irregularity.</summary>
    public IReadOnlyList<Fact> Facts => [.. new[]
    {
        Verdict is { } verdict ? new Fact(verdict, VerdictSeverity) : null,
        IsDisproved ? new(Proof, ProofSeverity) : null,
        Offset is { } offset ? new(offset, Severity.Quiet) : null,
        Largest is { } largest ? new(largest, Severity.Quiet) : null,
        LeftOver is { Length: > 0 } left ? new(left, Severity.Quiet) : null,
        Missing is { } missing ? new(missing, Severity.Attention) : null,
        IsOfChangedJob ? new(Texts.Current["Head.ChangedJob"], Severity.Attention) : null,
        HasWarnings ? new(WarningCount, Severity.Attention) : null,
    }.OfType<Fact>()];

    // The recorded step also contains the warnings. They are shown elsewhere, so here they are only counted.
    private string BasisOf(CorrectionStep step)
    {
        string[] recorded = [.. Stored.Report?.Warnings.Select(w => w.Message) ?? Stored.Surface?.Warnings.Select(w => w.Message) ?? []];
        var parts = step.Basis.Parts.ToLookup(p => recorded.Contains(p.Sentence, StringComparer.Ordinal));
        var (basis, warnings) = (RecordedText.Of(Statement.InARow(parts[false]), Stored.Correction), parts[true].Count());
        return warnings == 0 ? basis : Sentence.Joined(basis, Texts.Current.With("Head.Warnings", warnings));
    }

    // The errors are the piece's, as in the verification: both screens use one convention.
    private PointRow Row(ReportKeyPoint p, VerifiedPoint errors) => new(
        p.Point,
        p.Feature,
        Shown.Mm(p.Theoretical.X),
        Shown.Mm(p.Theoretical.Y),
        Shown.Mm(p.Actual.X),
        Shown.Mm(p.Actual.Y),
        Shown.SignedMm(p.Correction.X),
        Shown.SignedMm(p.Correction.Y),
        Shown.SignedMm(errors.BeforeError.NormalMm),
        Shown.SignedMm(errors.AfterError.NormalMm, p.Interval95Mm),
        _piece!.Result.IsOutside(p.Point, errors.AfterError.NormalMm));

    private static CounterpartRow Row(ReportKeyPoint p) => new(
        p.Point,
        p.Feature,
        string.Join(", ", p.Blocks),
        Shown.Mm(p.InProgram!.Value.X),
        Shown.Mm(p.InProgram.Value.Y),
        Shown.SignedMm(p.Correction.X),
        Shown.SignedMm(p.Correction.Y),
        Shown.Mm(p.Corrected!.Value.X),
        Shown.Mm(p.Corrected.Value.Y));

    private static QuantityRow Row(ReportFeature feature, ReportQuantity q)
    {
        Func<double?, string> number = q.Quantity.IsAngle ? Shown.Degrees : Shown.Mm;
        return new(
            feature.Name,
            Texts.Current.Or("Quantity." + q.Quantity.Name, q.Quantity.Name),
            number(q.Quantity.Theoretical),
            number(q.Quantity.Actual),
            number(q.Corrected),
            q.Quantity.IsAngle ? "°" : "mm");
    }

    private static DecisionRow Row(MatchReport report, ReportFeature feature)
    {
        var texts = Texts.Current;
        var outside = report.BeyondTolerance(feature);
        var beyond = outside is [var worst, ..]
            ? texts.With("Decision.Beyond", outside.Count, worst.Point, Shown.Mm(Math.Abs(worst.ExcessMm)))
            : texts["Decision.Outside"];
        var accepted = feature.Acceptance ?? feature.Tolerance.Band;
        var reason = feature.Decision switch
        {
            Decision.WithinTolerance => texts.With("Decision.Within", Shown.SignedMm(accepted.LowerMm), Shown.SignedMm(accepted.UpperMm)),
            Decision.NotSignificant when report.Lot?.Next is not null && feature.SignificantMm is { } worth =>
                texts.With("Decision.OfLot", beyond, Shown.Mm(worth)),
            Decision.NotSignificant when feature.SignificantMm is { } significant =>
                texts.With("Decision.MayBeGauge", beyond, Shown.Mm(significant)),
            Decision.NotSignificant => texts.With("Decision.NotSignificant", beyond, Shown.Mm(feature.UncertaintyMm)),
            _ => texts.With(
                report.Compensation.Amount == CompensationAmount.Whole ? "Decision.FollowsWhole" : "Decision.FollowsExcess",
                feature is { IsSignificantTogether: true, SignificantMm: { } each }
                    ? texts.With("Decision.Together", beyond, Shown.Mm(each))
                    : beyond),
        };
        return new(
            $"{feature.Name} · {texts["Kind." + feature.Kind.Word]}",
            texts["Decided." + ReportWords.Of(feature.Decision)],
            reason,
            texts[IsFromCounterpart(report) ? "Detail.LargestDeviationMeasured" : "Detail.LargestDeviation"],
            Shown.SignedMm(feature.LargestMm));
    }

    private static bool IsFromCounterpart(MatchReport report) => report.Compensation.From == CompensationSource.Counterpart;
}

/// <summary>A key point of the counterpart in a table, in the frame of its program; lengths in mm.</summary>
/// <param name="Point">Its label.</param>
/// <param name="Feature">Its feature.</param>
/// <param name="Blocks">The blocks that cut it.</param>
/// <param name="TheoreticalX">As designed, x.</param>
/// <param name="TheoreticalY">As designed, y.</param>
/// <param name="CompensationX">Displacement of the program, x.</param>
/// <param name="CompensationY">Displacement of the program, y.</param>
/// <param name="CorrectedX">As corrected, x.</param>
/// <param name="CorrectedY">As corrected, y.</param>
internal sealed record CounterpartRow(
    string Point,
    string Feature,
    string Blocks,
    string TheoreticalX,
    string TheoreticalY,
    string CompensationX,
    string CompensationY,
    string CorrectedX,
    string CorrectedY);

/// <summary>A key point in a table; lengths in mm.</summary>
/// <param name="Point">Its label.</param>
/// <param name="Feature">Its feature.</param>
/// <param name="TheoreticalX">Nominal x.</param>
/// <param name="TheoreticalY">Nominal y.</param>
/// <param name="ActualX">Measured x.</param>
/// <param name="ActualY">Measured y.</param>
/// <param name="CompensationX">Displacement of the program, x.</param>
/// <param name="CompensationY">Displacement of the program, y.</param>
/// <param name="Without">The mating error without compensation: counterpart - part along the normal.</param>
/// <param name="LeftOver">The predicted mating error with compensation, by the same convention, with its 95 % interval if that is
/// known.</param>
/// <param name="IsOutside">True if that error is outside its limits.</param>
internal sealed record PointRow(
    string Point,
    string Feature,
    string TheoreticalX,
    string TheoreticalY,
    string ActualX,
    string ActualY,
    string CompensationX,
    string CompensationY,
    string Without,
    string LeftOver,
    bool IsOutside);

/// <summary>A length or an angle of a feature in a table.</summary>
/// <param name="Feature">The feature.</param>
/// <param name="Quantity">Its name.</param>
/// <param name="Ideal">Nominal value.</param>
/// <param name="Actual">Measured value of the part.</param>
/// <param name="Corrected">Predicted value of the corrected counterpart: close to the measured value, except for the errors
/// remaining at its points and deviations along the boundary.</param>
/// <param name="Unit">mm or degrees.</param>
internal sealed record QuantityRow(string Feature, string Quantity, string Ideal, string Actual, string Corrected, string Unit)
{
    /// <summary>Its name for screen readers: a feature has several quantities.</summary>
    public string Name => $"{Feature} · {Quantity}";
}

/// <summary>The displayed decision about a feature.</summary>
/// <param name="Feature">The feature and its shape.</param>
/// <param name="Decision">The decision, in a word or two.</param>
/// <param name="Reason">The reason.</param>
/// <param name="LargestName">What the largest deviation is the difference of.</param>
/// <param name="Largest">The largest deviation along the normal in mm, with its sign: of the part, or of part - counterpart.</param>
internal sealed record DecisionRow(string Feature, string Decision, string Reason, string LargestName, string Largest);

/// <summary>A step in a correction's history.</summary>
/// <param name="Time">Its time.</param>
/// <param name="State">The new state.</param>
/// <param name="By">Who took it.</param>
/// <param name="Basis">Its basis.</param>
internal sealed record StepRow(string Time, string State, string By, string Basis);
