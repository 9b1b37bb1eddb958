using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>Chooses where to touch the part before it is measured: as few points as tell its boundary everywhere as well as its limits
/// need it.</summary>
/// <remarks>Each element begins with the points that its kind needs. Then, as long as too little is known somewhere, one more is given to
/// whichever element beside that place narrows it most: near a corner that may be the neighbor. What a choice tells is found by matching
/// parts that are drawn (<see cref="PlanPrediction"/>). Where on the element does not depend on what the points will say: it is the place
/// that narrows the posterior of a Gaussian process most (Rasmussen and Williams, 2006, equation 2.26). A line can be touched anywhere
/// between its outermost key points. Of a curve only its key points are known as designed, so some of them are chosen.</remarks>
public static class TouchPlanner
{
    /// <summary>Code of the refusal of a job with features in other planes than XY.</summary>
    public const string OtherPlane = "plan-plane";

    /// <summary>Code of the refusal of a key point that the ball cannot touch.</summary>
    public const string OutOfReach = "out-of-reach";

    /// <summary>Distance from the part at which a measuring move starts where there is room, mm.</summary>
    public const double ApproachMm = 2;

    // The bound that is wanted, as a part of half the width of the limits; and the least that a gauge can be asked for, in standard
    // uncertainties: that of the worst of many places is no less.
    private const double OfLimits = 0.2;
    private const double LeastOfUncertainty = 5;

    // One point for each 5 mm (Wang 2021, section 2.1), and at least as many as tell more than the shape.
    private const double SpacingMm = 5;
    private const int LeastOfCurve = 4;

    // Two points of a line are no nearer than this, mm; where a key point is nearer than half of it, it is taken instead.
    private const double NearMm = 1;

    // So far from a corner a line is touched, mm: on it, a point tells of both its neighbors, and of neither well.
    private const double CornerMm = 1;

    // By how much more points must narrow the bound to be worth it, the most that are added at once to see whether they do, and the parts
    // that are drawn to choose.
    private const double Worth = 0.97;
    private const int MostAtOnce = 2;
    private const int PartsToChoose = 6;

    // An element that ends so near to a place that is known badly may tell of it, mm.
    private const double BesideMm = 2;

    // How far apart the places of a line are that are tried, mm; and how many places of an element are looked at.
    private const double GridMm = 1;
    private const int Places = 60;

    /// <summary>Chooses the points.</summary>
    /// <param name="job">The job.</param>
    /// <param name="path">The counterpart's program, interpreted.</param>
    /// <param name="theoretical">The key points as designed.</param>
    /// <param name="stylusDiameterMm">Diameter of the ball, mm.</param>
    /// <param name="withinMm">Half the 95 % interval of the error anywhere along the boundary that is wanted, mm; null for a fifth of what
    /// the limits of each feature allow.</param>
    /// <param name="predict">What a plan will tell, by a number of drawn parts.</param>
    /// <returns>The plan with its prediction, or why there is none.</returns>
    /// <exception cref="InputException">A key point is missing. A selector cannot be read.</exception>
    public static Outcome<TouchPlan> Choose(
        MatingJob job,
        NcPath path,
        MeasurementFile theoretical,
        double stylusDiameterMm,
        double? withinMm,
        Func<TouchPlan, int, PlanPrediction> predict)
    {
        if (NotMapped(job, path, theoretical, out var maps) is { } cannot)
        {
            return cannot;
        }

        ArgumentNullException.ThrowIfNull(predict);
        var reach = new ProbeReach(job, path, maps, stylusDiameterMm);
        var elements = new List<Element>();
        var uncertainty = job.Gauge.Uncertainty.CombinedMm;
        for (var f = 0; f < maps.Count; f++)
        {
            var (feature, pass) = (maps[f].Feature, maps[f].Passes[0]);
            BoundaryElement[] stretches = [.. feature.Elements(path, pass)];
            var first = 0;
            for (var k = 0; k < feature.PointLists.Count; k++)
            {
                var count = feature.PointLists[k].Count;
                DesignedPoint[] designed = [
                    .. Enumerable.Range(first, count).Select(i => new DesignedPoint(
                        feature.Points[i],
                        ProjectedPoint.Of(theoretical[feature.Points[i]], feature.Plane, theoretical.File).Position,
                        -maps[f].Normals[i],
                        pass.Along(pass.Feet[i])))];
                var stretch = stretches.Length == feature.PointLists.Count && designed.Length > 1 ? stretches[k] : null;
                if (stretch?.Form == ElementForm.Straight)
                {
                    designed = Straight(designed, [.. Enumerable.Range(first, count).Select(i => pass.Feet[i])]);
                }

                elements.Add(new(f, feature, feature.Kind.LeastPoints[k], designed, stretch, uncertainty, reach, withinMm));
                first += count;
            }
        }

        if (Unreached(elements) is { } refusal)
        {
            return refusal;
        }

        BoundaryElement[] stretched = [.. elements.Select(e => e.Stretch).OfType<BoundaryElement>()];
        foreach (var run in BoundaryRun.Find(path, stretched, job.Counterpart.ToolDiameterMm))
        {
            for (var i = 0; i < run.Elements.Count; i++)
            {
                elements.Find(e => ReferenceEquals(e.Stretch, run.Elements[i]))!.Meets(
                    run.JointAfter(i - 1) is not null, run.JointAfter(i) is not null);
            }
        }

        // One line tells how large the form errors of all are: the longest one can best.
        if (elements.Where(e => e.IsLine && e.FormMm is null).MaxBy(e => e.LengthMm) is { } telling)
        {
            telling.TellsForm();
        }

        var choice = new Choice(job, elements, stylusDiameterMm, predict);
        choice.Narrow();
        return choice.Plan();
    }

