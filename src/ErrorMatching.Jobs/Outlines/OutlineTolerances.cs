using System.Globalization;
using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Mating;

namespace ErrorMatching.Jobs;

/// <summary>What the tolerances of a model say about the features of a job. A job limits where each point of a feature is. A tolerance
/// becomes limits if it says the same, or if limits exist that fulfil it in any case; what is left is asked.</summary>
internal sealed class OutlineTolerances
{
    // Narrower limits are none, mm.
    private const double LeastMm = 1e-6;

    // A circle may be drawn that much beyond the limits of its size, mm: numbers of files are rounded.
    private const double RoundedMm = 1e-3;

    // Pairs of annotations and features that are looked at; a part with tolerances has some hundred.
    private const int MaxPairs = 2_000_000;
    private const int MostNamed = 6;

    // With these, the model accepts more, or says how to measure: limits without them are not too wide.
    private static readonly string[] Wider = [
        "MAXIMUM_MATERIAL_REQUIREMENT", "LEAST_MATERIAL_REQUIREMENT", "RECIPROCITY_REQUIREMENT", "SEPARATE_REQUIREMENT", "COMMON_ZONE",
        "FREE_STATE"];

    private readonly Drawing _drawing;
    private readonly string _layer;
    private readonly IReadOnlyList<TolerancedFeature> _features;
    private readonly OutlineLaying _laying;
    private readonly CutPath _cuts;
    private readonly Dictionary<long, List<int>> _byFace = [];
    private readonly int[] _faces;
    private readonly int?[] _sides;
    private readonly List<Demand>[] _demands;
    private readonly List<string>[] _reasons;
    private readonly List<string>[] _given;
    private readonly bool[] _isStricter;
    private int _pairs;

    private OutlineTolerances(
        Drawing drawing, string layer, IReadOnlyList<TolerancedFeature> features, OutlineLaying laying, CutPath cuts)
    {
        (_drawing, _layer, _features, _laying, _cuts) = (drawing, layer, features, laying, cuts);
        (_faces, _sides, _demands) = (new int[features.Count], new int?[features.Count], [.. features.Select(_ => new List<Demand>())]);
        _reasons = [.. drawing.Annotations.Select(_ => new List<string>())];
        _given = [.. drawing.Annotations.Select(_ => new List<string>())];
        _isStricter = new bool[drawing.Annotations.Count];
        for (var f = 0; f < features.Count; f++)
        {
            foreach (var face in features[f].Walls.Select(w => w.Face).Distinct())
            {
                _faces[f]++;
                if (!_byFace.TryGetValue(face, out var list))
                {
                    _byFace[face] = list = [];
                }

                list.Add(f);
            }
        }
    }

    /// <summary>Decides.</summary>
    /// <param name="drawing">The drawing.</param>
    /// <param name="layer">The layer of the features.</param>
    /// <param name="features">The features of the job.</param>
    /// <param name="laying">Where the outline lies on the program.</param>
    /// <param name="cuts">What the program cuts.</param>
    /// <returns>The limits of each feature, null for those of which the model says nothing that a job can; each annotation with what became
    /// of it, in file order.</returns>
    public static (IReadOnlyList<OutlineLimits?> Limits, IReadOnlyList<OutlineTolerance> Annotations) Of(
        Drawing drawing, string layer, IReadOnlyList<TolerancedFeature> features, OutlineLaying laying, CutPath cuts)
    {
        if (drawing.Annotations.Count == 0)
        {
            return (new OutlineLimits?[features.Count], []);
        }

        return new OutlineTolerances(drawing, layer, features, laying, cuts).Decide();
    }

    private (IReadOnlyList<OutlineLimits?> Limits, IReadOnlyList<OutlineTolerance> Annotations) Decide()
    {
        for (var a = 0; a < _drawing.Annotations.Count; a++)
        {
            if (!_drawing.Annotations[a].IsAllOver)
            {
                Look(a);
            }
        }

        // What is of the whole part is of those faces of which nothing else is said.
        for (var a = 0; a < _drawing.Annotations.Count; a++)
        {
            if (_drawing.Annotations[a].IsAllOver)
            {
                LookAllOver(a);
            }
        }

        OutlineLimits?[] limits = [.. Enumerable.Range(0, _features.Count).Select(LimitsOf)];
        return (limits, [.. Enumerable.Range(0, _drawing.Annotations.Count).Select(Told)]);
    }

