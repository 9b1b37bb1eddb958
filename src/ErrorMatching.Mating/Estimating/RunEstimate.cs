using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>The estimate of one run: what its key points say about its elements, and what their cuts follow.</summary>
internal sealed class RunEstimate
{
    // What the rounding of a program's words does to a distance, mm. It says nothing about the piece.
    private const double Rounding = 0.001;

    // The places at which the boundary between two key points is compared.
    private const double SpacingMm = 1;
    private const int MostPlaces = 200;
    private const int MostDrawn = 40;

    // Cosine of the largest angle at which one curve still goes on as the other: 30 degrees. A deviation of a corner changes by no more
    // than a seventh across it.
    private const double SameCourseCosine = 0.866;

    // Nearer to a corner, the boundary is where the other element moves it.
    private const double CornerMm = 0.25;

    // Further from a corner than this and the tool's diameter, what is beyond the other element may be another place of the outline.
    private const double BeyondMm = 2;

    private readonly BoundaryRow?[] _ofPoints;
    private readonly RunPath _before;
    private readonly Dictionary<BoundaryElement, (double AlongMm, double All, double Corrected, double Ignored)[]> _bases =
        new(ReferenceEqualityComparer.Instance);
    private (DeviationPrior[] OfCuts, DeviationPrior[] OfPiece)? _priors;

    public RunEstimate(BoundaryRun run, IReadOnlyList<RunPoint> points, double uncertaintyMm)
    {
        (Run, Points, UncertaintyMm) = (run, points, uncertaintyMm);
        Cuts = [.. run.Elements.Select(_ => ElementCut.Still)];
        _ofPoints = new BoundaryRow?[points.Count];
        _before = run.On(run.Path);
        Nominal = [.. points.Select(p => _before.FootOf(p.Theoretical, p.Normal))];
        Stretches = run.Elements;
        for (var e = 0; e + 1 < run.Elements.Count; e++)
        {
            if (IsCourse(run.Elements[e]) && IsCourse(run.Elements[e + 1]) && run.JointAfter(e)?.Cosine > SameCourseCosine)
            {
                JoinIfLikelier(e);
            }
        }

        static bool IsCourse(BoundaryElement element) => element is { Form: ElementForm.Free, Degree: null };
    }

    // Two curves that were cut apart may have a step at their joint: then the points say more of each alone.
    private void JoinIfLikelier(int element)
    {
        var (apart, evidence) = (Stretches, EvidenceOfPoints());
        BoundaryElement[] joined = [.. CurvesOf(apart[StretchOf(Run.Elements[element]).Index]), Run.Elements[element + 1]];
        Stretches = [
            .. apart.Where(s => !CurvesOf(s).Any(joined.Contains) || ReferenceEquals(CurvesOf(s)[0], joined[0]))
                .Select(s => ReferenceEquals(CurvesOf(s)[0], joined[0]) ? new JoinedCurves(joined) : s)];
        if (EvidenceOfPoints() < evidence)
        {
            Stretches = apart;
        }
    }

    private double EvidenceOfPoints()
    {
        var (rows, _) = MeasuredRows();
        return Evidence.Log(
            DeviationField.CovarianceOf(PriorChoice.Of(Stretches, rows, UncertaintyMm).OfPiece, rows, UncertaintyMm),
            [.. rows.Select(r => r.ValueMm)]);
    }

    private static IReadOnlyList<BoundaryElement> CurvesOf(Stretch stretch) =>
        stretch is JoinedCurves joined ? joined.Curves : [(BoundaryElement)stretch];

    /// <summary>What its key points speak of: its elements, or curves that join and deviate as one.</summary>
    public IReadOnlyList<Stretch> Stretches { get; private set; }

    /// <summary>The passes whose boundary a term speaks of.</summary>
    public IEnumerable<FeaturePass> PassesOf(RowTerm term) => CurvesOf(Stretches[term.Stretch]).Select(c => c.Pass);

    // The stretch of an element, and what is added to a length along the element there.
    private (int Index, double OffsetMm) StretchOf(BoundaryElement element)
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

    private RowTerm TermOf(BoundaryElement element, double along, double weight)
    {
        var (index, offset) = StretchOf(element);
        return new(index, along + offset, weight);
    }

