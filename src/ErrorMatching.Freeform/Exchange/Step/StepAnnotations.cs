using System.Globalization;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Reads the dimensions and tolerances of a STEP file. What is wrong in one is said of it, and the others are read.</summary>
internal sealed class StepAnnotations
{
    private const int MaxName = 200;

    // Faces of all annotations together: each may be of all faces.
    private const int MaxFaces = 2_000_000;

    private readonly StepFile _file;
    private readonly Func<double, double> _correct;
    private readonly StepAspects _aspects;
    private readonly Dictionary<long, List<StepInstance>> _nominals = [];
    private readonly Dictionary<long, List<StepInstance>> _ranges = [];
    private readonly Dictionary<long, string> _callouts = [];
    private readonly Dictionary<long, List<string>> _zones = [];
    private readonly HashSet<long> _lower = [];
    private int _faces;

    private StepAnnotations(StepFile file, Func<double, double> correct)
    {
        (_file, _correct, _aspects) = (file, correct, new(file));
        foreach (var record in Simple("DIMENSIONAL_CHARACTERISTIC_REPRESENTATION"))
        {
            Try(() => Add(_nominals, Id(record, 0), record.Instance(1)));
        }

        foreach (var record in Simple("PLUS_MINUS_TOLERANCE"))
        {
            Try(() => Add(_ranges, Id(record, 1), record.Instance(0)));
        }

        foreach (var record in Simple("DRAUGHTING_MODEL_ITEM_ASSOCIATION", "DRAUGHTING_MODEL_ITEM_ASSOCIATION_WITH_PLACEHOLDER"))
        {
            Try(() =>
            {
                if (record.Instance(4).Name is { Length: > 0 } name)
                {
                    _callouts.TryAdd(Id(record, 2), name);
                }
            });
        }

        foreach (var record in Simple("GEOMETRIC_TOLERANCE_RELATIONSHIP"))
        {
            Try(() => _ = record.Text(0) == "composite" && _lower.Add(Id(record, 3)));
        }

        ReadZones();
    }

    /// <summary>Reads all of them, in file order.</summary>
    /// <param name="file">The file.</param>
    /// <param name="correct">What a unit of length really is, by what the file states.</param>
    public static IReadOnlyList<ModelAnnotation> Of(StepFile file, Func<double, double> correct)
    {
        long[] ids = [.. file.Ids(k => k is { Length: > 0 } ? IsAnnotation(k) : true).Where(id => IsMeant(file, id))];
        if (ids.Length == 0)
        {
            return [];
        }

        var reader = new StepAnnotations(file, correct);
        return [.. ids.Select(reader.Read).OfType<ModelAnnotation>()];
    }

    /// <summary>The standard that a file names as one of its documents.</summary>
    public static ToleranceStandard StandardOf(StepFile file)
    {
        var (asme, iso) = (false, false);
        foreach (var id in file.Ids(k => k == "PRODUCT"))
        {
            asme |= file.Contains(id, "'ASME Y14.5'") || file.Contains(id, "'ASME Y14.5-") || file.Contains(id, "'ASME Y14.5M");
            iso |= file.Contains(id, "'ISO 1101");
        }

        return asme == iso ? ToleranceStandard.Unknown : asme ? ToleranceStandard.Asme : ToleranceStandard.Iso;
    }

    private static bool IsAnnotation(string keyword) => keyword is "DIMENSIONAL_SIZE" or "DIMENSIONAL_LOCATION" or "ANGULAR_SIZE"
        or "ANGULAR_LOCATION" or "DIMENSIONAL_SIZE_WITH_PATH" or "DIMENSIONAL_LOCATION_WITH_PATH" or "DIRECTED_DIMENSIONAL_LOCATION"
        or "DIMENSIONAL_SIZE_WITH_DATUM_FEATURE" or "DIMENSIONAL_LOCATION_WITH_DATUM_FEATURE"
        || IsTolerance(keyword);

