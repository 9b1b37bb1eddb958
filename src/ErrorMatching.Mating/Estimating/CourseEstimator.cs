using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>Estimates how far the whole boundary must move, between and beyond its key points too. All elements that one run cuts are
/// estimated together, because a key point in the round of a corner says something about both its neighbors. Makes the program, measures
/// exactly what it leaves over, and corrects the estimate by that.</summary>
internal sealed class CourseEstimator
{
    // Each round makes the program once. The second already measures below a micrometer.
    private const int Rounds = 4;

    private readonly BoundaryRuns _runs;
    private readonly MatingDecision _decision;
    private readonly MeasuredRun[] _measured;

    /// <summary>Prepares the estimate.</summary>
    /// <param name="runs">The runs of cuts.</param>
    /// <param name="decision">The decisions on their features.</param>
    public CourseEstimator(BoundaryRuns runs, MatingDecision decision)
    {
        (_runs, _decision) = (runs, decision);
        var u = decision.Features[0].StandardUncertaintyMm;
        _measured = [.. runs.All.Select(run => MeasuredRun.Of(run, [.. run.Passes.SelectMany(pass => PointsOf(run, pass))], u))];
    }

    /// <summary>Estimates the courses of all compensated features, at least one.</summary>
    /// <returns>The estimate, or why a feature cannot follow its corrections.</returns>
    public Outcome<CourseEstimate> Estimate()
    {
        RunComparison[] compared = [.. _measured.Select(r => RunCourse.Still(r).Compare(_runs.Path))];
        CourseEstimate? best = null;
        for (var round = 0; round < Rounds; round++)
        {
            var outcome = Made([.. compared.Select(c => c.Follow(e => IsCompensated(_runs.FeatureOf(e.Pass))))]);
            if (!outcome.IsUsable)
            {
                return best is null ? outcome : best;
            }

            // A correction that makes it worse ends the rounds: far off its corner, a point says nothing that a straight line could extend.
            if (outcome.Result.LeftMm > best?.LeftMm)
            {
                break;
            }

            best = outcome.Result;
            if (best.Left.All(l => l.IsSettled))
            {
                break;
            }

            compared = best.Left;
        }

        return best!;
    }

    private Outcome<CourseEstimate> Made(RunCourse[] courses)
    {
        if (Wishes(courses, out var wish) is { } cannotFollow)
        {
            return cannotFollow;
        }

        var rewrite = Rewriter.Apply(_runs.Path, wish);
        if (!rewrite.IsUsable)
        {
            return rewrite.Refusal;
        }

        var after = rewrite.Result.Patches.Count == 0 ? _runs.Path : NcInterpreter.Run(rewrite.Result.Program, _runs.Path);
        return new CourseEstimate(wish, rewrite.Result, [.. courses.Select(c => c.Compare(after))]);
    }

    /// <summary>Estimates the boundary of the measured piece itself, on the program before.</summary>
    public PieceEstimate Measure() => new(_runs, [.. _measured.Select(r => RunCourse.Still(r).Measure(_runs.Path))]);

    /// <summary>Estimates the boundary of the measured piece itself, on a corrected program.</summary>
    /// <param name="course">The estimate that the program follows.</param>
    /// <param name="after">The program.</param>
    public PieceEstimate Measure(CourseEstimate course, NcPath after) =>
        new(_runs, [.. course.Left.Select(l => l.Measure(after))]);

    private bool IsCompensated(int feature) => _decision.Features[feature].Decision == Decision.Compensated;

