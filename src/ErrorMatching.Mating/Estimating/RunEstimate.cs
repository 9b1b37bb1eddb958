using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>The boundary of the measured piece along one run, estimated from what its key points say on the program to cut.</summary>
internal sealed class RunEstimate
{
    // What the rounding of a program's words does to a distance, mm. It says nothing about the piece.
    private const double Rounding = 0.001;

    // The places at which the boundary between two key points is compared.
    private const double SpacingMm = 1;
    private const int MostPlaces = 200;
    private const int MostDrawn = 40;

    // Nearer to a corner, the boundary is where the other element moves it.
    private const double CornerMm = 0.25;

    // Further from a corner than this and the tool's diameter, what is beyond the other element may be another place of the outline.
    private const double BeyondMm = 2;

    private readonly MeasuredRun _measured;
    private readonly IReadOnlyList<BoundaryRow?> _rows;
    private readonly IReadOnlyList<FollowingLine> _following;
    private readonly RunPath _before;

    /// <summary>Estimates it.</summary>
    /// <param name="measured">The run with its key points.</param>
    /// <param name="rows">What each key point says of its elements; null for a point that says nothing.</param>
    /// <param name="following">The lines beside its elements that their ends take along in the program to cut.</param>
    /// <param name="priors">What is assumed about its stretches.</param>
    public RunEstimate(
        MeasuredRun measured,
        IReadOnlyList<BoundaryRow?> rows,
        IReadOnlyList<FollowingLine> following,
        IReadOnlyList<DeviationPrior> priors)
    {
        (_measured, _rows, _following, Priors, _before) = (measured, rows, following, priors, measured.Run.On(measured.Run.Path));
        Field = new(priors, [.. rows.OfType<BoundaryRow>()], measured.UncertaintyMm);
    }

    /// <summary>The run.</summary>
    public BoundaryRun Run => _measured.Run;

    /// <summary>The key points of its features.</summary>
    public IReadOnlyList<RunPoint> Points => _measured.Points;

    /// <summary>Standard uncertainty of what a key point says, and so of a mating error there: that of a measured coordinate, mm.</summary>
    public double UncertaintyMm => _measured.UncertaintyMm;

    /// <summary>What its key points speak of: its elements, or curves that join and deviate as one.</summary>
    public IReadOnlyList<Stretch> Stretches => _measured.Stretches;

    /// <summary>What was assumed about its stretches before they were measured.</summary>
    public IReadOnlyList<DeviationPrior> Priors { get; }

    /// <summary>The deviations that its key points say.</summary>
    public DeviationField Field { get; }

    /// <summary>What the measured points say about the elements as the program before cuts them, with the point of each row.</summary>
    public (BoundaryRow[] Rows, RunPoint[] Points) MeasuredRows() => _measured.MeasuredRows(_following);

    /// <summary>The passes whose boundary a term speaks of.</summary>
    public IEnumerable<FeaturePass> PassesOf(RowTerm term) => MeasuredRun.CurvesOf(Stretches[term.Stretch]).Select(c => c.Pass);