    private static bool IsTolerance(string keyword) =>
        (keyword.EndsWith("_TOLERANCE", StringComparison.Ordinal) && keyword is not "PLUS_MINUS_TOLERANCE")
            || keyword.StartsWith("GEOMETRIC_TOLERANCE_WITH_", StringComparison.Ordinal);

    // Of complex instances, nothing is parsed that has no such word in it: most are surfaces.
    private static bool IsMeant(StepFile file, long id) => file.Contains(id, "TOLERANCE") || file.Contains(id, "DIMENSIONAL_SIZE")
        || file.Contains(id, "DIMENSIONAL_LOCATION") || file.Contains(id, "ANGULAR_SIZE") || file.Contains(id, "ANGULAR_LOCATION");

    private ModelAnnotation? Read(long id)
    {
        var empty = new ModelAnnotation(
            id, _file.LineOf(id), string.Create(CultureInfo.InvariantCulture, $"#{id}"), "", "tolerance");
        try
        {
            var instance = _file.At(id)!;
            var kinds = instance.Records.Select(r => r.Keyword).Where(IsAnnotation).ToArray();
            if (kinds.Length == 0)
            {
                return null;
            }

            var known = Named(empty, instance, kinds);
            try
            {
                return known.IsDimension ? Dimension(known, instance) : Tolerance(known, instance);
            }
            catch (InputException e)
            {
                return known with { Problem = Told(e) };
            }
        }
        catch (InputException e)
        {
            return empty with { Problem = Told(e) };
        }
    }

    private static string Told(InputException e) => e.Place.Line is { } line
        ? string.Create(CultureInfo.InvariantCulture, $"{e.Problem} (line {line})")
        : e.Problem;

    private ModelAnnotation Named(ModelAnnotation empty, StepInstance instance, string[] kinds)
    {
        var word = kinds.FirstOrDefault(k => k.StartsWith("ANGULAR_", StringComparison.Ordinal))
            ?? kinds.FirstOrDefault(k => k.StartsWith("DIMENSIONAL_", StringComparison.Ordinal) || k.Contains("_DIMENSIONAL_"))
            ?? kinds.FirstOrDefault(k => !k.Contains("GEOMETRIC_TOLERANCE", StringComparison.Ordinal))
            ?? "GEOMETRIC_TOLERANCE";
        var kind = word is "ANGULAR_SIZE" or "ANGULAR_LOCATION" ? ModelAnnotation.Angle
            : word.Contains("_SIZE", StringComparison.Ordinal) ? ModelAnnotation.Size
            : word.Contains("_LOCATION", StringComparison.Ordinal) ? ModelAnnotation.Location
            : word == "GEOMETRIC_TOLERANCE" ? "tolerance"
            : word[..^"_TOLERANCE".Length].ToLowerInvariant().Replace('_', '-');
        var own = kind is ModelAnnotation.Size or ModelAnnotation.Location or ModelAnnotation.Angle ? ""
            : (instance.Find("GEOMETRIC_TOLERANCE") ?? instance.Records[0]).Values is
            [{ Kind: StepValueKind.Text, Text: var name }, ..]
            ? name.Trim() : "";
        own = own.Length > 0 ? own : _callouts.GetValueOrDefault(instance.Id) ?? "";
        return empty with
        {
            Entity = string.Create(CultureInfo.InvariantCulture, $"#{instance.Id} {word}"),
            Kind = kind,
            Name = own.Length > MaxName ? own[..MaxName] : own,
        };
    }

