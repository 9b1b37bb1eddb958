using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>Chooses where to touch the part before it is measured: as few points as tell its boundary everywhere as well as its limits
/// need it.</summary>
/// <remarks>What is known of an element by n points does not depend on what they will say, only on where they are: it is the posterior of
/// a Gaussian process (Rasmussen and Williams, 2006, equation 2.26). A line can be touched anywhere between its outermost key points. Of
/// a curve only its key points are known as designed, so some of them are chosen.</remarks>
public static class TouchPlanner
{
    /// <summary>Code of the refusal of a job with features in other planes than XY.</summary>
    public const string OtherPlane = "plan-plane";

    /// <summary>Code of the refusal of a key point that the ball cannot touch.</summary>
    public const string OutOfReach = "out-of-reach";

    /// <summary>Distance from the part at which a measuring move starts where there is room, mm.</summary>
    public const double ApproachMm = 2;

    // The bound that is wanted, as a part of half the width of the limits; and the least that a gauge can be asked for, in standard
    // uncertainties: few points cannot tell much less than each of them does.
    private const double OfLimits = 0.2;
    private const double LeastOfUncertainty = 2;
    private const double WithoutLimits = 2.5;

    // One point for each 5 mm (Wang 2021, section 2.1), and at least as many as tell more than the shape.
    private const double SpacingMm = 5;
    private const int LeastOfCurve = 4;

    // Where there is a key point so near, no other one is taken, mm.
    private const double NearMm = 2;

    // So far from a corner a line is touched, mm: on it, a point tells of both its neighbors, and of neither well.
    private const double CornerMm = 1;

    /// <summary>The form of a part before it is measured: over how much of a curve deviations are alike, mm (half waves of 45 mm), and how
    /// large they are, as a part of half the width of the limits.</summary>
    internal const double CurveMm = 15, OfHalfWidth = 0.25;

    /// <summary>The same of a line, as a part of its length, and of the uncertainty of a point.</summary>
    internal const double LinePart = 0.25, OfUncertainty = 1;

    // Places at which an element is looked at, and by how much two more points must narrow the bound to be worth it.
    private const int Places = 60;
    private const double Worth = 0.97;

    // Where a place of a line cannot be touched, the next one that can is not further than this, mm.
    private const double AsideMm = 5;
    private const double AsideStepMm = 0.25;