    // One annotation with the features at its faces.
    private void Look(int a)
    {
        var annotation = _drawing.Annotations[a];
        if (NotUnderstood(annotation) is { } why)
        {
            _reasons[a].Add(why);
            return;
        }

        var covered = new SortedDictionary<int, int>();
        foreach (var f in annotation.Faces.SelectMany(face => _byFace.GetValueOrDefault(face) ?? []))
        {
            if (++_pairs > MaxPairs)
            {
                _reasons[a].Add($"more than {MaxPairs} pairs of annotations and features are not looked at");
                return;
            }

            covered[f] = covered.GetValueOrDefault(f) + 1;
        }

        foreach (var (f, count) in covered)
        {
            Demand(a, f, isWhole: count == _faces[f]);
        }

        if (covered.Count == 0)
        {
            _reasons[a].Add(NotHere(annotation));
        }
    }

    private void LookAllOver(int a)
    {
        if (NotUnderstood(_drawing.Annotations[a]) is { } why)
        {
            _reasons[a].Add(why);
            return;
        }

        var isAnywhere = false;
        for (var f = 0; f < _features.Count; f++)
        {
            if (_demands[f].Count == 0)
            {
                isAnywhere = true;
                Demand(a, f, isWhole: true);
            }
        }

        if (!isAnywhere)
        {
            _reasons[a].Add("it is of the whole part, and the features have tolerances of their own");
        }
    }

    // What an annotation demands of a feature: limits, or a reason why there are none.
    private void Demand(int a, int f, bool isWhole)
    {
        var (annotation, feature) = (_drawing.Annotations[a], _features[f]);
        if (!isWhole || !feature.HasAllWalls)
        {
            _reasons[a].Add($"it is of a part of {feature.Name} only, or not all faces there are known");
        }
        else if (!feature.IsUpright)
        {
            _reasons[a].Add(
                $"a face of {feature.Name} is not perpendicular to the drawing as far as is known, so its normal is another one");
        }
        else if ((_sides[f] ??= SideOf(feature)) < 0)
        {
            _reasons[a].Add(
                $"at {feature.Name} the program's tool is outside of the model's material: the model is not the part but its counterpart, "
                    + "whose limits no job has");
        }
        else
        {
            var (demand, why) = annotation.Kind switch
            {
                "surface-profile" or "line-profile" => OfProfile(a, feature, _sides[f]!.Value),
                ModelAnnotation.Size => OfSize(a, feature),
                _ => OfPosition(a, feature),
            };
            if (demand is not null)
            {
                _demands[f].Add(demand);
            }
            else
            {
                _reasons[a].Add(why!);
            }
        }
    }

    private (Demand? Demand, string? Why) OfProfile(int a, TolerancedFeature feature, int side)
    {
        var annotation = _drawing.Annotations[a];
        var width = annotation.Value!.Value;
        if (width < LeastMm)
        {
            return (null, "its zone has no width");
        }

        var isStricter = annotation.Kind == "line-profile" || annotation.Datums.Count == 0 || annotation.Modifiers.Count > 0;
        if (annotation.DisplacementMm is not { } by)
        {
            return (new(a, -width / 2, width / 2, isStricter), null);
        }

        if (_drawing.Standard == ToleranceStandard.Unknown)
        {
            return (null, string.Create(
                CultureInfo.InvariantCulture,
                $"its zone is displaced by {by:0.######} mm, and the file does not name the standard: by ASME Y14.5 it reaches "
                    + $"{by:0.######} mm out of the material and {width - by:0.######} mm into it, by ISO 1101 "
                    + $"{(width / 2) + by:0.######} and {(width / 2) - by:0.######} mm"));
        }

        if (side == 0)
        {
            return (null, $"its zone is displaced, and the file does not say on which side of {feature.Name} the material is: "
                + "no solid has the face");
        }

        // The job's normal points to the tool, which is where the part's material is: out of the material is below.
        var outward = _drawing.Standard == ToleranceStandard.Asme ? by : (width / 2) + by;
        return (new(a, -outward, width - outward, isStricter), null);
    }