    /// <summary>The mating error at a key point, measured exactly.</summary>
    /// <param name="point">Index of the point.</param>
    /// <param name="cuts">The cuts of this run.</param>
    public double ErrorAt(int point, RunPath cuts) =>
        cuts.FootOf(Points[point].Theoretical + Points[point].FromTheoretical, Points[point].Normal).DistanceMm
            - Points[point].Nominal.DistanceMm + Points[point].BaseMm;

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
            0, Field.Together([.. drawn.Select(k => (IReadOnlyList<RowTerm>)[TermOf(places[k].Element, places[k].At, 1)])]));
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
        return cuts.FootOf(PartAt(element, along), Run.PlaceAt(element, along).Normal).DistanceMm - Run.Radius;
    }

    private double DeviationSigma(BoundaryElement element, double along)
    {
        var (index, offset) = _measured.StretchOf(element);
        return Field.StandardDeviation(index, along + offset);
    }

    private static IEnumerable<double> FeetOf(BoundaryElement element) =>
        element.Pass.Feet.Where(f => element.Contains(f.Motion)).Select(element.Pass.Along);

    /// <summary>The places at which another way of cutting is compared: the key points, and the boundary between the outermost ones of
    /// each element.</summary>
    public IEnumerable<ComparedPlace> Places(Func<FeaturePass, int> featureOf)
    {
        for (var i = 0; i < Points.Count; i++)
        {
            var point = Points[i];
            yield return new(
                this,
                point.Feature,
                point.Index,
                point.Theoretical + point.FromTheoretical,
                point.Normal,
                point.Nominal.DistanceMm - point.CorrectedBaseMm - point.IgnoredMm)
            {
                KeptMm = point.BaseMm - point.CorrectedBaseMm - point.IgnoredMm,
                GapMm = point.GapMm,
                Terms = _rows[i]?.Terms ?? [],
                ResidualMm = _rows[i] is { } row ? row.ValueMm - Field.Mean(row.Terms) : 0,
            };
        }

        foreach (var element in Run.Elements)
        {
            foreach (var along in Between(element))
            {
                var (place, normal) = Run.PlaceAt(element, along);
                var own = Points.First(p => ReferenceEquals(p.Own?.Pass, element.Pass));
                var known = _measured.BaseAt(element, along);
                var wanted = place + (normal * (MeanAt(element, along) - known.CorrectedBaseMm - known.IgnoredMm));
                yield return new(this, featureOf(element.Pass), -1, wanted, normal, Run.Radius)
                {
                    KeptMm = known.BaseMm - known.CorrectedBaseMm - known.IgnoredMm,
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
        var (index, offset) = _measured.StretchOf(element);
        double[] feet = [
            .. MeasuredRun.CurvesOf(Stretches[index])
                .SelectMany(c => FeetOf(c).Select(f => f + _measured.StretchOf(c).OffsetMm - offset))];
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

        static double EndAt(ElementJoint joint) => joint.Cosine > MeasuredRun.SameCourseCosine ? 0 : CornerMm;
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
        var wanted = PartAt(element, along);
        return !IsBeyond(index - 1, index - 1, wanted) && !IsBeyond(index, index + 1, wanted);
    }

    private bool IsBeyond(int joint, int other, Point2 wanted)
    {
        if (Run.JointAfter(joint) is not { Corner: not 0 } corner)
        {
            return false;
        }

        var (element, atStart) = (Run.Elements[other], other > joint);
        var end = PartAt(element, atStart ? element.FromMm : element.ToMm);
        var normal = atStart ? corner.Behind : corner.Before;
        return corner.Corner * (wanted - end).Dot(normal) > Rounding && wanted.DistanceTo(end) < BeyondMm + (2 * Run.Radius);
    }

    // Where the part has the boundary, in the program's frame.
    private Point2 PartAt(BoundaryElement element, double along)
    {
        var (place, normal) = Run.PlaceAt(element, along);
        return place + (normal * (MeanAt(element, along) - _measured.BaseAt(element, along).BaseMm));
    }

    /// <summary>What was assumed about an element before it was measured.</summary>
    public ElementPrior PriorOf(BoundaryElement element) => Priors[_measured.StretchOf(element).Index].Summary;

    /// <summary>How far the measured piece is from what the program before cuts, at a length along an element, mm.</summary>
    public double DeviationAt(BoundaryElement element, double along) => MeanAt(element, along)
        - _measured.BaseAt(element, along).BaseMm + (Points.FirstOrDefault(p => p.AlongOf(element) is not null)?.GapMm ?? 0);

    private double MeanAt(BoundaryElement element, double along) => _measured.MeanAt(Field, element, along);

    private RowTerm TermOf(BoundaryElement element, double along, double weight) => _measured.TermOf(element, along, weight);

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