    private IEnumerable<RunPoint> PointsOf(BoundaryRun run, FeaturePass pass)
    {
        var (counterpart, feature) = (_runs.Job.Counterpart, _runs.FeatureOf(pass));
        for (var i = 0; i < pass.Feet.Count; i++)
        {
            var decided = _decision.Features[feature].Points[i];
            var (way, normal) = (counterpart.Frame.Apply(decided.Point.FromTheoretical), pass.Feet[i].Normal);
            var followed = way - counterpart.Frame.Apply(decided.Point.Normal * decided.Point.IgnoredMm);
            (BoundaryElement, double)? beside = null;
            if (_runs.Job.Compensation.From == CompensationSource.Counterpart)
            {
                // What two measured points differ by along the boundary says nothing. On a corner, neither of them is where the program
                // before has its vertex, so the point speaks of its own element alone.
                if (pass.Feet[i].OnCorner
                    && _runs.ElementsOf(pass).FirstOrDefault(e => e.Contains(pass.Feet[i].Motion)) is { } element)
                {
                    var left = _runs.Path.Motions[pass.Feet[i].Motion].TangentAt(pass.Feet[i].Fraction).Left;
                    normal = pass.Feet[i].MaterialIsLeft ? -left : left;
                    beside = (element, pass.Along(pass.Feet[i]));
                }

                (way, followed) = (normal * way.Dot(normal), normal * followed.Dot(normal));
            }

            var theoretical = _runs.TheoreticalOf(feature, i);
            var nominal = run.On(_runs.Path).FootOf(theoretical, normal);
            var baseMm = _runs.BaseMm(run, nominal);
            yield return new(feature, i, theoretical, way, IsCompensated(feature) ? followed * decided.Share : way, normal)
            {
                Nominal = nominal,
                Own = (pass, pass.Feet[i]),
                Beside = beside,
                GapMm = decided.Point.GapMm,
                BaseMm = baseMm,
                CorrectedBaseMm = decided.BaseShare * baseMm,
                IgnoredMm = decided.Point.IgnoredMm,
            };
        }
    }

    private Refusal? Wishes(RunCourse[] courses, out DisplacementWish wish)
    {
        var elements = new List<ElementWish>();
        wish = DisplacementWish.OfElements([]);
        for (var f = 0; f < _runs.Maps.Count; f++)
        {
            if (!IsCompensated(f))
            {
                continue;
            }

            Vector2[] corrections = [.. _decision.Features[f].Points.Select(p => _runs.Job.Counterpart.Frame.Apply(p.Correction))];
            foreach (var pass in _runs.Maps[f].Passes)
            {
                var cut = new FeatureCut(_runs.Path, pass, corrections)
                {
                    Elements = _runs.ElementsOf(pass),
                    Courses = [.. _runs.ElementsOf(pass).Select(e => CourseOf(courses, e))],
                    ToolDiameterMm = _runs.Job.Counterpart.ToolDiameterMm,
                };
                if (_runs.Maps[f].Feature.RefuseCut(cut) is { } cannotFollow)
                {
                    return cannotFollow;
                }

                elements.AddRange(_runs.Maps[f].Feature.Wishes(cut));
            }
        }

        foreach (var lines in courses.SelectMany(c => c.Following).GroupBy(f => f.Motion))
        {
            var (start, end) = (EndOf(lines.FirstOrDefault(l => l.AtStart)), EndOf(lines.FirstOrDefault(l => !l.AtStart)));
            elements.Add(new(lines.Key, start, (start + end) / 2, end));
        }

        wish = DisplacementWish.OfElements([.. elements.OrderBy(e => e.Motion)]);
        return BeyondLimit(wish);

        Vector2 EndOf(FollowingLine? line) => line is null ? Vector2.Zero
            : line.AtStart ? elements.First(e => e.Motion == line.Element.Last).End
            : elements.First(e => e.Motion == line.Element.First).Start;
    }

    // The displacement at a length for the left normal there: along it, or both components of the vector, as the job asks.
    private Func<double, Vector2, Vector2> CourseOf(RunCourse[] courses, BoundaryElement element)
    {
        var course = courses.First(c => c.Measured.Run.Elements.Contains(element));
        if (_runs.Job.Compensation.Along == CompensationDirection.Normal)
        {
            var (cut, left) = (course.CutOf(element), course.Measured.Run.MaterialIsLeft ? -1 : 1);
            return (along, normal) => normal * (left * cut.At(along));
        }

        var (x, y) = (Component(course.Measured, element, c => c.X), Component(course.Measured, element, c => c.Y));
        return (along, _) => new(x.At(along), y.At(along));
    }

    // One component of the corrections at the points of an element.
    private ElementCut Component(MeasuredRun run, BoundaryElement element, Func<Vector2, double> component)
    {
        BoundaryElement[] elements = [element];
        BoundaryRow[] rows = [
            .. run.Points.Where(p => p.Feature == _runs.FeatureOf(element.Pass)).Select(p => (Point: p, Foot: element.Pass.Feet[p.Index]))
                .Where(p => element.Contains(p.Foot.Motion))
                .Select(p => new BoundaryRow([new(0, element.Pass.Along(p.Foot), 1)], component(p.Point.Target)))];
        var u = _runs.Job.Gauge.Uncertainty.CombinedMm;
        var field = new DeviationField(PriorChoice.Of(elements, rows, u).OfCuts, rows, u);
        return ElementCut.Following(element, along => field.Mean(0, along));
    }

