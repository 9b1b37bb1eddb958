using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>A run with its measured key points, and what each of them can speak of. Nothing is estimated yet.</summary>
internal sealed record MeasuredRun
{
    // Cosine of the largest angle at which one curve still goes on as the other: 30 degrees. A deviation of a corner changes by no more
    // than a seventh across it.
    public const double SameCourseCosine = 0.866;

    private readonly Dictionary<BoundaryElement, BaseAlong[]> _bases = new(ReferenceEqualityComparer.Instance);

    private MeasuredRun(BoundaryRun run, IReadOnlyList<RunPoint> points, double uncertaintyMm)
    {
        (Run, Points, UncertaintyMm, Stretches) = (run, points, uncertaintyMm, run.Elements);
        foreach (var element in run.Elements)
        {
            _bases.Add(element, BasesOf(element));
        }
    }

    /// <summary>The run with some key points.</summary>
    /// <param name="run">The run.</param>
    /// <param name="points">The key points of its features.</param>
    /// <param name="uncertaintyMm">Standard uncertainty of a point, mm.</param>
    public static MeasuredRun Of(BoundaryRun run, IReadOnlyList<RunPoint> points, double uncertaintyMm)
    {
        var measured = new MeasuredRun(run, points, uncertaintyMm);
        for (var e = 0; e + 1 < run.Elements.Count; e++)
        {
            if (IsCourse(run.Elements[e]) && IsCourse(run.Elements[e + 1]) && run.JointAfter(e)?.Cosine > SameCourseCosine
                && measured.Joined(e) is var joined && !(joined.EvidenceOfPoints() < measured.EvidenceOfPoints()))
            {
                measured = joined;
            }
        }

        return measured;

        static bool IsCourse(BoundaryElement element) => element is { Form: ElementForm.Free, Degree: null };
    }

    /// <summary>The run.</summary>
    public BoundaryRun Run { get; }

    /// <summary>The key points of its features.</summary>
    public IReadOnlyList<RunPoint> Points { get; }

    /// <summary>Standard uncertainty of what a key point says, and so of a mating error there: that of a measured coordinate, mm.</summary>
    public double UncertaintyMm { get; }

    /// <summary>What its key points speak of: its elements, or curves that join and deviate as one.</summary>
    public IReadOnlyList<Stretch> Stretches { get; private init; }

    /// <summary>The curves of a stretch, or the one element that it is.</summary>
    public static IReadOnlyList<BoundaryElement> CurvesOf(Stretch stretch) =>
        stretch is JoinedCurves joined ? joined.Curves : [(BoundaryElement)stretch];

    /// <summary>The stretch of an element, and what is added to a length along the element there.</summary>
    public (int Index, double OffsetMm) StretchOf(BoundaryElement element)
    {
        for (var k = 0; k < Stretches.Count; k++)
        {
            if (CurvesOf(Stretches[k]).Any(c => ReferenceEquals(c, element)))
            {
                return (k, Stretches[k] is JoinedCurves joined ? joined.OffsetOf(element) : 0);
            }
        }

        throw new ArgumentException("The element is not of this run.", nameof(element));
    }

    /// <summary>A place on an element as a term.</summary>
    public RowTerm TermOf(BoundaryElement element, double along, double weight)
    {
        var (index, offset) = StretchOf(element);
        return new(index, along + offset, weight);
    }

    /// <summary>The best estimate of the deviation of an element, mm.</summary>
    public double MeanAt(DeviationField field, BoundaryElement element, double along) => field.Mean([TermOf(element, along, 1)]);