    // A circle between two others about its designed center has no size beyond theirs, whatever its form.
    private (Demand? Demand, string? Why) OfSize(int a, TolerancedFeature feature)
    {
        var annotation = _drawing.Annotations[a];
        if (feature.Circle is not { } circle || annotation.Quantity is not ("diameter" or "radius"))
        {
            var what = annotation.Quantity.Length > 0 ? annotation.Quantity : "size";
            return (null, $"no key of a job states the {what} of {feature.Name}, a {feature.Kind}");
        }

        var share = annotation.Quantity == "diameter" ? 0.5 : 1;
        var (lower, upper) = annotation.Limits!.Value;
        var (least, most) = (
            ((annotation.Value!.Value + lower) * share) - circle.Radius, ((annotation.Value.Value + upper) * share) - circle.Radius);
        if (least > RoundedMm || most < -RoundedMm)
        {
            return (null, string.Create(
                CultureInfo.InvariantCulture,
                $"{feature.Name} is drawn with a radius of {circle.Radius:0.######} mm, which is not within its limits"));
        }

        if (most - least < LeastMm)
        {
            return (null, "its limits are equal");
        }

        return OutwardOf(circle) switch
        {
            0 => (null, $"the program does not say on which side of {feature.Name} its tool is"),
            > 0 => (new(a, least, most, true), null),
            _ => (new(a, -most, -least, true), null),
        };
    }

    // The width is the demand: LimitsOf knows the rest.
    private (Demand? Demand, string? Why) OfPosition(int a, TolerancedFeature feature) =>
        feature.Circle is null
            ? (null, $"it is of the center of {feature.Name}, a {feature.Kind}, and limits are of its points")
            : (new(a, 0, 0, true) { PositionMm = _drawing.Annotations[a].Value!.Value }, null);

    // All demands on a feature together.
    private OutlineLimits? LimitsOf(int f)
    {
        var name = _features[f].Name;
        var bands = _demands[f].FindAll(d => d.PositionMm is null);
        var positions = _demands[f].FindAll(d => d.PositionMm is not null);
        if (bands.Count == 0)
        {
            positions.ForEach(p => _reasons[p.Annotation].Add(
                $"it says nothing of the size of {name}, and limits of its points are limits of its size, too"));
            return null;
        }

        var (lower, upper) = (bands.Max(b => b.Lower), bands.Min(b => b.Upper));
        if (upper - lower < LeastMm)
        {
            _demands[f].ForEach(d => _reasons[d.Annotation].Add($"the tolerances of {name} leave nothing between them"));
            return null;
        }

        // Between two circles about the designed center that are w apart, the largest circle inside and the smallest around are at most w
        // off that center. Of a zone of diameter t, that is at most t / 2.
        List<Demand> taken = [.. bands];
        foreach (var position in positions.OrderBy(p => p.PositionMm))
        {
            var most = position.PositionMm!.Value / 2;
            if (most < LeastMm)
            {
                _reasons[position.Annotation].Add($"its zone has no width, so no limits of {name} fulfil it in any case");
                continue;
            }

            if (upper - lower > most)
            {
                var middle = (lower + upper) / 2;
                (lower, upper) = (middle - (most / 2), middle + (most / 2));
            }

            taken.Add(position);
        }

        (lower, upper) = (Math.Round(lower, 6) + 0.0, Math.Round(upper, 6) + 0.0);
        if (Math.Max(-lower, upper) > JobCompensation.Default.LimitMm)
        {
            taken.ForEach(d => _reasons[d.Annotation].Add(string.Create(
                CultureInfo.InvariantCulture,
                $"limits of {name} of {lower:0.######} and {upper:0.######} mm are beyond the {JobCompensation.Default.LimitMm} mm at "
                    + $"which a job stops (compensation.limitMm)")));
            return null;
        }

        foreach (var demand in taken)
        {
            _given[demand.Annotation].Add(name);
            _isStricter[demand.Annotation] |= demand.IsStricter;
        }

        return new(lower, upper, string.Join("; ", taken.Take(MostNamed).Select(d => Title(_drawing.Annotations[d.Annotation])))
            + (taken.Count > MostNamed ? "; ..." : ""));
    }

