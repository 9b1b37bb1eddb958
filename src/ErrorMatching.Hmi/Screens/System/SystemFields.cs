using System.Globalization;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi;

/// <summary>The fields of the system setup, tab by tab, in the job's order.</summary>
internal sealed class SystemFields(JobEditing editing)
{
    // The fields of every feature, and the keys of the kind with the most.
    private static readonly int ToleranceColumns = 4 + FeatureKinds.All.Max(k => k.Keys.Count);

    public IReadOnlyList<TextField> Blocks() => [.. Features().Select(f =>
        new TextField(editing, DraftPaths.Feature(f, FeatureDraft.BlocksKey), "System.Blocks")
        {
            Example = "System.BlocksExample",
            Row = () => FeatureEdit.NameOf(editing, f),
        })];

    public IReadOnlyList<FieldRow> Tolerances() => [.. Features().Select(Tolerance)];

    public IReadOnlyList<FieldRow> Chain() => Rows("chain", DraftPaths.Chain, at =>
    [
        Named(at, "name", "System.ChainName"),
        Named(at, "nominalMm", "System.Nominal"),
        Named(at, FeatureDraft.LowerKey, "System.Lower"),
        Named(at, FeatureDraft.UpperKey, "System.Upper"),
        Choice(at("sign"), "System.Sign"),
    ]);

    public IReadOnlyList<EditField> Frame() =>
    [
        Text(DraftPaths.ToolDiameter, "System.ToolDiameter"),
        Text(DraftPaths.Map, "System.Map"),
        Choice(DraftPaths.Frame + ".mirror", "System.Mirror"),
        Text(DraftPaths.Frame + ".rotateDeg", "System.Rotate"),
        Text(DraftPaths.TranslateX, "System.TranslateX", "0"),
        Text(DraftPaths.TranslateY, "System.TranslateY", "0"),
    ];

    public IReadOnlyList<EditField> Alignment() =>
    [
        Choice(DraftPaths.AlignmentKind, "System.Alignment"),
        .. editing.Draft[DraftPaths.AlignmentKind] switch
        {
            "datum" => new EditField[]
            {
                Text(DraftPaths.DatumOrigin, "System.DatumOrigin"),
                Text(DraftPaths.DatumDirection, "System.DatumDirection"),
            },
            "best-fit" =>
            [
                Lock("x", "lockX", "System.LockX"),
                Lock("y", "lockY", "System.LockY"),
                Lock("rotation", "lockRotation", "System.LockRotation"),
            ],
            _ => [],
        },
        Text(DraftPaths.OriginPoint, "System.OriginPoint"),
        Text(DraftPaths.OriginLimit, "System.OriginLimit"),
    ];

    public IReadOnlyList<EditField> Compensation() =>
    [
        Choice(DraftPaths.From, "System.From"),
        Text(DraftPaths.Compensation + ".gain", "System.Gain"),
        Text(DraftPaths.Compensation + ".limitMm", "System.Limit"),
        Choice(DraftPaths.Compensation + ".amount", "System.Amount"),
        Choice(DraftPaths.Compensation + ".along", "System.Along"),
        Choice(DraftPaths.Rule, "System.Rule"),
        .. editing.Draft[DraftPaths.Rule] == "guard-band"
            ? [Text(DraftPaths.Decision + ".riskPercent", "System.Risk")] : Array.Empty<EditField>(),

        // Applies to either choice, because verifications compare with it.
        Text(DraftPaths.CounterpartMeasured, "System.CounterpartMeasured"),
    ];

    public IReadOnlyList<EditField> Gauge() =>
    [
        .. editing.Draft[DraftPaths.Format].StartsWith('{')
            ? Array.Empty<EditField>()
            : [new ChoiceField(editing, DraftPaths.Format, "System.Format", ["points", "feature-table", "recognized"])],
        .. editing.Draft.Count(DraftPaths.Uncertainty) > 0
            ? Array.Empty<EditField>() : [Text(DraftPaths.Uncertainty, "System.Uncertainty")],
        new SwitchField(editing, DraftPaths.Gauge + ".acceptCoarse", "System.AcceptCoarse"),
        Choice(DraftPaths.Reports, "System.Reports"),
        Text(DraftPaths.StylusDiameter, "System.Stylus"),
        Text(DraftPaths.Measuring + ".touches", "System.Touches"),
        Text(DraftPaths.Measuring + ".probingSpeedMmPerS", "System.ProbingSpeed"),
        Text(DraftPaths.Measuring + ".probingDistanceMm", "System.ProbingDistance"),
        Text(DraftPaths.Measuring + ".calculatingS", "System.Calculating"),
    ];

    public IReadOnlyList<FieldRow> Contributions() => Rows("contribution", DraftPaths.Uncertainty, at =>
        [Named(at, "name", "System.ContributionName"), Named(at, DraftPaths.ContributionValue, "System.Uncertainty")]);