    /// <summary>The job's own key points on the part, with their normals.</summary>
    /// <param name="job">The job.</param>
    /// <param name="path">The counterpart's program, interpreted.</param>
    /// <param name="theoretical">The key points as designed.</param>
    /// <param name="stylusDiameterMm">Diameter of the ball, mm.</param>
    /// <param name="approachMm">Distance from the part at which a measuring move starts where there is room, mm.</param>
    /// <returns>The plan, or the points that the ball cannot touch.</returns>
    /// <exception cref="InputException">A key point is missing. A selector cannot be read.</exception>
    public static Outcome<TouchPlan> Own(
        MatingJob job, NcPath path, MeasurementFile theoretical, double stylusDiameterMm, double approachMm)
    {
        if (NotMapped(job, path, theoretical, out var maps) is { } cannot)
        {
            return cannot;
        }

        var reach = new ProbeReach(job, path, maps, stylusDiameterMm);
        var plan = OfMaps(
            maps,
            theoretical,
            stylusDiameterMm,
            (place, normal) => (place, -normal, reach.ApproachMm(place, -normal, approachMm)),
            "it would touch the part elsewhere first");
        return plan.Result is { } own ? own with { Unplaced = reach.Unplaced } : plan;
    }

    /// <summary>The height down to which all features are cut, mm: that of the shallowest one. Null if the program does not say it of each,
    /// or cannot be used.</summary>
    /// <param name="job">The job.</param>
    /// <param name="path">The counterpart's program, interpreted.</param>
    /// <param name="theoretical">The key points as designed.</param>
    /// <exception cref="InputException">A key point is missing. A selector cannot be read.</exception>
    public static double? DepthMm(MatingJob job, NcPath path, MeasurementFile theoretical) =>
        NotMapped(job, path, theoretical, out var maps) is null && maps.All(m => double.IsFinite(ProbeReach.DepthMm(path, [m])))
            ? ProbeReach.DepthMm(path, maps)
            : null;

    /// <summary>The same on the counterpart: places and normals are in the program's frame, normals out of the counterpart's
    /// material.</summary>
    /// <param name="job">The job.</param>
    /// <param name="path">The counterpart's program, interpreted.</param>
    /// <param name="theoretical">The key points as designed.</param>
    /// <param name="stylusDiameterMm">Diameter of the ball, mm.</param>
    /// <param name="approachMm">Distance from the counterpart at which a measuring move starts where there is room, mm.</param>
    /// <param name="touchZ">Height of the ball's center, mm.</param>
    /// <returns>The plan, or the points that the ball cannot touch.</returns>
    /// <exception cref="InputException">A key point is missing. A selector cannot be read.</exception>
    public static Outcome<TouchPlan> OwnOfCounterpart(
        MatingJob job, NcPath path, MeasurementFile theoretical, double stylusDiameterMm, double approachMm, double touchZ)
    {
        if (NotMapped(job, path, theoretical, out var maps) is { } cannot)
        {
            return cannot;
        }

        var (room, frame) = (new ClearedRoom(job, path, maps, stylusDiameterMm, touchZ), job.Counterpart.Frame);
        return OfMaps(
            maps,
            theoretical,
            stylusDiameterMm,
            (place, normal) => (
                frame.Apply(place), frame.Apply(normal), room.ApproachMm(frame.Apply(place), frame.Apply(normal), approachMm)),
            "the job's program does not clear that much beside it, so deep, between the tool changes of the features");
    }