    /// <summary>What the measured points say about the elements as the program before cuts them, with the point of each row. Without
    /// elements, a row is the deviation of its point alone.</summary>
    /// <param name="following">The lines beside its elements that their ends take along.</param>
    public (BoundaryRow[] Rows, RunPoint[] Points) MeasuredRows(IReadOnlyList<FollowingLine> following)
    {
        var (rows, cuts) = (new List<(BoundaryRow Row, RunPoint Point)>(), Run.On(Run.Path));
        foreach (var point in Points)
        {
            if (RowBeside(point, point.Measured) is { } beside)
            {
                rows.Add((beside, point));
                continue;
            }

            var foot = cuts.FootOf(point.Theoretical + point.Measured, point.Normal);
            RowTerm[] terms = [
                .. Run.SharesAt(Run.Path, foot, following).Select(s => TermOf(s.Element, s.AlongMm, s.Weight))];
            if (terms.Length > 0 || Run.Elements.Count == 0)
            {
                rows.Add((new(terms, point.Nominal.DistanceMm - foot.DistanceMm), point));
            }
        }

        return ([.. rows.Select(r => r.Row)], [.. rows.Select(r => r.Point)]);
    }

    /// <summary>What is assumed about its stretches, chosen by the evidence of rows.</summary>
    public (DeviationPrior[] OfCuts, DeviationPrior[] OfPiece) PriorsOf(IReadOnlyList<BoundaryRow?> rows) =>
        PriorChoice.Of(Stretches, [.. rows.OfType<BoundaryRow>()], UncertaintyMm);

    /// <summary>What a point says of the one element that it speaks of; null if the cuts around it tell.</summary>
    /// <param name="point">The point.</param>
    /// <param name="way">From its designed place to the one that is asked for.</param>
    public BoundaryRow? RowBeside(RunPoint point, Vector2 way) => point.Beside is not { } beside ? null
        : new([TermOf(beside.Element, beside.AlongMm, 1)], way.Dot(point.Normal));

    /// <summary>What the program before does differently along an element, and what is not followed there of the part's deviations.
    /// Between key points nothing tells it: it goes straight from one to the next. A point on a corner tells it of two elements together,
    /// so it matters only where no other one does.</summary>
    public BaseAlong BaseAt(BoundaryElement element, double along)
    {
        var bases = _bases[element];
        if (bases.Length == 0)
        {
            return default;
        }

        var after = Array.FindIndex(bases, b => b.AlongMm >= along);
        var (from, to) = (bases[after < 0 ? ^1 : Math.Max(after - 1, 0)], bases[after < 0 ? ^1 : after]);
        var share = to.AlongMm > from.AlongMm ? (along - from.AlongMm) / (to.AlongMm - from.AlongMm) : 0;
        return new(
            along,
            from.BaseMm + (share * (to.BaseMm - from.BaseMm)),
            from.CorrectedBaseMm + (share * (to.CorrectedBaseMm - from.CorrectedBaseMm)),
            from.IgnoredMm + (share * (to.IgnoredMm - from.IgnoredMm)));
    }

    private BaseAlong[] BasesOf(BoundaryElement element)
    {
        var own = Points.Select(p => (Point: p, At: p.AlongOf(element))).Where(p => p.At is not null).ToArray();
        var beside = Array.FindAll(own, p => !p.Point.Own!.Value.Foot.OnCorner);
        return [
            .. (beside.Length > 0 ? beside : own).OrderBy(p => p.At)
                .Select(p => new BaseAlong(p.At!.Value, p.Point.BaseMm, p.Point.CorrectedBaseMm, p.Point.IgnoredMm))];
    }

    // An element and the next one as one curve. Two that were cut apart may have a step at their joint: then the points say more of each
    // alone.
    private MeasuredRun Joined(int element)
    {
        BoundaryElement[] curves = [.. CurvesOf(Stretches[StretchOf(Run.Elements[element]).Index]), Run.Elements[element + 1]];
        return this with
        {
            Stretches = [
                .. Stretches.Where(s => !CurvesOf(s).Any(curves.Contains) || ReferenceEquals(CurvesOf(s)[0], curves[0]))
                    .Select(s => ReferenceEquals(CurvesOf(s)[0], curves[0]) ? new JoinedCurves(curves) : s)],
        };
    }