    /// <summary>Comparisons in addition to those of the features.</summary>
    public IReadOnlyList<FieldRow> Comparisons() => Rows("comparison", DraftPaths.Comparisons, at =>
    [
        Named(at, "name", "System.ComparisonName"),
        Choice(at(DraftPaths.Quantity), "System.Quantity"),
        editing.Draft.Word(at(DraftPaths.Quantity)) == "angle"
            ? Named(at, "between", "System.Between") : Named(at, "points", "System.Of"),
    ]);

    private IEnumerable<int> Features() => Enumerable.Range(0, editing.Draft.Features.Count);

    private FieldRow Tolerance(int f)
    {
        var feature = editing.Draft.Features[f];
        var (lower, upper) = (DraftPaths.Feature(f, FeatureDraft.LowerKey), DraftPaths.Feature(f, FeatureDraft.UpperKey));
        var isStated = feature.Tolerance == FeatureDraft.Stated;

        // Empty cells where limits are not stated, so that the following fields align with those of other features.
        return new(
            feature.Name,
            [
                new ChoiceField(
                    editing,
                    DraftPaths.Feature(f, FeatureDraft.ToleranceKey),
                    "System.Tolerance",
                    [FeatureDraft.Stated, .. MatingDraft.PlaceOf(DraftPaths.Feature(f, FeatureDraft.ToleranceKey)).Words],
                    d => d.Features[f].Tolerance,
                    (d, t) => d.WithFeature(f, x => x with { Tolerance = t }))
                {
                    Row = Name
                },
                isStated ? Text(lower, "System.Lower") : new NoteField(editing, lower, "System.Lower"),
                isStated ? Text(upper, "System.Upper") : new NoteField(editing, upper, "System.Upper"),
                new ChoiceField(editing, DraftPaths.Feature(f, FeatureDraft.PlaneKey), "System.Plane") { Row = Name },
                .. feature.Kind.Keys.Select(
                    k => $"Key.{feature.Kind}.{k.Name}" is var label && k.Words.Count > 0
                        ? new ChoiceField(editing, DraftPaths.Feature(f, k.Name), label, k.Words) { Row = Name }
                        : (EditField)new TextField(editing, DraftPaths.Feature(f, k.Name), label)
                        {
                            Default = Texts.Current["System.Automatic"],
                            MayBeEmpty = _ => true,
                            Row = Name,
                        }),
            ])
        {
            Columns = ToleranceColumns,
        };

        string Name() => FeatureEdit.NameOf(editing, f);

        TextField Text(string path, string label) => new(editing, path, label) { Row = Name };
    }

    // The rows of a list, with the fields of an item given the paths of its keys.
    private FieldRow[] Rows(string name, string list, Func<Func<string, string>, IReadOnlyList<EditField>> cells) =>
    [
        .. Enumerable.Range(0, editing.Draft.Count(list)).Select(i => new FieldRow(
            "",
            cells(key => DraftPaths.Item(list, i, key)),
            new(() => editing.Change("", d => d.WithoutItem(list, i)), () => editing.CanEdit),
            string.Create(CultureInfo.InvariantCulture, $"{name}-{i}-remove"))),
    ];

    // A field of an item, whose row is called as the item.
    private TextField Named(Func<string, string> at, string key, string label) =>
        new(editing, at(key), label) { Row = () => editing.Draft[at("name")] };

    // Default and necessity are those of the job's schema.
    private TextField Text(string path, string label, string? otherwise = null)
    {
        var dot = path.LastIndexOf('.');
        var isRequired = MatingDraft.PlaceOf(path[..dot]).Requires(path[(dot + 1)..]);
        return new(editing, path, label)
        {
            Default = otherwise ?? (MatingDraft.PlaceOf(path).Default is { Length: > 0 } stated ? stated : null),
            MayBeEmpty = d => MayBeEmpty(d, path, isRequired),
        };
    }

    // One coordinate requires the other, and a point its limit.
    private static bool MayBeEmpty(MatingDraft draft, string path, bool isRequired) => path switch
    {
        DraftPaths.TranslateX or DraftPaths.TranslateY =>
            draft[DraftPaths.TranslateX].Length + draft[DraftPaths.TranslateY].Length == 0,
        DraftPaths.OriginPoint or DraftPaths.OriginLimit =>
            draft[DraftPaths.OriginPoint].Length + draft[DraftPaths.OriginLimit].Length == 0,
        DraftPaths.StylusDiameter => draft.Word(DraftPaths.Reports) == "contact",
        DraftPaths.CounterpartMeasured => draft.Word(DraftPaths.From) == "part",
        _ => !isRequired,
    };

    private ChoiceField Choice(string path, string label) => new(editing, path, label);

    // One of the words of a list.
    private SwitchField Lock(string word, string name, string label) => new(
        editing,
        DraftPaths.Alignment + "." + name,
        label,
        d => Locked(d).Contains(word, StringComparer.Ordinal),
        (d, on) => d.With(DraftPaths.Locked, string.Join(", ", on ? Locked(d).Append(word) : Locked(d).Where(w => w != word))));

    private static string[] Locked(MatingDraft draft) => draft[DraftPaths.Locked].Split(", ", StringSplitOptions.RemoveEmptyEntries);
}