    // The limit applies between and beyond the points too: a course that swings out there follows no measurement.
    private Refusal? BeyondLimit(DisplacementWish wish)
    {
        var limit = _runs.Job.Compensation.LimitMm * Math.Max(1, _runs.Job.Compensation.Gain);
        var worst = wish.Elements.MaxBy(Largest);
        if (wish.Elements.Count == 0 || Largest(worst) <= limit)
        {
            return null;
        }

        var block = _runs.Path.Motions[worst.Motion].Block;
        var name = _runs.Path.Program.NameOf(_runs.Path.Program[block]);
        var feature = _runs.Maps.FirstOrDefault(m => m.Blocks.Contains(block))?.Feature.Name ?? "";
        return RefusalForms.Refusal(
            RefusalForms.ImplausibleCourse,
            new() { Feature = feature, Block = name, Line = block + 1 },
            name,
            feature,
            Largest(worst),
            limit);

        static double Largest(ElementWish element) => Math.Max(element.Start.Length, Math.Max(element.Middle.Length, element.End.Length));
    }
}

/// <summary>The estimate of a whole boundary, and the program that follows it.</summary>
/// <param name="Wish">The wish for each motion that cuts a compensated feature.</param>
/// <param name="Rewrite">The changes that follow it.</param>
/// <param name="Left">What the changed program, without a marker, leaves on each run.</param>
internal sealed record CourseEstimate(DisplacementWish Wish, Rewrite Rewrite, RunComparison[] Left)
{
    /// <summary>Largest root mean square of what is left on a run, mm.</summary>
    public double LeftMm { get; } = Left.Max(l => l.LeftMm);
}