    private ModelAnnotation Dimension(ModelAnnotation known, StepInstance instance)
    {
        if (known.Kind == ModelAnnotation.Location || known.Entity.EndsWith("_LOCATION", StringComparison.Ordinal))
        {
            var between = instance.Find("SHAPE_ASPECT_RELATIONSHIP") ?? instance.Records[0];
            var (one, other) = (Shape(between, 2), Shape(between, 3));
            known = known with
            {
                Quantity = between.Text(0),
                Faces = [.. one.Faces.Concat(other.Faces).Distinct().Order()],
                Others = [.. one.Others.Concat(other.Others).Distinct(StringComparer.Ordinal)],
            };
        }
        else
        {
            // Alone, a dimension that is a datum feature has the attributes of that first.
            var size = instance.Records.First(r => r.Keyword is "DIMENSIONAL_SIZE" or "ANGULAR_SIZE" or "DIMENSIONAL_SIZE_WITH_PATH"
                || instance.Records.Count == 1);
            var at = size.Keyword == "DIMENSIONAL_SIZE_WITH_DATUM_FEATURE" ? 5 : 1;
            var shape = Counted(size, _aspects.Of(instance));
            known = known with { Quantity = size.Text(at), Faces = shape.Faces, Others = shape.Others, IsAllOver = shape.IsWhole };
        }

        return WithLimits(WithNominal(known));
    }

    private AspectShape Shape(StepRecord owner, int index) => Counted(owner, _aspects.Of(owner.Instance(index)));

    private AspectShape Counted(StepRecord owner, AspectShape shape) =>
        (_faces += Math.Min(shape.Faces.Count + shape.Others.Count, MaxFaces)) <= MaxFaces
            ? shape
            : throw Uncounted(owner, _faces = MaxFaces);

    private static InputException Uncounted(StepRecord owner, int most) => owner.Fail("too-large", string.Create(
        CultureInfo.InvariantCulture, $"more than {most} faces in all dimensions and tolerances together"));

    private ModelAnnotation WithNominal(ModelAnnotation known)
    {
        var (values, modifiers) = (new Dictionary<string, StepMeasure>(StringComparer.Ordinal), new List<string>());
        foreach (var representation in _nominals.GetValueOrDefault(known.Number) ?? [])
        {
            var record = representation.Records.FirstOrDefault(r => r.Values is [_, { Kind: StepValueKind.List }, ..])
                ?? throw representation.Records[0].Fail("bad-instance", "a representation without items");
            foreach (var item in record.Instances(1))
            {
                if (!StepMeasure.Is(item))
                {
                    if (item.Records is [{ Keyword: "DESCRIPTIVE_REPRESENTATION_ITEM" } text] && text.Text(1) is { Length: > 0 } word)
                    {
                        modifiers.Add(word);
                    }

                    continue;
                }

                var name = item.Name.ToLowerInvariant();
                values.TryAdd(name is "upper limit" or "lower limit" ? name : "", StepMeasure.Of(item, _correct));
                modifiers.AddRange(Qualifiers(item));
            }
        }

        known = known with { Modifiers = modifiers };
        if (values.TryGetValue("upper limit", out var upper) && values.TryGetValue("lower limit", out var lower))
        {
            var middle = values.TryGetValue("", out var stated) ? stated.Value : (lower.Value + upper.Value) / 2;
            return Ordered(known with
            {
                Value = middle,
                UnitMm = upper.IsAngle ? null : upper.UnitMm,
                Limits = (lower.Value - middle, upper.Value - middle),
            });
        }

        return values.TryGetValue("", out var nominal)
            ? known with { Value = nominal.Value, UnitMm = nominal.IsAngle ? null : nominal.UnitMm }
            : known with { Problem = "it has no value: no length or angle is in its SHAPE_DIMENSION_REPRESENTATION" };
    }

    private static IEnumerable<string> Qualifiers(StepInstance item) => item.Find("QUALIFIED_REPRESENTATION_ITEM") is not { } qualified
        ? []
        : qualified.Instances(qualified.Values.Count - 1).Where(q => q.Keyword == "TYPE_QUALIFIER").Select(q => q.Records[0].Text(0));