    private double MeanAt(BoundaryElement element, double along) => Field!.Mean([TermOf(element, along, 1)]);

    /// <summary>The run.</summary>
    public BoundaryRun Run { get; }

    /// <summary>Standard uncertainty of what a key point says, and so of a mating error there: that of a measured coordinate, mm.</summary>
    public double UncertaintyMm { get; }

    /// <summary>The key points of its features.</summary>
    public IReadOnlyList<RunPoint> Points { get; }

    /// <summary>The feet of the key points as designed on the program before.</summary>
    public IReadOnlyList<RunFoot> Nominal { get; }

    /// <summary>What the cut of each element follows.</summary>
    public IReadOnlyList<ElementCut> Cuts { get; private set; }

    /// <summary>The deviations that its key points say; null before the first measuring.</summary>
    public DeviationField? Field { get; private set; }

    /// <summary>Root mean square of what the last comparison found, mm.</summary>
    public double LeftMm { get; private set; }

    /// <summary>What the measured points say about the elements as the program before cuts them, with the point of each row. Without
    /// elements, a row is the deviation of its point alone.</summary>
    public (BoundaryRow[] Rows, RunPoint[] Points) MeasuredRows()
    {
        var rows = new List<(BoundaryRow Row, RunPoint Point)>();
        for (var i = 0; i < Points.Count; i++)
        {
            var point = Points[i];
            if (point.Beside is { } beside)
            {
                rows.Add((new([TermOf(beside.Element, beside.AlongMm, 1)], point.Measured.Dot(point.Normal)), point));
                continue;
            }

            var foot = _before.FootOf(point.Theoretical + point.Measured, point.Normal);
            RowTerm[] terms = [
                .. Run.SharesAt(Run.Path, foot).Select(s => TermOf(s.Element, s.AlongMm, s.Weight))];
            if (terms.Length > 0 || Run.Elements.Count == 0)
            {
                rows.Add((new(terms, Nominal[i].DistanceMm - foot.DistanceMm), point));
            }
        }

        return ([.. rows.Select(r => r.Row)], [.. rows.Select(r => r.Point)]);
    }

    /// <summary>Compares the places that the key points want with a path, exactly.</summary>
    /// <param name="path">The program before, or one with the displacement that <see cref="Cuts"/> follow.</param>
    /// <param name="isWhole">True for the measured places themselves; false for those that the compensation wants.</param>
    /// <returns>True if the comparison says nothing new.</returns>
    public bool Compare(NcPath path, bool isWhole)
    {
        var (cuts, following, isSettled, squares) = (OnCuts(path), Run.Following.ToList(), true, 0.0);
        for (var i = 0; i < Points.Count; i++)
        {
            var way = isWhole ? Points[i].Deviation : Points[i].Wanted;
            if (Points[i].Beside is { } beside)
            {
                _ofPoints[i] = new([TermOf(beside.Element, beside.AlongMm, 1)], way.Dot(Points[i].Normal));
                continue;
            }

            var place = Points[i].Theoretical + way;
            var foot = cuts.FootOf(place, Points[i].Normal);
            if (!isWhole && Run.HiddenBy(Nominal[i], foot) is { } line && !following.Contains(line))
            {
                following.Add(line);
            }

            var off = foot.DistanceMm - Nominal[i].DistanceMm + (isWhole ? 0 : CorrectedBaseMm(i));
            squares += off * off;
            var shares = Run.SharesAt(path, foot).ToArray();
            var row = shares.Length == 0 ? null
                : new BoundaryRow(
                    [.. shares.Select(s => TermOf(s.Element, s.AlongMm, s.Weight))],
                    shares.Sum(s => s.Weight
                        * (CutOf(s.Element).At(s.AlongMm) + (isWhole ? 0 : BaseAt(s.Element, s.AlongMm).Corrected))) - off);
            if (!Agree(row, _ofPoints[i]))
            {
                (_ofPoints[i], isSettled) = (row, false);
            }
        }

        LeftMm = Math.Sqrt(squares / Math.Max(1, Points.Count));
        isSettled &= following.Count == Run.Following.Count;
        Run.Following = following;
        return isSettled;
    }