    private static Outcome<TouchPlan> OfMaps(
        IReadOnlyList<FeatureMap> maps,
        MeasurementFile theoretical,
        double stylusDiameterMm,
        Func<Point2, Vector2, (Point2 Place, Vector2 Normal, double? ApproachMm)> touched,
        string why)
    {
        var (features, refusals) = (new List<PlannedFeature>(), new List<Refusal>());
        foreach (var map in maps)
        {
            var i = 0;
            features.Add(new(map.Feature.Name, [
                .. map.Feature.PointLists.Select(l => (IReadOnlyList<PlannedPoint>)[.. l.Select(label => Of(map, label, i++))])]));
        }

        return refusals.Count > 0
            ? Outcome.Refused<TouchPlan>(refusals)
            : new TouchPlan(features, stylusDiameterMm, []);

        PlannedPoint Of(FeatureMap map, string label, int index)
        {
            var (place, normal, approach) = touched(
                ProjectedPoint.Of(theoretical[label], map.Feature.Plane, theoretical.File).Position, map.Normals[index]);
            if (approach is null)
            {
                refusals.Add(NoRoom(map.Feature, label, stylusDiameterMm, why));
            }

            return new(label, place, normal, TouchReason.Kept, approach ?? 0);
        }
    }

    // A line is touched against its own direction, and not on its corners.
    private static DesignedPoint[] Straight(DesignedPoint[] designed, KeyPointFoot[] feet)
    {
        var (first, last) = (designed.MinBy(d => d.AlongMm)!, designed.MaxBy(d => d.AlongMm)!);
        var along = (last.Place - first.Place).Normalize();
        var normal = designed.Aggregate(Vector2.Zero, (sum, d) => sum + d.Normal) is var sum && sum.Dot(along.Left) < 0
            ? -along.Left
            : along.Left;
        return [.. designed.Select((d, i) =>
        {
            var inward = !feet[i].OnCorner ? 0 : (d == first ? 1 : d == last ? -1 : 0) * (feet[i].BeyondEndMm + CornerMm);
            return d with
            {
                Label = inward == 0 ? d.Label : null,
                Place = d.Place + (along * inward),
                Normal = normal,
                AlongMm = d.AlongMm + (Math.Sign(inward) * CornerMm),
            };
        })];
    }

    private static Refusal? NotMapped(MatingJob job, NcPath path, MeasurementFile theoretical, out IReadOnlyList<FeatureMap> maps)
    {
        ArgumentNullException.ThrowIfNull(job);
        ArgumentNullException.ThrowIfNull(path);
        ArgumentNullException.ThrowIfNull(theoretical);
        maps = [];
        return job.Features.FirstOrDefault(f => f.Plane != CoordinatePlane.XY) is { } other
            ? new Refusal(
                OtherPlane,
                $"{other.Name} lies in the plane {other.Plane}; expected features in XY, which a vertical probe touches from the side.",
                new() { Feature = other.Name })
            : path.Refusal ?? FeatureMapper.Map(job, path, theoretical, out maps);
    }

    private static Refusal NoRoom(
        JobFeature feature, string? label, double diameter, string why = "it would touch the part elsewhere first")
    {
        var place = label is null ? "an end" : $"the point {label}";
        return new(
            OutOfReach,
            string.Create(
                CultureInfo.InvariantCulture,
                $"A ball of {diameter:0.###} mm has no room at {place} of {feature.Name}: {why}. Take a smaller ball, or "
                    + $"move the point."),
            new() { Feature = feature.Name });
    }