/// <summary>What the cuts of a run follow.</summary>
/// <param name="Measured">The run with its key points.</param>
/// <param name="Cuts">The displacement of each element.</param>
/// <param name="Following">Lines beside the elements that the end of one takes along.</param>
/// <param name="From">The comparison that it was solved from; null for cuts that stay where they are.</param>
internal sealed record RunCourse(
    MeasuredRun Measured, IReadOnlyList<ElementCut> Cuts, IReadOnlyList<FollowingLine> Following, RunComparison? From)
{
    // What the rounding of a program's words does to a distance, mm. It says nothing about the piece.
    private const double Rounding = 0.001;

    /// <summary>The program before.</summary>
    public static RunCourse Still(MeasuredRun measured) =>
        new(measured, [.. measured.Run.Elements.Select(_ => ElementCut.Still)], [], null);

    /// <summary>The cut of an element.</summary>
    public ElementCut CutOf(BoundaryElement element)
    {
        for (var e = 0; e < Cuts.Count; e++)
        {
            if (ReferenceEquals(Measured.Run.Elements[e], element))
            {
                return Cuts[e];
            }
        }

        throw new ArgumentException("The element is not of this run.", nameof(element));
    }

    /// <summary>Compares the places where the corrected program is to have the boundary with a program, exactly.</summary>
    /// <param name="path">The program whose cuts have this course.</param>
    public RunComparison Compare(NcPath path)
    {
        var (cuts, following, isSettled, squares) = (Measured.Run.On(path), Following.ToList(), true, 0.0);
        var rows = new BoundaryRow?[Measured.Points.Count];
        for (var i = 0; i < rows.Length; i++)
        {
            var point = Measured.Points[i];
            rows[i] = Measured.RowBeside(point, point.Target);
            if (rows[i] is not null)
            {
                continue;
            }

            var foot = cuts.FootOf(point.Theoretical + point.Target, point.Normal);
            if (Measured.Run.HiddenBy(point.Nominal, foot, Following) is { } line && !following.Contains(line))
            {
                following.Add(line);
            }

            var off = foot.DistanceMm - point.Nominal.DistanceMm + point.CorrectedBaseMm;
            squares += off * off;
            rows[i] = RowAt(path, foot, off, (e, along) => CutOf(e).At(along) + Measured.BaseAt(e, along).CorrectedBaseMm);
            if (Agree(rows[i], From?.Rows[i]))
            {
                rows[i] = From?.Rows[i];
            }
            else
            {
                isSettled = false;
            }
        }

        return new(this, rows, following)
        {
            Priors = From?.Priors ?? Measured.PriorsOf(rows),
            LeftMm = Math.Sqrt(squares / Math.Max(1, rows.Length)),
            IsSettled = isSettled && following.Count == Following.Count,
        };
    }

    /// <summary>Estimates the boundary of the measured piece from the measured places themselves.</summary>
    /// <param name="path">The program whose cuts have this course.</param>
    /// <param name="left">What was found when the course was compared with it; null if it was not.</param>
    public RunEstimate Measure(NcPath path, RunComparison? left = null)
    {
        var cuts = Measured.Run.On(path);
        BoundaryRow?[] rows = [
            .. Measured.Points.Select((point, i) =>
            {
                if (Measured.RowBeside(point, point.FromTheoretical) is { } beside)
                {
                    return beside;
                }

                var foot = cuts.FootOf(point.Theoretical + point.FromTheoretical, point.Normal);
                var row = RowAt(path, foot, foot.DistanceMm - point.Nominal.DistanceMm, (e, along) => CutOf(e).At(along));
                return Agree(row, left?.Rows[i]) ? left?.Rows[i] : row;
            })];
        return new(Measured, rows, Following, (left?.Priors ?? Measured.PriorsOf(rows)).OfPiece);
    }

    // What a foot says of the boundary: what its elements are displaced already, less what is still off.
    private BoundaryRow? RowAt(NcPath path, RunFoot foot, double offMm, Func<BoundaryElement, double, double> displacedMm)
    {
        var shares = Measured.Run.SharesAt(path, foot, Following).ToArray();
        return shares.Length == 0 ? null : new(
            [.. shares.Select(s => Measured.TermOf(s.Element, s.AlongMm, s.Weight))],
            shares.Sum(s => s.Weight * displacedMm(s.Element, s.AlongMm)) - offMm);
    }

    private static bool Agree(BoundaryRow? one, BoundaryRow? other) => one is null || other is null
        ? ReferenceEquals(one, other)
        : Math.Abs(one.ValueMm - other.ValueMm) <= Rounding
            && one.Terms.Select(t => t.Stretch).SequenceEqual(other.Terms.Select(t => t.Stretch));
}

/// <summary>What the key points of a run ask for, compared with what a program cuts there.</summary>
/// <param name="Course">What the cuts of the program follow.</param>
/// <param name="Rows">What each key point says of its elements, the displacement that the cuts have already included; null for a point that
/// says nothing. A row that differs from the one of the comparison before by rounding alone stays as it was.</param>
/// <param name="Following">Lines beside the elements that must follow, because they hide a key point.</param>
internal sealed record RunComparison(RunCourse Course, IReadOnlyList<BoundaryRow?> Rows, IReadOnlyList<FollowingLine> Following)
{
    /// <summary>What is assumed about the stretches; chosen by the first comparison.</summary>
    public required (DeviationPrior[] OfCuts, DeviationPrior[] OfPiece) Priors { get; init; }

    /// <summary>Root mean square of what the cuts are off, mm.</summary>
    public required double LeftMm { get; init; }

    /// <summary>True if it says nothing new.</summary>
    public required bool IsSettled { get; init; }

    /// <summary>Estimates the boundary of the measured piece itself.</summary>
    /// <param name="path">The compared program.</param>
    public RunEstimate Measure(NcPath path) => Course.Measure(path, this);

    /// <summary>Lets the cuts of compensated elements follow the deviations that it shows.</summary>
    public RunCourse Follow(Func<BoundaryElement, bool> isCompensated)
    {
        var measured = Course.Measured;
        var field = new DeviationField(Priors.OfCuts, [.. Rows.OfType<BoundaryRow>()], measured.UncertaintyMm);
        return new(
            measured,
            [
                .. measured.Run.Elements.Select(element => isCompensated(element)
                    ? ElementCut.Following(
                        element, along => measured.MeanAt(field, element, along) - measured.BaseAt(element, along).CorrectedBaseMm)
                    : ElementCut.Still)],
            Following,
            this);
    }
}