    private static bool Agree(BoundaryRow? one, BoundaryRow? other) => one is null || other is null
        ? ReferenceEquals(one, other)
        : Math.Abs(one.ValueMm - other.ValueMm) <= Rounding
            && one.Terms.Select(t => t.Stretch).SequenceEqual(other.Terms.Select(t => t.Stretch));

    /// <summary>Estimates the deviations from the last comparison. The first one chooses the priors.</summary>
    /// <param name="isWhole">True for the piece itself, false for what the cuts are to follow.</param>
    public void Solve(bool isWhole)
    {
        BoundaryRow[] rows = [.. _ofPoints.OfType<BoundaryRow>()];
        _priors ??= PriorChoice.Of(Stretches, rows, UncertaintyMm);
        Field = new(isWhole ? _priors.Value.OfPiece : _priors.Value.OfCuts, rows, UncertaintyMm);
    }

    /// <summary>Lets the cuts of compensated elements follow the field.</summary>
    public void Follow(Func<BoundaryElement, bool> isCompensated) => Cuts =
    [
        .. Run.Elements.Select(element => isCompensated(element)
            ? ElementCut.Following(element, along => MeanAt(element, along) - BaseAt(element, along).Corrected)
            : ElementCut.Still)];

    /// <summary>What the cuts follow now, to come back to.</summary>
    public (IReadOnlyList<ElementCut> Cuts, IReadOnlyList<FollowingLine> Following) State
    {
        get => (Cuts, Run.Following);
        set => (Cuts, Run.Following) = value;
    }

    /// <summary>The mating error at a key point, measured exactly.</summary>
    /// <param name="point">Index of the point.</param>
    /// <param name="cuts">The cuts of this run.</param>
    public double ErrorAt(int point, RunPath cuts) =>
        cuts.FootOf(Points[point].Theoretical + Points[point].Deviation, Points[point].Normal).DistanceMm - Nominal[point].DistanceMm
            + BaseMm(point);

    /// <summary>What the program before does differently from the theoretical outline at a key point, mm: positive where it leaves too
    /// much material. 0 in feedback, where the measured counterpart has it.</summary>
    public double BaseMm(int point) => Points[point].CountsBase ? Nominal[point].DistanceMm - Run.Radius : 0;

    private double CorrectedBaseMm(int point) => Points[point].BaseShare * BaseMm(point);

    // The same along an element, and what of it is corrected. Between key points nothing tells it: it goes straight from one to the next. A
    // point on a corner tells it of two elements together, so it counts only where no other one does.
    // With it, what is not followed of the part's deviations.
    private (double All, double Corrected, double Ignored) BaseAt(BoundaryElement element, double along)
    {
        if (!_bases.TryGetValue(element, out var bases))
        {
            var own = Points.Select((p, i) => (Point: p, At: p.AlongOf(element), Index: i)).Where(p => p.At is not null).ToArray();
            var beside = Array.FindAll(own, p => !p.Point.Own!.Value.Foot.OnCorner);
            bases = _bases[element] = [
                .. (beside.Length > 0 ? beside : own).OrderBy(p => p.At)
                    .Select(p => (p.At!.Value, BaseMm(p.Index), CorrectedBaseMm(p.Index), p.Point.IgnoredMm))];
        }

        var after = Array.FindIndex(bases, b => b.AlongMm >= along);
        if (bases.Length == 0)
        {
            return default;
        }

        var (from, to) = (bases[after < 0 ? ^1 : Math.Max(after - 1, 0)], bases[after < 0 ? ^1 : after]);
        var share = to.AlongMm > from.AlongMm ? (along - from.AlongMm) / (to.AlongMm - from.AlongMm) : 0;
        return (
            from.All + (share * (to.All - from.All)),
            from.Corrected + (share * (to.Corrected - from.Corrected)),
            from.Ignored + (share * (to.Ignored - from.Ignored)));
    }

    /// <summary>The cuts of this run on a program.</summary>
    public RunPath OnCuts(NcPath path) => ReferenceEquals(path, Run.Path) ? _before : Run.On(path);