    private OutlineTolerance Told(int a)
    {
        var annotation = _drawing.Annotations[a];
        var isAngle = annotation is { IsDimension: true, Value: not null, UnitMm: null };
        return new(annotation.Name, annotation.Entity, annotation.Line, annotation.Kind)
        {
            ValueMm = isAngle ? null : Rounded(annotation.Value),
            ValueDegrees = isAngle ? Rounded(annotation.Value) : null,
            Lower = Rounded(annotation.Limits?.Lower),
            Upper = Rounded(annotation.Limits?.Upper),
            UnitMm = annotation.UnitMm,
            Datums = annotation.Datums,
            Faces = [.. annotation.Faces.Select(face => string.Create(CultureInfo.InvariantCulture, $"#{face}"))],
            Features = _given[a],
            Became = _given[a].Count == 0 ? OutlineTolerance.Asked
                : _isStricter[a] ? OutlineTolerance.StricterLimits
                : OutlineTolerance.Limits,
            Reason = string.Join("; ", ReasonsOf(a)),
        };
    }

    private IEnumerable<string> ReasonsOf(int a)
    {
        var annotation = _drawing.Annotations[a];
        if (_given[a].Count > 0)
        {
            yield return annotation.Kind switch
            {
                ModelAnnotation.Size => "the limits of the points keep the size within its limits, and hold the place as well",
                "position" => "the limits of the points are so narrow that the center is in the zone whatever the form is",
                _ when annotation.DisplacementMm is not null => "its zone, as far out of the material and into it as it says",
                _ => "half of its zone to each side of the outline",
            };
            if (annotation.Datums.Count > 0)
            {
                yield return $"measured in the frame of its datums {string.Join(", ", annotation.Datums)}";
            }
            else if (annotation.Kind.EndsWith("profile", StringComparison.Ordinal))
            {
                yield return "it has no datums, so the model lets its zone move, and the limits do not";
            }

            if (annotation.Modifiers.Count > 0)
            {
                yield return $"without {string.Join(", ", annotation.Modifiers)}, by which more may be accepted";
            }
        }

        foreach (var reason in _reasons[a].Distinct(StringComparer.Ordinal).Take(MostNamed))
        {
            yield return reason;
        }
    }

    // Why an annotation says nothing that a job could, wherever it is.
    private static string? NotUnderstood(ModelAnnotation annotation) =>
        annotation.Problem is { } problem ? $"not understood: {problem}"
            : annotation.Others.FirstOrDefault(o => o.Contains("BETWEEN_SHAPE_ASPECT", StringComparison.Ordinal)) is { } between
                ? $"not understood: {between} ends within faces"
            : annotation.IsLowerSegment ? "it is the lower segment of a composite tolerance, whose zone moves within that of the upper one"
            : annotation.Modifiers.FirstOrDefault(m => !Wider.Contains(m)) is { } modifier
                ? modifier.Contains("theoretical", StringComparison.OrdinalIgnoreCase)
                    ? "it is theoretically exact (basic), so it has no limits of its own"
                    : $"not understood: {modifier}"
            : annotation.Kind switch
            {
                "surface-profile" or "line-profile" or "position" => null,
                ModelAnnotation.Size => annotation.Fit.Length > 0
                    ? $"its limits are the fit {annotation.Fit}, which ISO 286 says and the file does not"
                    : annotation.Limits is null ? "it has no limits of its own" : null,
                ModelAnnotation.Location =>
                    "it is a distance between two features, and limits say where each one is; a link of toleranceChain can state it",
                ModelAnnotation.Angle => "it is an angle, which no key of a job limits",
                "flatness" or "straightness" or "roundness" or "cylindricity" =>
                    "it is of the form alone, wherever the feature is, and limits are of its place",
                "parallelism" or "perpendicularity" or "angularity" =>
                    "it is of the direction alone, wherever the feature is, and limits are of its place",
                var kind => $"no key of a job states a tolerance of {kind}",
            };

