using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
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

    private readonly MatingJob _job;
    private readonly NcPath _path;
    private readonly IReadOnlyList<FeatureMap> _maps;
    private readonly MatingDecision _decision;
    private readonly IReadOnlyList<Point2>[] _theoretical;
    private readonly List<RunEstimate> _runs = [];
    private readonly Dictionary<BoundaryElement, int> _features = new(ReferenceEqualityComparer.Instance);
    private readonly Dictionary<FeaturePass, List<BoundaryElement>> _elements = new(ReferenceEqualityComparer.Instance);

    /// <summary>Prepares the estimate.</summary>
    /// <param name="job">The job.</param>
    /// <param name="path">The counterpart's program, interpreted.</param>
    /// <param name="maps">The features mapped onto it, in the order of the job.</param>
    /// <param name="decision">The decisions on the features.</param>
    /// <param name="theoretical">The key points as designed.</param>
    public CourseEstimator(
        MatingJob job, NcPath path, IReadOnlyList<FeatureMap> maps, MatingDecision decision, MeasurementFile theoretical)
    {
        (_job, _path, _maps, _decision) = (job, path, maps, decision);
        _theoretical = [
            .. maps.Select(m => (IReadOnlyList<Point2>)[
                .. m.Feature.Points.Select(l => job.Counterpart.PlaceOf(theoretical[l], m.Feature.Plane, theoretical.File))])];
        for (var f = 0; f < maps.Count; f++)
        {
            foreach (var pass in maps[f].Passes)
            {
                _elements[pass] = [.. maps[f].Feature.Elements(path, pass).Select(e => e with { FormMm = maps[f].Feature.FormMm })];
                foreach (var element in _elements[pass])
                {
                    _features.Add(element, f);
                }
            }
        }

        var u = decision.Features[0].StandardUncertaintyMm;
        for (var f = 0; f < maps.Count; f++)
        {
            foreach (var pass in maps[f].Passes.Where(p => _elements[p].Count == 0))
            {
                var run = BoundaryRun.OfPass(path, pass, job.Counterpart.ToolDiameterMm);
                _runs.Add(new(run, [.. PointsOf(pass, f)], u));
            }
        }

        foreach (var plane in _features.Keys.Select(e => maps[_features[e]].Feature.Plane).Distinct())
        {
            BoundaryElement[] elements = [.. _features.Keys.Where(e => maps[_features[e]].Feature.Plane == plane)];
            foreach (var run in BoundaryRun.Find(path, elements, job.Counterpart.ToolDiameterMm))
            {
                _runs.Add(new(run, [.. PointsOf(run)], u));
            }
        }
    }

    /// <summary>Estimates the courses of all compensated features, at least one.</summary>
    /// <returns>The estimate, or why a feature cannot follow its corrections.</returns>
    public Outcome<CourseEstimate> Estimate()
    {
        var (best, least) = ((CourseEstimate?)null, double.PositiveInfinity);
        var states = _runs.Select(r => r.State).ToArray();
        _runs.ForEach(r => r.Compare(_path, isWhole: false));
        for (var round = 0; round < Rounds; round++)
        {
            var outcome = Made();
            if (!outcome.IsUsable && best is null)
            {
                Restore(states);
                return outcome.Refusal;
            }

            if (!outcome.IsUsable)
            {
                break;
            }

            // A correction that makes it worse ends the rounds: far off its corner, a point says nothing that a straight line could extend.
            var made = _runs.Select(r => r.State).ToArray();
            var isSettled = true;
            _runs.ForEach(r => isSettled &= r.Compare(outcome.Result.After, isWhole: false));
            var left = _runs.Max(r => r.LeftMm);
            var isWorse = left > least;
            if (!isWorse)
            {
                (best, least, states) = (outcome.Result, left, made);
            }

            if (isSettled || isWorse)
            {
                break;
            }
        }

        Restore(states);
        return best!;
    }

    // What the cuts follow on the path that is predicted next.
    private void Restore((IReadOnlyList<ElementCut>, IReadOnlyList<FollowingLine>)[] states)
    {
        for (var r = 0; r < _runs.Count; r++)
        {
            _runs[r].State = states[r];
        }
    }

    private Outcome<CourseEstimate> Made()
    {
        foreach (var run in _runs)
        {
            run.Solve(isWhole: false);
            run.Follow(e => IsCompensated(_features[e]));
        }

        if (Wishes(out var wish) is { } cannotFollow)
        {
            return cannotFollow;
        }

        var rewrite = Rewriter.Apply(_path, wish);
        return !rewrite.IsUsable ? rewrite.Refusal
            : new CourseEstimate(
                wish,
                rewrite.Result,
                rewrite.Result.Patches.Count == 0 ? _path : NcInterpreter.Run(rewrite.Result.Program, _path));
    }

    /// <summary>Estimates the boundary of the measured piece itself, from what its points say on a program.</summary>
    /// <param name="after">The program to cut: the original one, or that of the estimate.</param>
    public PieceEstimate Measure(NcPath after)
    {
        foreach (var run in _runs)
        {
            run.Compare(after, isWhole: true);
            run.Solve(isWhole: true);
        }

        return new(_job, _path, _maps, _runs, _elements);
    }

    /// <summary>The features of the job.</summary>
    public IReadOnlyList<JobFeature> Features => _job.Features;

    /// <summary>What the program before does differently from the theoretical outline at a key point, mm: positive where it leaves too much
    /// material. 0 in feedback.</summary>
    public double BaseMm(int feature, int index)
    {
        var (run, point) = PointOf(feature, index);
        return run.BaseMm(point);
    }

    // On the first cut of its feature.
    private (RunEstimate Run, int Point) PointOf(int feature, int index)
    {
        foreach (var run in _runs)
        {
            for (var p = 0; p < run.Points.Count; p++)
            {
                if (run.Points[p].Feature == feature && run.Points[p].Index == index
                    && ReferenceEquals(run.Points[p].Own?.Pass, _maps[feature].Passes[0]))
                {
                    return (run, p);
                }
            }
        }

        throw new ArgumentException("The point is on no run.", nameof(index));
    }

    /// <summary>The runs of cuts that are estimated.</summary>
    public IReadOnlyList<RunEstimate> Runs => _runs;

    private bool IsCompensated(int feature) => _decision.Features[feature].Decision == Decision.Compensated;

    private IEnumerable<RunPoint> PointsOf(BoundaryRun run) =>
        run.Elements.Select(e => e.Pass).Distinct().SelectMany(pass => PointsOf(pass, _features[_elements[pass][0]]));

    private IEnumerable<RunPoint> PointsOf(FeaturePass pass, int feature)
    {
        for (var i = 0; i < pass.Feet.Count; i++)
        {
            var decided = _decision.Features[feature].Points[i];
            var (deviation, normal) = (_job.Counterpart.Frame.Apply(decided.Point.FromTheoretical), pass.Feet[i].Normal);
            var followed = deviation - _job.Counterpart.Frame.Apply(decided.Point.Normal * decided.Point.IgnoredMm);
            (BoundaryElement, double)? beside = null;
            if (_job.Compensation.From == CompensationSource.Counterpart)
            {
                // What two measured points differ by along the boundary says nothing. On a corner, neither of them is where the program
                // before has its vertex, so the point counts for its own element alone.
                if (pass.Feet[i].OnCorner && _elements[pass].Find(e => e.Contains(pass.Feet[i].Motion)) is { } element)
                {
                    var left = _path.Motions[pass.Feet[i].Motion].TangentAt(pass.Feet[i].Fraction).Left;
                    normal = pass.Feet[i].MaterialIsLeft ? -left : left;
                    beside = (element, pass.Along(pass.Feet[i]));
                }

                (deviation, followed) = (normal * deviation.Dot(normal), normal * followed.Dot(normal));
            }

            yield return new(
                feature,
                i,
                _theoretical[feature][i],
                deviation,
                IsCompensated(feature) ? followed * ShareOf(decided, _decision.Features[feature].Acceptance) : deviation,
                normal)
            {
                Beside = beside,
                Own = (pass, pass.Feet[i]),
                GapMm = decided.Point.GapMm,
                CountsBase = _job.Compensation.From == CompensationSource.Part,
                BaseShare = _maps[feature].Feature.CorrectsBase && IsCompensated(feature)
                    ? ShareOf(decided, _decision.Features[feature].Acceptance)
                    : 0,
                IgnoredMm = decided.Point.IgnoredMm,
            };
        }
    }

    // The part of the deviation at a point that is compensated.
    private double ShareOf(PointDecision decided, ToleranceBand acceptance)
    {
        var normal = decided.Point.FollowedMm;
        return _job.Compensation.Gain
            * (_job.Compensation.Amount == CompensationAmount.Whole ? 1 : normal == 0 ? 0 : acceptance.ExcessOf(normal) / normal);
    }

    private Refusal? Wishes(out DisplacementWish wish)
    {
        var elements = new List<ElementWish>();
        wish = DisplacementWish.OfElements([]);
        for (var f = 0; f < _maps.Count; f++)
        {
            if (!IsCompensated(f))
            {
                continue;
            }

            Vector2[] corrections = [.. _decision.Features[f].Points.Select(p => _job.Counterpart.Frame.Apply(p.Correction))];
            foreach (var pass in _maps[f].Passes)
            {
                var cut = new FeatureCut(_path, pass, corrections)
                {
                    Elements = _elements[pass],
                    Courses = [.. _elements[pass].Select(e => CourseOf(e, corrections))],
                    ToolDiameterMm = _job.Counterpart.ToolDiameterMm,
                };
                if (_maps[f].Feature.RefuseCut(cut) is { } cannotFollow)
                {
                    return cannotFollow;
                }

                elements.AddRange(_maps[f].Feature.Wishes(cut));
            }
        }

        foreach (var lines in _runs.SelectMany(r => r.Run.Following).GroupBy(f => f.Motion))
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
    private Func<double, Vector2, Vector2> CourseOf(BoundaryElement element, Vector2[] corrections)
    {
        var run = _runs.First(r => r.Run.Elements.Contains(element));
        if (_job.Compensation.Along == CompensationDirection.Normal)
        {
            var (cut, left) = (run.CutOf(element), run.Run.MaterialIsLeft ? -1 : 1);
            return (along, normal) => normal * (left * cut.At(along));
        }

        var (x, y) = (Component(run, element, c => c.X), Component(run, element, c => c.Y));
        return (along, _) => new(x.At(along), y.At(along));
    }

    // One component of the corrections at the points of an element.
    private ElementCut Component(RunEstimate run, BoundaryElement element, Func<Vector2, double> component)
    {
        BoundaryElement[] elements = [element];
        BoundaryRow[] rows = [
            .. run.Points.Where(p => p.Feature == _features[element]).Select(p => (Point: p, Foot: element.Pass.Feet[p.Index]))
                .Where(p => element.Contains(p.Foot.Motion))
                .Select(p => new BoundaryRow([new(0, element.Pass.Along(p.Foot), 1)], component(p.Point.Wanted)))];
        var u = _job.Gauge.Uncertainty.CombinedMm;
        var field = new DeviationField(PriorChoice.Of(elements, rows, u).OfCuts, rows, u);
        return ElementCut.Following(element, along => field.Mean(0, along));
    }

    // The limit applies between and beyond the points too: a course that swings out there follows no measurement.
    private Refusal? BeyondLimit(DisplacementWish wish)
    {
        var limit = _job.Compensation.LimitMm * Math.Max(1, _job.Compensation.Gain);
        var worst = wish.Elements.MaxBy(Largest);
        if (wish.Elements.Count == 0 || Largest(worst) <= limit)
        {
            return null;
        }

        var block = _path.Motions[worst.Motion].Block;
        var name = _path.Program.NameOf(_path.Program[block]);
        var feature = _maps.FirstOrDefault(m => m.Blocks.Contains(block))?.Feature.Name ?? "";
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
/// <param name="After">The changed program, interpreted, without a marker.</param>
internal sealed record CourseEstimate(DisplacementWish Wish, Rewrite Rewrite, NcPath After);