    /// <summary>The worst mating error along elements of a feature, with an interval that holds the largest error anywhere along
    /// them.</summary>
    /// <param name="elements">The elements, of whose form something is known.</param>
    /// <param name="after">The cuts of the program to cut.</param>
    /// <param name="limits">The limits of the error; null for none.</param>
    /// <param name="risk">The risk that an error anywhere is larger.</param>
    /// <returns>The error, its place in the program's frame; null if no element has two key points.</returns>
    public PredictedError? WorstAlong(IReadOnlyList<BoundaryElement> elements, RunPath after, ToleranceBand? limits, double risk)
    {
        var scale = elements.All(e => e.FormMm is not null) ? null : ColumnScale.ToldBy(Points.Count);
        var places = elements.SelectMany(e => Between(e).Select(at => (Element: e, At: at))).ToArray();
        PredictedError[] errors = [.. places.Select(p => ErrorBetween(p.Element, p.At, ErrorBetween(p.Element, after, p.At)))];
        if (PredictedError.Worst(errors, limits) is not { } worst)
        {
            return null;
        }

        // Neighboring places deviate alike: of many, some tell how large the largest error may be.
        int[] drawn = [.. Enumerable.Range(0, places.Length).Where(k => k % (1 + (places.Length / MostDrawn)) == 0)];
        var unknown = JointFactor.Factor(
            0, Field!.Together([.. drawn.Select(k => (IReadOnlyList<RowTerm>)[TermOf(places[k].Element, places[k].At, 1)])]));
        return worst.Within(LargestError.BoundMm([.. drawn.Select(k => errors[k].AfterMm)], unknown.Columns, scale, risk));
    }

    /// <summary>The middle between the two neighboring key points of an element that are furthest apart, where one more would tell most
    /// about its form, with the error there of a perfect shape.</summary>
    /// <remarks>Each kind asks for at least two points on each of its elements, so there always is one.</remarks>
    public PredictedError WidestGap(BoundaryElement element, RunPath after)
    {
        double[] feet = [.. FeetOf(element).Order()];
        var (from, to) = feet.Zip(feet.Skip(1)).MaxBy(g => g.Second - g.First);
        var at = (from + to) / 2;
        if (IsLeft(element, at))
        {
            return ErrorBetween(element, at, ErrorBetween(element, after, at)) with { IsKnown = false };
        }

        // Where the part has no boundary there, the error is what the nearest point says.
        var (place, normal) = Run.PlaceAt(element, at);
        var nearest = Enumerable.Range(0, Points.Count).Where(p => Points[p].AlongOf(element) is not null)
            .MinBy(p => Math.Abs(Points[p].AlongOf(element)!.Value - at));
        return new(place, normal, ErrorAt(nearest, _before), ErrorAt(nearest, after), UncertaintyMm) { IsKnown = false };
    }

    /// <summary>True if an element is compared anywhere between its key points. Where a neighbor that deviates more takes all of it away,
    /// its points say nothing of the boundary that is left.</summary>
    public bool IsCompared(BoundaryElement element) => Between(element).Any();

    private PredictedError ErrorBetween(BoundaryElement element, double at, double mm)
    {
        var (nominal, normal) = Run.PlaceAt(element, at);
        return new(nominal, normal, ErrorBetween(element, _before, at), mm, DeviationSigma(element, at));
    }

    private double ErrorBetween(BoundaryElement element, RunPath cuts, double along)
    {
        // The boundary of the program before is where it cuts, not where the theoretical outline is.
        return cuts.FootOf(WantedAt(element, along), Run.PlaceAt(element, along).Normal).DistanceMm - Run.Radius;
    }

    private double DeviationSigma(BoundaryElement element, double along)
    {
        var (index, offset) = StretchOf(element);
        return Field!.StandardDeviation(index, along + offset);
    }

    private static IEnumerable<double> FeetOf(BoundaryElement element) =>
        element.Pass.Feet.Where(f => element.Contains(f.Motion)).Select(element.Pass.Along);