    private double EvidenceOfPoints()
    {
        var (rows, _) = MeasuredRows([]);
        return Evidence.Log(
            DeviationField.CovarianceOf(PriorChoice.Of(Stretches, rows, UncertaintyMm).OfPiece, rows, UncertaintyMm),
            [.. rows.Select(r => r.ValueMm)]);
    }
}

/// <summary>A measured key point on a run, in the program's frame. <see cref="BoundaryPoint"/> has the table of its quantities.</summary>
/// <param name="Feature">Index of its feature in the job.</param>
/// <param name="Index">Its index in the feature.</param>
/// <param name="Theoretical">Its designed place.</param>
/// <param name="FromTheoretical">From there to the place that fits the part with the wanted gap.</param>
/// <param name="Target">From there to where the corrected program is to have the boundary, less what is kept of <see cref="BaseMm"/>;
/// <see cref="FromTheoretical"/> if its feature is not compensated.</param>
/// <param name="Normal">Unit normal toward the tool.</param>
internal sealed record RunPoint(int Feature, int Index, Point2 Theoretical, Vector2 FromTheoretical, Vector2 Target, Vector2 Normal)
{
    /// <summary>The foot of its designed place on the program before.</summary>
    public required RunFoot Nominal { get; init; }

    /// <summary>The pass of its feature, and its foot there.</summary>
    public (FeaturePass Pass, KeyPointFoot Foot)? Own { get; init; }

    /// <summary>The element that it speaks of alone, and where on it; null if the cuts around it tell.</summary>
    public (BoundaryElement Element, double AlongMm)? Beside { get; init; }

    /// <summary>The gap that the job wants there, mm.</summary>
    public double GapMm { get; init; }

    /// <summary>What the program before does differently from the theoretical outline on this pass, mm. 0 in feedback, where the measured
    /// counterpart has it.</summary>
    public double BaseMm { get; init; }

    /// <summary>What of <see cref="BaseMm"/> is corrected.</summary>
    public double CorrectedBaseMm { get; init; }

    /// <summary>What of the deviation is not followed, mm.</summary>
    public double IgnoredMm { get; init; }

    /// <summary>From the theoretical place to the measured one.</summary>
    public Vector2 Measured => FromTheoretical + (Normal * GapMm);

    /// <summary>Where its foot is along an element; null if it is not on it.</summary>
    public double? AlongOf(BoundaryElement element) =>
        Own is var (pass, foot) && ReferenceEquals(element.Pass, pass) && element.Contains(foot.Motion) ? pass.Along(foot) : null;
}

/// <summary>The quantities of <see cref="RunPoint"/> that are told between key points, too.</summary>
/// <param name="AlongMm">Length along the element.</param>
/// <param name="BaseMm">What the program before does differently.</param>
/// <param name="CorrectedBaseMm">What of that is corrected.</param>
/// <param name="IgnoredMm">What of the part's deviation is not followed.</param>
internal readonly record struct BaseAlong(double AlongMm, double BaseMm, double CorrectedBaseMm, double IgnoredMm);

/// <summary>Curves that follow one another smoothly and deviate as one, whatever feature each belongs to: what the points of one say
/// reaches across the joint. Lengths are those of the first, and go on through the others.</summary>
/// <param name="Curves">The curves in the order of cutting, at least two.</param>
internal sealed record JoinedCurves(IReadOnlyList<BoundaryElement> Curves) : Stretch(ElementForm.Free)
{
    /// <inheritdoc/>
    public override double FromMm => Curves[0].FromMm;

    /// <inheritdoc/>
    public override double ToMm => OffsetOf(Curves[^1]) + Curves[^1].ToMm;

    /// <summary>What is added to a length along one of the curves.</summary>
    public double OffsetOf(BoundaryElement curve)
    {
        var at = Curves[0].FromMm;
        foreach (var other in Curves)
        {
            if (ReferenceEquals(other, curve))
            {
                return at - curve.FromMm;
            }

            at += other.ToMm - other.FromMm;
        }

        throw new ArgumentException("The curve is none of them.", nameof(curve));
    }
}