    /// <summary>Chooses the points.</summary>
    /// <param name="job">The job.</param>
    /// <param name="path">The counterpart's program, interpreted.</param>
    /// <param name="theoretical">The key points as designed.</param>
    /// <param name="stylusDiameterMm">Diameter of the ball, mm.</param>
    /// <param name="withinMm">Half the 95 % interval that is wanted at each place, mm; null for a fifth of what the limits allow.</param>
    /// <returns>The plan, or why there is none.</returns>
    /// <exception cref="InputException">A key point is missing. A selector cannot be read.</exception>
    public static Outcome<TouchPlan> Choose(
        MatingJob job, NcPath path, MeasurementFile theoretical, double stylusDiameterMm, double? withinMm)
    {
        if (NotMapped(job, path, theoretical, out var maps) is { } cannot)
        {
            return cannot;
        }

        var reach = new ProbeReach(job, path, maps, stylusDiameterMm);
        var notes = new List<string>();
        var elements = new List<Element>();
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

                elements.Add(new(
                    f, feature, feature.Kind.LeastPoints[k], designed, stretch, job.Gauge.Uncertainty.CombinedMm, reach, withinMm));
                first += count;
            }
        }

        // One line tells how large the form errors of all are: the longest one can best.
        if (elements.Where(e => e.IsLine && e.FormMm is null).MaxBy(e => e.LengthMm) is { } telling)
        {
            telling.Least = Math.Max(telling.Least, 3);
        }

        if (Unreached(elements) is { } refusal)
        {
            return refusal;
        }

        int[] counts = [.. elements.Select(e => e.Enough(notes))];
        return PlanOf(job, elements, counts, stylusDiameterMm, notes) with { TwoLess = WithTwoLess() };

        TouchPlan? WithTwoLess()
        {
            var fewer = counts.ToArray();
            for (var k = 0; k < 2; k++)
            {
                var least = Enumerable.Range(0, fewer.Length).Where(e => fewer[e] > elements[e].Least)
                    .OrderBy(e => elements[e].BoundMm(fewer[e] - 1) / elements[e].WantedMm).Append(-1).First();
                if (least < 0)
                {
                    return null;
                }

                fewer[least]--;
            }

            return PlanOf(job, elements, fewer, stylusDiameterMm, []);
        }
    }

    /// <summary>The job's own key points on the part, with their normals.</summary>
    /// <param name="job">The job.</param>
    /// <param name="path">The counterpart's program, interpreted.</param>
    /// <param name="theoretical">The key points as designed.</param>
    /// <param name="stylusDiameterMm">Diameter of the ball, mm.</param>
    /// <param name="approachMm">Distance from the part at which a measuring move starts where there is room, mm.</param>
    /// <param name="touchZ">Height of the ball's center, mm.</param>
    /// <returns>The plan, or the points that the ball cannot touch.</returns>
    /// <exception cref="InputException">A key point is missing. A selector cannot be read.</exception>
    public static Outcome<TouchPlan> Own(
        MatingJob job, NcPath path, MeasurementFile theoretical, double stylusDiameterMm, double approachMm, double touchZ)
    {
        if (NotMapped(job, path, theoretical, out var maps) is { } cannot)
        {
            return cannot;
        }

        var reach = new ProbeReach(job, path, maps, stylusDiameterMm, touchZ);
        return OfMaps(
            maps,
            theoretical,
            stylusDiameterMm,
            (place, normal) => (place, -normal, reach.ApproachMm(place, -normal, approachMm)),
            "it would touch the part elsewhere first");
    }

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

        var (room, frame) = (new ClearedRoom(job, path, stylusDiameterMm, touchZ), job.Counterpart.Frame);
        return OfMaps(
            maps,
            theoretical,
            stylusDiameterMm,
            (place, normal) => (
                frame.Apply(place), frame.Apply(normal), room.ApproachMm(frame.Apply(place), frame.Apply(normal), approachMm)),
            "the job's program does not clear that much beside it, so deep");
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

    private static TouchPlan PlanOf(
        MatingJob job, List<Element> elements, int[] counts, double stylusDiameterMm, IReadOnlyList<string> notes)
    {
        var taken = job.NeededPoints.ToHashSet(StringComparer.Ordinal);
        var next = taken.Select(l => int.TryParse(l, NumberStyles.None, CultureInfo.InvariantCulture, out var n) ? n : 0)
            .Append(0).Max();
        var features = new List<PlannedFeature>();
        for (var f = 0; f < job.Features.Count; f++)
        {
            features.Add(new(job.Features[f].Name, [
                .. elements.Index().Where(e => e.Item.Index == f).Select(e => (IReadOnlyList<PlannedPoint>)[
                    .. e.Item.Chosen(counts[e.Index]).Select(Of)])]));
        }

        return new(features, stylusDiameterMm, notes);

        PlannedPoint Of(Place place) => new(place.Label ?? New(), place.At, place.Normal, place.Reason, place.ApproachMm);

        string New() => (++next).ToString(CultureInfo.InvariantCulture);
    }

    // A key point as designed; without a label, a place that stands for one.
    private sealed record DesignedPoint(string? Label, Point2 Place, Vector2 Normal, double AlongMm)
    {
        public double? ApproachMm { get; init; }

        public TouchPlanner.Place For(TouchReason reason) => new(Label, Place, Normal, AlongMm, reason, ApproachMm ?? 0);
    }

    // A place to touch; without a label it is a new one.
    private sealed record Place(string? Label, Point2 At, Vector2 Normal, double AlongMm, TouchReason Reason, double ApproachMm);

    // The points of one list of a feature.
    private sealed class Element
    {
        private readonly Stretch? _stretch;
        private readonly double _uncertaintyMm;
        private readonly double _amplitudeMm;
        private readonly Dictionary<int, Place[]> _chosen = [];

        public Element(
            int index,
            JobFeature feature,
            int least,
            DesignedPoint[] designed,
            Stretch? stretch,
            double uncertaintyMm,
            ProbeReach reach,
            double? withinMm)
        {
            (Index, Feature, _stretch, _uncertaintyMm, Reach) = (index, feature, stretch, uncertaintyMm, reach);
            Designed = [.. designed.Select(d => d with { ApproachMm = reach.ApproachMm(d.Place, d.Normal, ApproachMm) })];
            Reached = [.. Designed.Where(d => d.ApproachMm is not null).OrderBy(d => d.AlongMm)];
            var half = feature.Tolerance.Band.WidthMm / 2;
            _amplitudeMm = half > 0 ? OfHalfWidth * half : WithoutLimits * uncertaintyMm;
            WantedMm = withinMm
                ?? (half > 0 ? Math.Max(OfLimits * half, LeastOfUncertainty * uncertaintyMm) : WithoutLimits * uncertaintyMm);
            Least = stretch is null ? designed.Length
                : IsLine ? least
                : Math.Min(designed.Length, Math.Max(least, stretch.Degree is { } degree ? degree + 2 : LeastOfCurve));
        }

        public int Index { get; }

        public JobFeature Feature { get; }

        public IReadOnlyList<DesignedPoint> Designed { get; }

        public ProbeReach Reach { get; }

        // The key points that can be touched, along the boundary.
        public List<DesignedPoint> Reached { get; }

        public int Least { get; set; }

        // How many of them must be key points of the job.
        public int LeastOwn => IsLine ? 2 : Least;

        public double? FormMm => _stretch?.FormMm;

        public double WantedMm { get; }

        public bool IsLine => _stretch?.Form == ElementForm.Straight;

        public double LengthMm => Reached.Count < 2 ? 0 : Reached[^1].AlongMm - Reached[0].AlongMm;

        private int Most => IsLine
            ? LengthMm < 2 * NearMm ? Least : Math.Max(Math.Max(Least, 3), 1 + (int)(LengthMm / SpacingMm))
            : Math.Clamp(1 + (int)Math.Ceiling(LengthMm / SpacingMm), Least, Reached.Count);

        // How many points are enough.
        public int Enough(List<string> notes)
        {
            if (_stretch is null)
            {
                return Designed.Count;
            }

            var (count, most) = (Least, Most);
            while (count < most && BoundMm(count) > WantedMm && BoundMm(Math.Min(most, count + 2)) < Worth * BoundMm(count))
            {
                count++;
            }

            if (BoundMm(count) > WantedMm)
            {
                var why = count < most ? "More points tell hardly more" : IsLine ? "It has room for no more" : "It has no more key points";
                notes.Add(string.Create(
                    CultureInfo.InvariantCulture,
                    $"{Feature.Name}: {count} points tell ±{BoundMm(count):0.0000} mm at best, ±{WantedMm:0.0000} mm was wanted. {why}: "
                        + $"a better gauge would."));
            }

            return count;
        }

        // Half the 95 % interval at the place of which a number of points tells least.
        public double BoundMm(int count)
        {
            if (_stretch is null)
            {
                return 0;
            }

            double[] along = [.. Chosen(count).Select(c => c.AlongMm)];
            var prior = new DeviationPrior(_stretch, DeviationPrior.VagueMm, _uncertaintyMm, along)
            {
                Form = _stretch.Degree is not null ? []
                    : IsLine ? [(Square(_stretch.FormMm ?? (OfUncertainty * _uncertaintyMm)), LinePart * LengthMm)]
                    : [(Square(_amplitudeMm), CurveMm)],
            };
            var field = new DeviationField(
                [prior], [.. along.Select(a => new BoundaryRow([new RowTerm(0, a, 1)], 0))], _uncertaintyMm);
            return PredictedError.Factor95 * Enumerable.Range(0, Places + 1).Max(
                k => field.StandardDeviation(0, Reached[0].AlongMm + (LengthMm * k / Places)));
        }

        // A number of places, as equally spaced as can be, from the first to the last.
        public Place[] Chosen(int count)
        {
            if (_stretch is null)
            {
                return [.. Designed.Select(d => d.For(TouchReason.Kept))];
            }

            if (_chosen.TryGetValue(count, out var known))
            {
                return known;
            }

            var left = Reached.ToList();
            var places = new List<Place>();
            for (var k = 0; k < count; k++)
            {
                var at = Reached[0].AlongMm + (LengthMm * k / (count - 1));
                var reason = k == 0 || k == count - 1 ? TouchReason.End : TouchReason.Form;
                var nearest = left.MinBy(d => Math.Abs(d.AlongMm - at));
                if (nearest is not null && (!IsLine || Math.Abs(nearest.AlongMm - at) < NearMm || k == 0 || k == count - 1))
                {
                    left.Remove(nearest);
                    places.Add(nearest.For(reason));
                }
                else if (IsLine && Beside(at) is { } place)
                {
                    places.Add(place);
                }
            }

            return _chosen[count] = [.. InOrderOfJob(places)];
        }

        // As the job has its points: its features are cut in the order of their points, or it is refused.
        private IEnumerable<Place> InOrderOfJob(List<Place> places) =>
            Designed[0].AlongMm <= Designed[^1].AlongMm ? places.OrderBy(p => p.AlongMm) : places.OrderByDescending(p => p.AlongMm);

        // The place of a line that is nearest to a length along it and can be touched.
        private Place? Beside(double at)
        {
            for (var aside = 0.0; aside <= AsideMm; aside += AsideStepMm)
            {
                foreach (var along in aside == 0 ? [at] : new[] { at - aside, at + aside })
                {
                    if (along < Reached[0].AlongMm || along > Reached[^1].AlongMm)
                    {
                        continue;
                    }

                    var after = Math.Max(1, Reached.FindIndex(d => d.AlongMm >= along));
                    var (from, to) = (Reached[after - 1], Reached[after]);
                    var place = from.Place.Lerp(to.Place, (along - from.AlongMm) / (to.AlongMm - from.AlongMm));
                    if (Reach.ApproachMm(place, from.Normal, ApproachMm) is { } approach)
                    {
                        return new(null, place, from.Normal, along, TouchReason.Form, approach);
                    }
                }
            }

            return null;
        }

        private static double Square(double value) => value * value;
    }
}