    private static Refusal? Unreached(List<Element> elements) =>
        elements.Find(e => e.Reached.Count < e.LeastOwn) is { } element
            ? NoRoom(element.Feature, element.Designed.First(d => d.ApproachMm is null).Label, element.Reach.StylusRadiusMm * 2)
            : null;

    // How many points each element gets, and what they tell.
    private sealed class Choice(
        MatingJob job, List<Element> elements, double stylusDiameterMm, Func<TouchPlan, int, PlanPrediction> predict)
    {
        private readonly Dictionary<string, PlanPrediction> _told = new(StringComparer.Ordinal);

        // Features about which more points tell nothing new.
        private readonly HashSet<int> _settled = [];

        // Elements about which one more point told something, in the order in which they got it.
        private readonly List<int> _added = [];

        private int[] _counts = [.. elements.Select(e => e.Least)];

        // Gives points to what is known least until all is known as well as is wanted, or more points tell no more.
        public void Narrow()
        {
            while (Least() is var (feature, bound))
            {
                if (!TellMoreOf(feature, bound))
                {
                    _settled.Add(feature);
                }
            }
        }

        public TouchPlan Plan()
        {
            var fewer = _counts.ToArray();
            foreach (var element in _added.TakeLast(2))
            {
                fewer[element]--;
            }

            // Points that others got since may tell enough.
            var plan = Told(_counts);
            return plan with
            {
                Notes = [.. _settled.Order().Where(f => Share(plan.Prediction!, f) > 1).Select(Note)],
                TwoLess = _added.Count < 2 ? null : Told(fewer),
            };
        }

        private TouchPlan Told(int[] counts) => Of(counts) with { Prediction = Predict(counts, PlanPrediction.Draws) };

        // The feature that is known least, if not well enough. If a few parts say that all is known, all parts decide.
        private (int Feature, PlannedBound Bound)? Least()
        {
            foreach (var parts in new[] { PartsToChoose, PlanPrediction.Draws })
            {
                var told = Predict(_counts, parts);
                var least = told.Parts == 0 ? -1 : Enumerable.Range(0, told.Features.Count)
                    .Where(f => !_settled.Contains(f) && Share(told, f) > 1)
                    .OrderByDescending(f => Share(told, f))
                    .Append(-1).First();
                if (least >= 0)
                {
                    return (least, told.Features[least]);
                }
            }

            return null;
        }

        private bool TellMoreOf(int feature, PlannedBound bound)
        {
            var before = Share(Predict(_counts, PartsToChoose), feature);
            for (var more = 1; more <= MostAtOnce; more++)
            {
                var best = elements.Index()
                    .Where(e => _counts[e.Index] + more <= e.Item.Most && e.Item.IsBeside(feature, bound.Place))
                    .Select(e => (e.Index, Counts: With(e.Index, more)))
                    .Select(e => (e.Index, e.Counts, Share: Share(Predict(e.Counts, PartsToChoose), feature)))
                    .OrderBy(e => e.Share).FirstOrDefault();
                if (best.Counts is not null && best.Share < Worth * before)
                {
                    _counts = best.Counts;
                    _added.AddRange(Enumerable.Repeat(best.Index, more));
                    return true;
                }
            }

            return false;
        }

        private int[] With(int element, int more) => [.. _counts.Select((c, e) => e == element ? c + more : c)];

        // The bound as a part of the one that is wanted.
        private double Share(PlanPrediction told, int feature) =>
            (told.Features[feature].BoundMm ?? double.PositiveInfinity) / elements.Find(e => e.Index == feature)!.WantedMm;

        private PlanPrediction Predict(int[] counts, int parts)
        {
            var key = $"{parts}:{string.Join(' ', counts)}";
            return _told.TryGetValue(key, out var told) ? told : _told[key] = predict(Of(counts), parts);
        }

        private string Note(int feature)
        {
            var own = elements.Where(e => e.Index == feature).ToArray();
            var count = elements.Index().Where(e => e.Item.Index == feature).Sum(e => _counts[e.Index]);
            var bound = Predict(_counts, PlanPrediction.Draws).Features[feature].BoundMm;
            var name = own[0].Feature.Name;
            if (bound is null)
            {
                return $"{name}: {count} points do not tell its form.";
            }

            var isFull = elements.Index().Where(e => e.Item.Index == feature).All(e => _counts[e.Index] >= e.Item.Most);
            var why = !isFull ? "More points tell hardly more" : own[0].IsLine ? "It has room for no more" : "It has no more key points";
            return string.Create(
                CultureInfo.InvariantCulture,
                $"{name}: {count} points tell ±{bound:0.0000} mm at best, ±{own[0].WantedMm:0.0000} mm was wanted. {why}: a better gauge "
                    + $"would.");
        }

        private TouchPlan Of(int[] counts)
        {
            var taken = job.NeededPoints.ToHashSet(StringComparer.Ordinal);
            var next = taken.Select(l => int.TryParse(l, NumberStyles.None, CultureInfo.InvariantCulture, out var n) ? n : 0)
                .Append(0).Max();
            var features = new List<PlannedFeature>();
            for (var f = 0; f < job.Features.Count; f++)
            {
                features.Add(new(job.Features[f].Name, [
                    .. elements.Index().Where(e => e.Item.Index == f).Select(e => (IReadOnlyList<PlannedPoint>)[
                        .. e.Item.Chosen(counts[e.Index]).Select(PointOf)])]));
            }

            return new(features, stylusDiameterMm, []);

            PlannedPoint PointOf(TouchPlace place) => new(place.Label ?? New(), place.At, place.Normal, place.Reason, place.ApproachMm);

            string New() => (++next).ToString(CultureInfo.InvariantCulture);
        }
    }