    /// <summary>The places at which another way of cutting is compared: the key points, and the boundary between the outermost ones of
    /// each element.</summary>
    public IEnumerable<ComparedPlace> Places(Func<BoundaryElement, int> featureOf)
    {
        for (var i = 0; i < Points.Count; i++)
        {
            yield return new(
                this,
                Points[i].Feature,
                Points[i].Index,
                Points[i].Theoretical + Points[i].Deviation,
                Points[i].Normal,
                Nominal[i].DistanceMm - CorrectedBaseMm(i) - Points[i].IgnoredMm)
            {
                KeptMm = BaseMm(i) - CorrectedBaseMm(i) - Points[i].IgnoredMm,
                GapMm = Points[i].GapMm,
                Terms = _ofPoints[i]?.Terms ?? [],
                ResidualMm = _ofPoints[i] is { } row ? row.ValueMm - Field!.Mean(row.Terms) : 0,
            };
        }

        foreach (var element in Run.Elements)
        {
            foreach (var along in Between(element))
            {
                var (place, normal) = Run.PlaceAt(element, along);
                var own = Points.First(p => ReferenceEquals(p.Own?.Pass, element.Pass));
                var (differs, corrected, ignored) = BaseAt(element, along);
                var wanted = place + (normal * (MeanAt(element, along) - corrected - ignored));
                yield return new(this, featureOf(element), -1, wanted, normal, Run.Radius)
                {
                    KeptMm = differs - corrected - ignored,
                    GapMm = own.GapMm,
                    Terms = [TermOf(element, along, 1)],
                };
            }
        }
    }

    // The places on an element at which the boundary is compared: between its outermost key points, and up to the elements that it meets.
    // In a hollow corner, also one of two short blocks, the end of one is cut away with the other.
    private IEnumerable<double> Between(BoundaryElement element)
    {
        var (index, offset) = StretchOf(element);
        double[] feet = [.. CurvesOf(Stretches[index]).SelectMany(c => FeetOf(c).Select(f => f + StretchOf(c).OffsetMm - offset))];
        if (feet.Length < 2)
        {
            yield break;
        }

        var (before, behind) = (Run.JointAfter(IndexOf(element) - 1), Run.JointAfter(IndexOf(element)));
        var from = before is not null ? element.FromMm + EndAt(before) : Math.Max(feet.Min(), element.FromMm);
        var to = behind is not null ? element.ToMm - EndAt(behind) : Math.Min(feet.Max(), element.ToMm);
        if (from > to)
        {
            from = to = (from + to) / 2;
        }

        var steps = Math.Clamp((int)Math.Ceiling((to - from) / SpacingMm), 1, MostPlaces);
        for (var k = 0; k <= steps && (k == 0 || from < to); k++)
        {
            var along = from + ((to - from) * k / steps);
            if (IsLeft(element, along))
            {
                yield return along;
            }
        }

        static double EndAt(ElementJoint joint) => joint.Cosine > SameCourseCosine ? 0 : CornerMm;
    }

    // True where neither the tool cuts the boundary of an element away with that of another, nor the part has it: where the two lines of a
    // corner deviate differently, the corner of the part is elsewhere.
    private bool IsLeft(BoundaryElement element, double along)
    {
        var (place, normal) = Run.PlaceAt(element, along);
        if (_before.FootOf(place, normal).DistanceMm <= Run.Radius - Rounding)
        {
            return false;
        }

        var index = IndexOf(element);
        var wanted = WantedAt(element, along);
        return !IsBeyond(index - 1, index - 1, wanted) && !IsBeyond(index, index + 1, wanted);
    }

    private bool IsBeyond(int joint, int other, Point2 wanted)
    {
        if (Run.JointAfter(joint) is not { Corner: not 0 } corner)
        {
            return false;
        }

        var (element, atStart) = (Run.Elements[other], other > joint);
        var end = WantedAt(element, atStart ? element.FromMm : element.ToMm);
        var normal = atStart ? corner.Behind : corner.Before;
        return corner.Corner * (wanted - end).Dot(normal) > Rounding && wanted.DistanceTo(end) < BeyondMm + (2 * Run.Radius);
    }

    // Where the part has the boundary, in the program's frame.
    private Point2 WantedAt(BoundaryElement element, double along)
    {
        var (place, normal) = Run.PlaceAt(element, along);
        return place + (normal * (MeanAt(element, along) - BaseAt(element, along).All));
    }

    /// <summary>What was assumed about its stretches before they were measured.</summary>
    public IReadOnlyList<DeviationPrior> Priors => _priors!.Value.OfPiece;

