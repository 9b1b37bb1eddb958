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
        new TextField(
            editing,
            DraftPaths.Feature(f, "blocks"),
            "System.Blocks",
            d => d.Features[f].Blocks,
            (d, t) => d.WithFeature(f, x => x with { Blocks = t }))
        {
            Example = "System.BlocksExample",
            Row = () => FeatureEdit.NameOf(editing, f),
        })];

    public IReadOnlyList<FieldRow> Tolerances() => [.. Features().Select(Tolerance)];

    public IReadOnlyList<FieldRow> Chain() => [.. Enumerable.Range(0, editing.Draft.Chain.Count).Select(i => Row(
        "chain",
        i,
        d => d with { Chain = d.Chain.Without(i) },
        [
            Link(i, "name", "System.ChainName", l => l.Name, (l, t) => l with { Name = t }),
            Link(i, "nominalMm", "System.Nominal", l => l.Nominal, (l, t) => l with { Nominal = t }),
            Link(i, "toleranceMm[0]", "System.Lower", l => l.Lower, (l, t) => l with { Lower = t }),
            Link(i, "toleranceMm[1]", "System.Upper", l => l.Upper, (l, t) => l with { Upper = t }),
            Choice(
                At("toleranceChain", i, "sign"),
                "System.Sign",
                ["1", "-1"],
                d => d.Chain[i].Sign,
                (d, t) => d with { Chain = d.Chain.Replaced(i, d.Chain[i] with { Sign = t }) }),
        ]))];

    public IReadOnlyList<EditField> Frame() =>
    [
        Text(
            "$.counterpart.toolDiameterMm",
            "System.ToolDiameter",
            d => d.Counterpart.ToolDiameter,
            (d, t) => d with { Counterpart = d.Counterpart with { ToolDiameter = t } }),
        Text(
            "$.counterpart.mapMm",
            "System.Map",
            "0.5",
            d => d.Counterpart.Map,
            (d, t) => d with { Counterpart = d.Counterpart with { Map = t } }),
        Choice(
            "$.counterpart.frame.mirror",
            "System.Mirror",
            ["none", "x", "y"],
            d => d.Counterpart.Mirror,
            (d, t) => d with { Counterpart = d.Counterpart with { Mirror = t } }),
        Text(
            "$.counterpart.frame.rotateDeg",
            "System.Rotate",
            "0",
            d => d.Counterpart.Rotate,
            (d, t) => d with { Counterpart = d.Counterpart with { Rotate = t } }),
        Text(
            "$.counterpart.frame.translateMm[0]",
            "System.TranslateX",
            "0",
            d => d.Counterpart.TranslateX,
            (d, t) => d with { Counterpart = d.Counterpart with { TranslateX = t } }),
        Text(
            "$.counterpart.frame.translateMm[1]",
            "System.TranslateY",
            "0",
            d => d.Counterpart.TranslateY,
            (d, t) => d with { Counterpart = d.Counterpart with { TranslateY = t } }),
    ];

    public IReadOnlyList<EditField> Alignment() =>
    [
        Choice(
            "$.alignment.kind",
            "System.Alignment",
            ["none", "datum", "best-fit"],
            d => d.Alignment.Kind,
            (d, t) => d with { Alignment = d.Alignment with { Kind = t } }),
        .. editing.Draft.Alignment.Kind switch
        {
            "datum" => new EditField[]
            {
                Text(
                    "$.alignment.origin",
                    "System.DatumOrigin",
                    d => d.Alignment.Origin,
                    (d, t) => d with { Alignment = d.Alignment with { Origin = t } }),
                Text(
                    "$.alignment.direction",
                    "System.DatumDirection",
                    d => d.Alignment.Direction,
                    (d, t) => d with { Alignment = d.Alignment with { Direction = t } }),
            },
            "best-fit" =>
            [
                Switch(
                    "$.alignment.lockX",
                    "System.LockX",
                    d => d.Alignment.LockX,
                    (d, on) => d with { Alignment = d.Alignment with { LockX = on } }),
                Switch(
                    "$.alignment.lockY",
                    "System.LockY",
                    d => d.Alignment.LockY,
                    (d, on) => d with { Alignment = d.Alignment with { LockY = on } }),
                Switch(
                    "$.alignment.lockRotation",
                    "System.LockRotation",
                    d => d.Alignment.LockRotation,
                    (d, on) => d with { Alignment = d.Alignment with { LockRotation = on } }),
            ],
            _ => [],
        },
        Text("$.originCheck.point", "System.OriginPoint", otherwise: null, d => d.OriginPoint, (d, t) => d with { OriginPoint = t }),
        Text("$.originCheck.limitMm", "System.OriginLimit", otherwise: null, d => d.OriginLimit, (d, t) => d with { OriginLimit = t }),
    ];

    public IReadOnlyList<EditField> Compensation() =>
    [
        Choice(
            "$.compensation.from",
            "System.From",
            ["part", "counterpart"],
            d => d.Compensation.From,
            (d, t) => d with { Compensation = d.Compensation with { From = t } }),
        Text(
            "$.compensation.gain",
            "System.Gain",
            "1",
            d => d.Compensation.Gain,
            (d, t) => d with { Compensation = d.Compensation with { Gain = t } }),
        Text(
            "$.compensation.limitMm",
            "System.Limit",
            "1",
            d => d.Compensation.Limit,
            (d, t) => d with { Compensation = d.Compensation with { Limit = t } }),
        Choice(
            "$.compensation.amount",
            "System.Amount",
            ["whole", "excess"],
            d => d.Compensation.Amount,
            (d, t) => d with { Compensation = d.Compensation with { Amount = t } }),
        Choice(
            "$.compensation.along",
            "System.Along",
            ["normal", "vector"],
            d => d.Compensation.Along,
            (d, t) => d with { Compensation = d.Compensation with { Along = t } }),
        .. DecisionFields.Of(editing),

        // Applies to either choice, because verifications compare with it.
        Text(
            "$.counterpart.measured",
            "System.CounterpartMeasured",
            otherwise: null,
            d => d.Counterpart.Measured,
            (d, t) => d with { Counterpart = d.Counterpart with { Measured = t } }),
    ];

    public IReadOnlyList<EditField> Gauge() =>
    [
        .. editing.Draft.Gauge.FormatJson.Length > 0
            ? []
            : new EditField[]
            {
                Choice(
                    "$.gauge.format",
                    "System.Format",
                    ["points", "feature-table", "recognized"],
                    d => d.Gauge.Format,
                    (d, t) => d with { Gauge = d.Gauge with { Format = t } })
            },
        .. editing.Draft.Gauge.Contributions.Count > 0
            ? []
            : new EditField[]
            {
                Text(
                    "$.gauge.uncertaintyMm",
                    "System.Uncertainty",
                    d => d.Gauge.Uncertainty,
                    (d, t) => d with { Gauge = d.Gauge with { Uncertainty = t } })
            },
        DecisionFields.AcceptCoarse(editing),
        Choice(
            "$.gauge.reports",
            "System.Reports",
            ["contact", "stylus-center"],
            d => d.Gauge.Reports,
            (d, t) => d with { Gauge = d.Gauge with { Reports = t } }),
        Text(
            "$.gauge.stylusDiameterMm",
            "System.Stylus",
            otherwise: null,
            d => d.Gauge.StylusDiameter,
            (d, t) => d with { Gauge = d.Gauge with { StylusDiameter = t } }),
        Text(
            "$.gauge.measuring.touches",
            "System.Touches",
            otherwise: null,
            d => d.Gauge.Touches,
            (d, t) => d with { Gauge = d.Gauge with { Touches = t } }),
        Text(
            "$.gauge.measuring.probingSpeedMmPerS",
            "System.ProbingSpeed",
            "10",
            d => d.Gauge.ProbingSpeed,
            (d, t) => d with { Gauge = d.Gauge with { ProbingSpeed = t } }),
        Text(
            "$.gauge.measuring.probingDistanceMm",
            "System.ProbingDistance",
            "5",
            d => d.Gauge.ProbingDistance,
            (d, t) => d with { Gauge = d.Gauge with { ProbingDistance = t } }),
        Text(
            "$.gauge.measuring.calculatingS",
            "System.Calculating",
            "1",
            d => d.Gauge.Calculating,
            (d, t) => d with { Gauge = d.Gauge with { Calculating = t } }),
    ];

    public IReadOnlyList<FieldRow> Contributions() => [.. Enumerable.Range(0, editing.Draft.Gauge.Contributions.Count).Select(i => Row(
        "contribution",
        i,
        d => d with { Gauge = d.Gauge with { Contributions = d.Gauge.Contributions.Without(i) } },
        [
            Contribution(i, "name", "System.ContributionName", c => c.Name, (c, t) => c with { Name = t }),
            Contribution(i, "valueMm", "System.Uncertainty", c => c.Value, (c, t) => c with { Value = t }),
        ]))];

    /// <summary>Comparisons in addition to those of the features.</summary>
    public IReadOnlyList<FieldRow> Comparisons() => [.. Enumerable.Range(0, editing.Draft.Comparisons.Count).Select(i => Row(
        "comparison",
        i,
        d => d with { Comparisons = d.Comparisons.Without(i) },
        [
            Comparison(i, "name", "System.ComparisonName", c => c.Name, (c, t) => c with { Name = t }),
            Choice(
                At("verify", i, "quantity"),
                "System.Quantity",
                ["angle", "deviation", "deviation-x"],
                d => d.Comparisons[i].Quantity,
                (d, t) => d with { Comparisons = d.Comparisons.Replaced(i, d.Comparisons[i] with { Quantity = t }) }),
            Comparison(
                i,
                editing.Draft.Comparisons[i].Quantity == "angle" ? "between" : "points",
                editing.Draft.Comparisons[i].Quantity == "angle" ? "System.Between" : "System.Of",
                c => c.Of,
                (c, t) => c with { Of = t }),
        ]))];

    private static string At(string list, int index, string field) =>
        string.Create(CultureInfo.InvariantCulture, $"$.{list}[{index}].{field}");

    private IEnumerable<int> Features() => Enumerable.Range(0, editing.Draft.Features.Count);

    private FieldRow Tolerance(int f)
    {
        var feature = editing.Draft.Features[f];
        var cells = new List<EditField>
        {
            Choice(
                "toleranceMm",
                "System.Tolerance",
                [FeatureDraft.Stated, "chain:worst-case", "chain:rss"],
                x => x.Tolerance,
                (x, t) => x with { Tolerance = t })
        };
        if (feature.Tolerance == FeatureDraft.Stated)
        {
            cells.Add(Text("toleranceMm[0]", "System.Lower", x => x.Lower, (x, t) => x with { Lower = t }));
            cells.Add(Text("toleranceMm[1]", "System.Upper", x => x.Upper, (x, t) => x with { Upper = t }));
        }
        else
        {
            // Empty cells, so that the following fields align with those of other features.
            cells.Add(new NoteField(editing, DraftPaths.Feature(f, "toleranceMm[0]"), "System.Lower"));
            cells.Add(new NoteField(editing, DraftPaths.Feature(f, "toleranceMm[1]"), "System.Upper"));
        }

        cells.Add(Choice("plane", "System.Plane", ["XY", "ZX", "YZ"], x => x.Plane, (x, t) => x with { Plane = t }));
        foreach (var key in feature.Kind.Keys)
        {
            var label = $"Key.{feature.Kind}.{key.Name}";
            cells.Add(key.Words.Count > 0
                ? Choice(key.Name, label, key.Words, x => x.Key(key.Name), (x, t) => x.WithKey(key.Name, t))
                : Automatic(key.Name, label, x => x.Key(key.Name), (x, t) => x.WithKey(key.Name, t)));
        }

        return new(feature.Name, cells) { Columns = ToleranceColumns };

        TextField Automatic(string field, string label, Func<FeatureDraft, string> get, Func<FeatureDraft, string, FeatureDraft> set) =>
            new(editing, DraftPaths.Feature(f, field), label, d => get(d.Features[f]), (d, t) => d.WithFeature(f, x => set(x, t)))
            {
                Default = Texts.Current["System.Automatic"],
                MayBeEmpty = _ => true,
                Row = () => FeatureEdit.NameOf(editing, f)
            };

        TextField Text(string field, string label, Func<FeatureDraft, string> get, Func<FeatureDraft, string, FeatureDraft> set) =>
            new(editing, DraftPaths.Feature(f, field), label, d => get(d.Features[f]), (d, t) => d.WithFeature(f, x => set(x, t)))
            {
                Row = () => FeatureEdit.NameOf(editing, f)
            };

        ChoiceField Choice(
            string field,
            string label,
            IReadOnlyList<string> words,
            Func<FeatureDraft, string> get,
            Func<FeatureDraft, string, FeatureDraft> set) =>
            new(editing, DraftPaths.Feature(f, field), label, words, d => get(d.Features[f]), (d, t) => d.WithFeature(f, x => set(x, t)))
            {
                Row = () => FeatureEdit.NameOf(editing, f)
            };
    }

    private FieldRow Row(string name, int index, Func<MatingDraft, MatingDraft> without, IReadOnlyList<EditField> cells) =>
        new(
            "",
            cells,
            new(() => editing.Change("", without), () => editing.CanEdit),
            string.Create(CultureInfo.InvariantCulture, $"{name}-{index}-remove"));

    private TextField Link(
        int i, string field, string label, Func<ChainLinkDraft, string> get, Func<ChainLinkDraft, string, ChainLinkDraft> set) =>
        new(
            editing,
            At("toleranceChain", i, field),
            label,
            d => get(d.Chain[i]),
            (d, t) => d with { Chain = d.Chain.Replaced(i, set(d.Chain[i], t)) })
        {
            Row = () => editing.Draft.Chain.ElementAtOrDefault(i)?.Name ?? "",
        };

    private TextField Comparison(
        int i, string field, string label, Func<ComparisonDraft, string> get, Func<ComparisonDraft, string, ComparisonDraft> set) =>
        new(
            editing,
            At("verify", i, field),
            label,
            d => get(d.Comparisons[i]),
            (d, t) => d with { Comparisons = d.Comparisons.Replaced(i, set(d.Comparisons[i], t)) })
        {
            Row = () => editing.Draft.Comparisons.ElementAtOrDefault(i)?.Name ?? "",
        };

    private TextField Contribution(
        int i, string field, string label, Func<ContributionDraft, string> get, Func<ContributionDraft, string, ContributionDraft> set) =>
        new(
            editing,
            At("gauge.uncertaintyMm", i, field),
            label,
            d => get(d.Gauge.Contributions[i]),
            (d, t) => d with
            {
                Gauge = d.Gauge with { Contributions = d.Gauge.Contributions.Replaced(i, set(d.Gauge.Contributions[i], t)) }
            })
        {
            Row = () => editing.Draft.Gauge.Contributions.ElementAtOrDefault(i)?.Name ?? "",
        };

    private TextField Text(string path, string label, Func<MatingDraft, string> get, Func<MatingDraft, string, MatingDraft> set) =>
        new(editing, path, label, get, set);

    // The defaults are those of the job's schema.
    private TextField Text(
        string path, string label, string? otherwise, Func<MatingDraft, string> get, Func<MatingDraft, string, MatingDraft> set) =>
        new(editing, path, label, get, set) { Default = otherwise, MayBeEmpty = d => MayBeEmpty(d, path) };

    // One coordinate requires the other, and a point its limit.
    private static bool MayBeEmpty(MatingDraft draft, string path) => path switch
    {
        "$.counterpart.frame.translateMm[0]" or "$.counterpart.frame.translateMm[1]" =>
            draft.Counterpart.TranslateX.Length + draft.Counterpart.TranslateY.Length == 0,
        "$.originCheck.point" or "$.originCheck.limitMm" => draft.OriginPoint.Length + draft.OriginLimit.Length == 0,
        "$.gauge.stylusDiameterMm" => draft.Gauge.Reports == "contact",
        "$.counterpart.measured" => draft.Compensation.From == "part",
        _ => true,
    };

    private ChoiceField Choice(
        string path,
        string label,
        IReadOnlyList<string> words,
        Func<MatingDraft, string> get,
        Func<MatingDraft, string, MatingDraft> set) =>
        new(editing, path, label, words, get, set);

    private SwitchField Switch(string path, string label, Func<MatingDraft, bool> get, Func<MatingDraft, bool, MatingDraft> set) =>
        new(editing, path, label, get, set);
}