    // A key point as designed; without a label, a place that stands for one.
    private sealed record DesignedPoint(string? Label, Point2 Place, Vector2 Normal, double AlongMm)
    {
        public double? ApproachMm { get; init; }

        public TouchPlace For(TouchReason reason) => new(Label, Place, Normal, AlongMm, reason, ApproachMm ?? 0);
    }

    // A place to touch; without a label it is a new one.
    private sealed record TouchPlace(string? Label, Point2 At, Vector2 Normal, double AlongMm, TouchReason Reason, double ApproachMm);

    // The points of one list of a feature.
    private sealed class Element
    {
        private readonly double _uncertaintyMm;
        private readonly double _halfWidthMm;

        // The places, the one that tells most first.
        private readonly List<TouchPlace> _places = [];
        private double _fromMm, _toMm;
        private List<TouchPlace>? _others;

        public Element(
            int index,
            JobFeature feature,
            int least,
            DesignedPoint[] designed,
            BoundaryElement? stretch,
            double uncertaintyMm,
            ProbeReach reach,
            double? withinMm)
        {
            (Index, Feature, Stretch, Reach, _uncertaintyMm) = (index, feature, stretch, reach, uncertaintyMm);
            Designed = [.. designed.Select(d => d with { ApproachMm = reach.ApproachMm(d.Place, d.Normal, ApproachMm) })];
            Reached = [.. Designed.Where(d => d.ApproachMm is not null).OrderBy(d => d.AlongMm)];
            _halfWidthMm = feature.Tolerance.Band.WidthMm / 2;
            WantedMm = withinMm ?? Math.Max(OfLimits * _halfWidthMm, LeastOfUncertainty * uncertaintyMm);
            Least = stretch is null ? designed.Length
                : IsLine ? least
                : Math.Min(designed.Length, Math.Max(least, stretch.Degree is { } degree ? degree + 2 : LeastOfCurve));
            if (Reached.Count > 1)
            {
                (_fromMm, _toMm) = (Reached[0].AlongMm, Reached[^1].AlongMm);
                _places.Add(Reached[0].For(TouchReason.End));
                _places.Add(Reached[^1].For(TouchReason.End));
            }
        }

        public int Index { get; }

        public JobFeature Feature { get; }

        public BoundaryElement? Stretch { get; }

        public IReadOnlyList<DesignedPoint> Designed { get; }

        public ProbeReach Reach { get; }

        // The key points that can be touched, along the boundary.
        public List<DesignedPoint> Reached { get; }

        public int Least { get; private set; }

        // How many of them must be key points of the job.
        public int LeastOwn => IsLine ? 2 : Least;

        public double? FormMm => Stretch?.FormMm;

        public double WantedMm { get; }

        public bool IsLine => Stretch?.Form == ElementForm.Straight;