    private ModelAnnotation WithLimits(ModelAnnotation known)
    {
        if (!_ranges.TryGetValue(known.Number, out var ranges) || known.Problem is not null)
        {
            return known;
        }

        if (ranges.Count > 1)
        {
            return known with { Problem = $"it has {ranges.Count} PLUS_MINUS_TOLERANCE ({ranges[0]}, {ranges[1]}); one is expected" };
        }

        var range = ranges[0];
        if (range.Find("LIMITS_AND_FITS") is { } fit)
        {
            return known with { Fit = $"{fit.Text(0)}{fit.Text(2)}".Trim() is { Length: > 0 } text ? text : range.ToString() };
        }

        var value = range.Get("TOLERANCE_VALUE");
        var (lower, upper) = (StepMeasure.Of(value.Instance(0), _correct), StepMeasure.Of(value.Instance(1), _correct));
        return lower.IsAngle == upper.IsAngle && lower.IsAngle == known.UnitMm is null
            ? Ordered(known with { Limits = (lower.Value, upper.Value) })
            : throw value.Fail("bad-value", "limits of another kind than the dimension: an angle and a length");
    }

    private static ModelAnnotation Ordered(ModelAnnotation known) => known.Limits is var (lower, upper) && lower > upper
        ? known with
        {
            Limits = null,
            Problem = string.Create(
                CultureInfo.InvariantCulture, $"its lower limit {lower:0.######} is above its upper one {upper:0.######}"),
        }
        : known;

    private ModelAnnotation Tolerance(ModelAnnotation known, StepInstance instance)
    {
        var record = instance.Records.Count == 1 ? instance.Records[0] : instance.Get("GEOMETRIC_TOLERANCE");
        known = known with
        {
            IsLowerSegment = _lower.Contains(instance.Id),
            Datums = DatumsOf(instance, record),
            Modifiers = [
                .. instance.Records.Where(r => r.Keyword is "GEOMETRIC_TOLERANCE_WITH_MODIFIERS" or "MODIFIED_GEOMETRIC_TOLERANCE")
                    .SelectMany(r => Words(r.Values)),
                .. instance.Records.Where(r => r.Keyword is "GEOMETRIC_TOLERANCE_WITH_DEFINED_UNIT"
                    or "GEOMETRIC_TOLERANCE_WITH_DEFINED_AREA_UNIT" or "GEOMETRIC_TOLERANCE_WITH_MAXIMUM_TOLERANCE").Select(r => r.Keyword),
                .. (_zones.GetValueOrDefault(instance.Id) ?? []).Distinct(StringComparer.Ordinal)],
        };
        var shape = Shape(record, 3);
        known = known with { Faces = shape.Faces, Others = shape.Others, IsAllOver = shape.IsWhole };
        if (record.At(2).Kind == StepValueKind.Omitted)
        {
            throw record.Fail("bad-value", "a tolerance without a magnitude");
        }

        var magnitude = StepMeasure.Of(record.Instance(2), _correct);
        if (magnitude.IsAngle || magnitude.Value < 0)
        {
            throw record.Fail("bad-value", magnitude.IsAngle
                ? "a magnitude that is an angle; a length is expected"
                : string.Create(CultureInfo.InvariantCulture, $"a magnitude of {magnitude.Value:g6} mm; none below zero is expected"));
        }

        known = known with { Value = magnitude.Value, UnitMm = magnitude.UnitMm };
        if (instance.Find("UNEQUALLY_DISPOSED_GEOMETRIC_TOLERANCE") is { } unequal)
        {
            var by = StepMeasure.Of(unequal.Instance(unequal.Values.Count - 1), _correct);
            known = known with
            {
                DisplacementMm = by.IsAngle
                    ? throw unequal.Fail("bad-value", "a displacement that is an angle; a length is expected")
                    : by.Value,
            };
        }

        return known;
    }

    private static IEnumerable<string> Words(IEnumerable<StepValue> values) => values.SelectMany(
        v => v.Kind == StepValueKind.Word ? [v.Text] : v.Kind == StepValueKind.List ? Words(v.Items) : []);