    private string NotHere(ModelAnnotation annotation) =>
        annotation.Faces.Any(face => _layer == string.Create(CultureInfo.InvariantCulture, $"#{face}"))
            ? "it is of the drawn face itself, whose deviations are heights"
            : annotation.Faces.Count > 0 ? $"no face of it meets the outline {_layer} at a feature of the job"
            : annotation.Others.Count > 0 ? $"it is of {string.Join(", ", annotation.Others.Take(MostNamed))}, and of no face"
            : "it leads to no geometry: no GEOMETRIC_ITEM_SPECIFIC_USAGE of its shape aspect";

    // 1 if the tool is on the side of the model's material, as the tool of a counterpart is; -1 if not; 0 if the file does not say it.
    private int SideOf(TolerancedFeature feature)
    {
        var side = 0;
        foreach (var curve in feature.Elements.SelectMany(e => e.Curves))
        {
            var at = _laying.Frame.Apply(curve.AtLength(curve.LengthMm / 2));
            foreach (var outward in curve.Walls.Select(w => w.Outward).OfType<Vector2>())
            {
                if (_cuts.FootOf(at, _laying.RadiusMm + OutlineLaying.CoverMm) is not { } foot)
                {
                    continue;
                }

                if (foot.ToTool(at).Dot(_laying.Frame.Apply(outward)) > 0)
                {
                    return -1;
                }

                side = 1;
            }
        }

        return side;
    }

    // 1 if the tool is outside of a circle, -1 if it is inside, 0 if it is nowhere near.
    private int OutwardOf(DrawnArc circle)
    {
        var at = _laying.Frame.Apply(circle.From);
        return _cuts.FootOf(at, _laying.RadiusMm + OutlineLaying.CoverMm) is { } foot
            ? Math.Sign(foot.ToTool(at).Dot(at - _laying.Frame.Apply(circle.Center)))
            : 0;
    }

    private static string Title(ModelAnnotation annotation) =>
        annotation.Name.Length > 0 ? $"{annotation.Name} ({annotation.Entity})" : annotation.Entity;

    private static double? Rounded(double? value) => value is { } number ? Math.Round(number, 9) + 0.0 : null;
}

/// <summary>A feature of a job to be limited.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Kind">The word of its kind.</param>
/// <param name="Elements">The elements of the outline that it is of.</param>
internal sealed record TolerancedFeature(string Name, string Kind, IReadOnlyList<OutlineElement> Elements)
{
    /// <summary>The faces that meet the drawn one there.</summary>
    public IReadOnlyList<DrawnWall> Walls { get; } = [.. Elements.SelectMany(e => e.Curves).SelectMany(c => c.Walls)];

    /// <summary>True if those faces are perpendicular to the drawing.</summary>
    public bool IsUpright { get; } = Elements.SelectMany(e => e.Curves).All(c => c.Walls.All(w => w.IsUpright));

    /// <summary>True if all of it has such faces.</summary>
    public bool HasAllWalls { get; } = Elements.SelectMany(e => e.Curves).All(c => c.Walls.Count > 0);

    /// <summary>The circle that it is; null if it is none.</summary>
    public DrawnArc? Circle => Elements is [{ Curves: [DrawnArc { IsCircle: true } circle] }] ? circle : null;
}

/// <summary>Limits of a feature that a model states.</summary>
/// <param name="Lower">The lower limit, mm.</param>
/// <param name="Upper">The upper limit, mm.</param>
/// <param name="From">The names of the annotations.</param>
internal sealed record OutlineLimits(double Lower, double Upper, string From);

/// <summary>What an annotation demands of a feature.</summary>
/// <param name="Annotation">Its position.</param>
/// <param name="Lower">The lower limit of the points, mm.</param>
/// <param name="Upper">The upper limit.</param>
/// <param name="IsStricter">True if the annotation demands less.</param>
internal sealed record Demand(int Annotation, double Lower, double Upper, bool IsStricter)
{
    /// <summary>Of a position the diameter of its zone, mm; null if the limits are the demand.</summary>
    public double? PositionMm { get; init; }
}