        public double LengthMm => Reached.Count < 2 ? 0 : Reached[^1].AlongMm - Reached[0].AlongMm;

        public int Most => Stretch is null ? Least
            : IsLine ? _places.Count + Others.Count
            : Math.Clamp(1 + (int)Math.Ceiling(LengthMm / SpacingMm), Least, Reached.Count);

        // Where it meets a neighbor, it is compared up to there, beyond its key points.
        public void Meets(bool atStart, bool atEnd)
        {
            if (Reached.Count > 1)
            {
                _fromMm = atStart ? Math.Min(_fromMm, Stretch!.FromMm) : _fromMm;
                _toMm = atEnd ? Math.Max(_toMm, Stretch!.ToMm) : _toMm;
            }
        }

        // A point in the middle tells how large form errors are.
        public void TellsForm()
        {
            var middle = (_places[0].AlongMm + _places[1].AlongMm) / 2;
            if (Others.MinBy(p => Math.Abs(p.AlongMm - middle)) is { } place)
            {
                Least = Math.Max(Least, 3);
                Take(place);
            }
        }

        // Whether its points may tell of a place of a feature: its own, or one beside it.
        public bool IsBeside(int feature, Point2? place) =>
            Index == feature || (place is { } at && Reached.Exists(d => d.Place.DistanceTo(at) < BesideMm + CornerMm));

        // The places of some points. Each place narrows the most of what the earlier ones leave open.
        public TouchPlace[] Chosen(int count)
        {
            if (Stretch is null)
            {
                return [.. Designed.Select(d => d.For(TouchReason.Kept))];
            }

            while (_places.Count < count && Others.MinBy(UncertaintyMm) is { } next)
            {
                Take(next);
            }

            // As the job has its points: its features are cut in the order of their points, or it is refused.
            var places = _places.Take(count).OrderBy(p => p.AlongMm);
            return [.. Designed[0].AlongMm <= Designed[^1].AlongMm ? places : places.Reverse()];
        }

        private List<TouchPlace> Others => _others ??= [.. Possible().Where(p => !IsNear(p))];

        // Curves have their key points, however near to each other.
        private bool IsNear(TouchPlace place) =>
            _places.Exists(p => p.Label is not null && p.Label == place.Label)
                || (IsLine && _places.Exists(p => Math.Abs(p.AlongMm - place.AlongMm) < NearMm));

        private void Take(TouchPlace place)
        {
            _places.Add(place);
            Others.RemoveAll(IsNear);
        }

        // The largest standard deviation anywhere along the element with one more place.
        private double UncertaintyMm(TouchPlace more)
        {
            double[] along = [.. _places.Append(more).Select(p => p.AlongMm)];
            var prior = new DeviationPrior(Stretch!, DeviationPrior.VagueMm, _uncertaintyMm, along)
            {
                Form = Stretch!.Degree is not null ? [] : [PlanPrediction.FormOf(IsLine, LengthMm, _halfWidthMm, _uncertaintyMm, FormMm)],
            };
            var field = new DeviationField(
                [prior], [.. along.Select(a => new BoundaryRow([new RowTerm(0, a, 1)], 0))], _uncertaintyMm);
            return Enumerable.Range(0, Places + 1).Max(k => field.StandardDeviation(0, _fromMm + ((_toMm - _fromMm) * k / Places)));
        }

        // Its key points, and between those of a line a grid.
        private IEnumerable<TouchPlace> Possible()
        {
            foreach (var point in Reached)
            {
                yield return point.For(TouchReason.Form);
            }

            if (!IsLine)
            {
                yield break;
            }

            for (var along = Reached[0].AlongMm; along < Reached[^1].AlongMm; along += GridMm)
            {
                var after = Reached.FindIndex(d => d.AlongMm > along);
                var (from, to) = (Reached[after - 1], Reached[after]);
                var place = from.Place.Lerp(to.Place, (along - from.AlongMm) / (to.AlongMm - from.AlongMm));
                if (Math.Min(along - from.AlongMm, to.AlongMm - along) >= NearMm / 2
                    && Reach.ApproachMm(place, from.Normal, ApproachMm) is { } approach)
                {
                    yield return new(null, place, from.Normal, along, TouchReason.Form, approach);
                }
            }
        }
    }
}