    // Names of datums are for people: one that cannot be read is a question mark.
    private static string[] DatumsOf(StepInstance instance, StepRecord own)
    {
        var with = instance.Records.Count > 1 ? instance.Find("GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE") : null;
        var list = (with ?? own).Values.LastOrDefault(v => v.Kind == StepValueKind.List);
        return list is null ? [] : [.. list.Items.Where(i => i.Kind == StepValueKind.Reference).SelectMany(i => Letters(own, i, 0))];
    }

    private static IEnumerable<string> Letters(StepRecord of, StepValue value, int depth)
    {
        try
        {
            var instance = of.Instance(value, 0);
            var record = instance.Records[0];
            return depth > 4 ? ["?"]
                : instance.Find("DATUM") is { } datum
                    ? [datum.Values is [.., { Kind: StepValueKind.Text, Text: var letter }] && letter.Length > 0 ? letter : "?"]
                : record.Keyword == "DATUM_SYSTEM" ? [.. record.Instances(4).SelectMany(c => Letters(of, Reference(c), depth + 1))]
                : record.Keyword is "DATUM_REFERENCE_COMPARTMENT" or "DATUM_REFERENCE_ELEMENT"
                    ? [string.Join('-', Base(record.At(4)).SelectMany(b => Letters(of, b, depth + 1)))]
                : record.Keyword is "DATUM_REFERENCE" or "REFERENCED_MODIFIED_DATUM" ? [.. Letters(of, record.At(1), depth + 1)]
                : ["?"];
        }
        catch (InputException)
        {
            return ["?"];
        }
    }

    private static StepValue Reference(StepInstance instance) => new(StepValueKind.Reference, "", instance.Id, []);

    private static IEnumerable<StepValue> Base(StepValue value) =>
        value.Kind is StepValueKind.List or StepValueKind.Typed ? value.Items.SelectMany(Base) : [value];

    // Zones that are not as wide as the magnitude around the surface.
    private void ReadZones()
    {
        var of = new Dictionary<long, IReadOnlyList<long>>();
        foreach (var id in _file.Ids(k => k is "TOLERANCE_ZONE" or "ORIENTED_TOLERANCE_ZONE" or "DIRECTED_TOLERANCE_ZONE"
            or "TOLERANCE_ZONE_WITH_DATUM"))
        {
            Try(() =>
            {
                var record = _file.At(id)!.Records[0];
                of[id] = [.. record.List(4).Where(v => v.Kind == StepValueKind.Reference).Select(v => (long)v.Number)];
                if (record.Keyword is not "TOLERANCE_ZONE")
                {
                    AddZone(of[id], record.Keyword);
                }
            });
        }

        foreach (var record in Simple("PROJECTED_ZONE_DEFINITION", "PROJECTED_ZONE_DEFINITION_WITH_OFFSET", "NON_UNIFORM_ZONE_DEFINITION"))
        {
            Try(() => AddZone(of.GetValueOrDefault(Id(record, 0)) ?? [], record.Keyword));
        }
    }

    private void AddZone(IReadOnlyList<long> tolerances, string what)
    {
        foreach (var tolerance in tolerances)
        {
            Add(_zones, tolerance, what);
        }
    }

    private IEnumerable<StepRecord> Simple(params string[] keywords)
    {
        foreach (var id in _file.Ids(k => Array.IndexOf(keywords, k) >= 0))
        {
            StepInstance? instance = null;
            Try(() => instance = _file.At(id));
            if (instance is not null)
            {
                yield return instance.Records[0];
            }
        }
    }

    private static long Id(StepRecord record, int index) => record.At(index) is { Kind: StepValueKind.Reference } reference
        ? (long)reference.Number
        : throw record.Fail("bad-value", $"attribute {index + 1} is no reference; one (#...) is expected");

    // What belongs to an annotation and is broken is missing there, which says so.
    private static void Try(Action read)
    {
        try
        {
            read();
        }
        catch (InputException)
        {
        }
    }

    private static void Add<T>(Dictionary<long, List<T>> to, long key, T value)
    {
        if (!to.TryGetValue(key, out var list))
        {
            to[key] = list = [];
        }

        list.Add(value);
    }
}