    /// <summary>What was assumed about an element before it was measured.</summary>
    public ElementPrior PriorOf(BoundaryElement element) => _priors!.Value.OfPiece[StretchOf(element).Index].Summary;

    /// <summary>How far the measured piece is from what the program before cuts, at a length along an element, mm.</summary>
    public double DeviationAt(BoundaryElement element, double along) => MeanAt(element, along) - BaseAt(element, along).All
        + (Points.FirstOrDefault(p => p.AlongOf(element) is not null)?.GapMm ?? 0);

    /// <summary>The cut of an element.</summary>
    public ElementCut CutOf(BoundaryElement element) => Cuts[IndexOf(element)];

    private int IndexOf(BoundaryElement element)
    {
        for (var e = 0; e < Run.Elements.Count; e++)
        {
            if (ReferenceEquals(Run.Elements[e], element))
            {
                return e;
            }
        }

        throw new ArgumentException("The element is not of this run.", nameof(element));
    }
}

/// <summary>A place at which ways of cutting are compared, in the program's frame.</summary>
/// <param name="Run">Its run.</param>
/// <param name="Feature">Index of its feature in the job.</param>
/// <param name="Point">Index of the key point in the feature; -1 between key points.</param>
/// <param name="Place">Where the boundary should be.</param>
/// <param name="Normal">Unit normal toward the tool.</param>
/// <param name="NominalMm">Distance of the path from a boundary that is right, mm.</param>
internal sealed record ComparedPlace(RunEstimate Run, int Feature, int Point, Point2 Place, Vector2 Normal, double NominalMm)
{
    /// <summary>The deviations of the run's elements that move the place; none beside features without elements.</summary>
    public IReadOnlyList<RowTerm> Terms { get; init; } = [];

    /// <summary>How far the measured point is beyond the estimated boundary, toward the tool, mm; 0 between key points.</summary>
    public double ResidualMm { get; init; }

    /// <summary>The error that stays whatever is corrected, because the job keeps what the program before does differently, or because
    /// the part's deviation may be the gauge's, mm: positive where too much material stands.</summary>
    public double KeptMm { get; init; }

    /// <summary>The gap that the job wants there, mm.</summary>
    public double GapMm { get; init; }

    /// <summary>The mating error there that a correction may change, mm: positive where too much material stands.</summary>
    public double ErrorOn(RunPath cuts) => cuts.FootOf(Place, Normal).DistanceMm - NominalMm;
}

/// <summary>A key point beside a run, in the program's frame.</summary>
/// <param name="Feature">Index of its feature in the job.</param>
/// <param name="Index">Its index in the feature.</param>
/// <param name="Theoretical">Its designed place.</param>
/// <param name="Deviation">From there to the measured place that the boundary should have.</param>
/// <param name="Wanted">From there to the place that the compensation wants.</param>
/// <param name="Normal">Unit normal toward the tool.</param>
internal sealed record RunPoint(int Feature, int Index, Point2 Theoretical, Vector2 Deviation, Vector2 Wanted, Vector2 Normal)
{
    /// <summary>The pass of its feature, and its foot there.</summary>
    public (FeaturePass Pass, KeyPointFoot Foot)? Own { get; init; }

    /// <summary>The gap that the job wants there, mm.</summary>
    public double GapMm { get; init; }

    /// <summary>True if what the program does differently from the theoretical outline is not part of the deviation.</summary>
    public bool CountsBase { get; init; }

    /// <summary>The share of that which is corrected.</summary>
    public double BaseShare { get; init; }

    /// <summary>What of the deviation is not followed, mm.</summary>
    public double IgnoredMm { get; init; }

    /// <summary>From the theoretical place to the measured one.</summary>
    public Vector2 Measured => Deviation + (Normal * GapMm);

    /// <summary>Where its foot is along an element; null if it is not on it.</summary>
    public double? AlongOf(BoundaryElement element) =>
        Own is var (pass, foot) && ReferenceEquals(element.Pass, pass) && element.Contains(foot.Motion) ? pass.Along(foot) : null;

    /// <summary>The element that it counts for alone, and where on it; null if the cuts around it tell.</summary>
    public (BoundaryElement Element, double AlongMm)? Beside { get; init; }
}
