using ErrorMatching.Geometry;
using ErrorMatching.Json;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>Creates a job from a document that conforms to the schema, and collects the problems that a schema cannot detect: duplicate
/// names, too few points, keys that require each other.</summary>
internal sealed class JobReader(JsonItem root)
{
    private readonly JobProblems _problems = new();

    /// <summary>What is wrong in the job.</summary>
    public IReadOnlyList<Refusal> Problems => _problems.All;

    /// <summary>Reads the job.</summary>
    /// <param name="file">The file, as the caller named it.</param>
    /// <param name="sha256">SHA-256 of its bytes.</param>
    public MatingJob Read(string file, string sha256)
    {
        var tolerances = new ToleranceReader(_problems);
        var features = new FeatureReader(_problems, tolerances, root.Find("without")?.Items ?? []);

        // Read the chain first, because features may take their limits from it.
        var chain = root.Find("toleranceChain") is { } links ? tolerances.ReadChain(links) : null;
        var job = new MatingJob
        {
            File = file,
            Sha256 = sha256,
            Name = root["name"].Text,
            WorkOrder = root.Find("workOrder")?.Text,
            Part = new(root["part"]["theoretical"].Text, root["part"]["measured"].Text),
            Gauge = ReadGauge(root["gauge"]),
            Alignment = root.Find("alignment") is { } alignment ? ReadAlignment(alignment) : JobAlignment.None,
            OriginCheck = root.Find("originCheck") is { } origin ? new(origin["point"].Text, origin["limitMm"].Number) : null,
            Features = [.. root["features"].Items.Select(f => features.Read(f, chain))],
            Without = [.. (root.Find("without")?.Items ?? []).Select(i => i.Text)],
            CommonMotionMm = root.Find("commonMotionMm")?.Number,
            Counterpart = ReadCounterpart(root["counterpart"]),
            Compensation = root.Find("compensation") is { } compensation ? ReadCompensation(compensation) : JobCompensation.Default,
            Correction = root.Find("correction") is { } correction ? ReadCorrection(correction) : JobCorrection.Default,
            Rule = root.Find("decision") is { } decision ? ReadRule(decision) : DecisionRule.Simple,
            Chain = chain,
            Recognition = root.Find("recognition") is { } rules ? new(ReadRules(rules["part"]), ReadRules(rules["counterpart"])) : null,
            Verify = new ComparisonReader(_problems, features).Read(root.Find("verify")?.Items ?? []),
            MeasuredPlace = root["counterpart"].Find("measured")?.Place,
        };
        if (job.Compensation.From == CompensationSource.Counterpart && job.Counterpart.Measured is null)
        {
            _problems.Refuse(
                root["counterpart"],
                "measured-missing",
                "no key \"measured\"",
                "the measured counterpart's file, since the compensation comes from it");
        }

        if (!NcDialects.IsName(job.Counterpart.Dialect))
        {
            _problems.Refuse(
                root["counterpart"]["dialect"],
                NcInputCodes.UnknownDialect,
                $"the dialect \"{job.Counterpart.Dialect}\"",
                NcDialects.ExpectedInsteadOf(job.Counterpart.Dialect));
        }

        features.Labels.CheckWithout();
        new LimitCheck(_problems).Check(root, job);
        return job;
    }

    private JobGauge ReadGauge(JsonItem item)
    {
        var uncertainty = item["uncertaintyMm"];
        var measuring = item.Find("measuring");
        var reports = item.Find("reports")?.Text == "stylus-center" ? ProbeReport.StylusCenter : ProbeReport.Contact;
        var diameter = item.Find("stylusDiameterMm")?.Number;
        if (reports == ProbeReport.StylusCenter && diameter is null)
        {
            _problems.Refuse(
                item, "stylus-diameter-missing", "no key \"stylusDiameterMm\"", "the diameter of the ball whose centers the files hold");
        }

        return new(
            _problems.Read(all => MeasurementFormat.Read(item["format"], all)) ?? MeasurementFormat.Points,
            uncertainty.Kind == JsonItemKind.Number
                ? UncertaintyBudget.Of(uncertainty.Number)
                : new([.. uncertainty.Items.Select(c => new UncertaintyContribution(c["name"].Text, c["valueMm"].Number)
                {
                    IsShared = c.Find("shared")?.Flag ?? false,
                })]),
            reports,
            diameter,
            new(
                measuring?.Find("probingSpeedMmPerS")?.Number ?? MeasuringTime.Default.ProbingSpeedMmPerS,
                measuring?.Find("probingDistanceMm")?.Number ?? MeasuringTime.Default.ProbingDistanceMm,
                measuring?.Find("calculatingS")?.Number ?? MeasuringTime.Default.CalculatingS,
                (int?)measuring?.Find("touches")?.Number))
        {
            AcceptsCoarse = item.Find("acceptCoarse")?.Flag ?? false,
            Labels = item.Find("labels") is { Kind: JsonItemKind.Text } rule ? ReadLabelRule(rule) : null,
            Order = item.Find("labels") is { Kind: JsonItemKind.List } order ? ReadOrder(order) : [],
        };
    }

    private LabelRule? ReadLabelRule(JsonItem item)
    {
        try
        {
            return LabelRule.Parse(item.Text);
        }
        catch (InputException e)
        {
            _problems.Refuse(item, e.Code, e.Refusals[0].Found, e.Refusals[0].Expected);
            return null;
        }
    }

    private List<string> ReadOrder(JsonItem list)
    {
        var order = new List<string>();
        foreach (var item in list.Items)
        {
            try
            {
                order.AddRange(LabelRange.Expand(item.Text));
            }
            catch (InputException e)
            {
                _problems.Refuse(item, e.Code, e.Refusals[0].Found, e.Refusals[0].Expected);
            }
        }

        if (order.GroupBy(l => l, StringComparer.Ordinal).FirstOrDefault(g => g.Count() > 1) is { Key: var twice })
        {
            _problems.Refuse(list, MeasurementError.BadLabels, $"the point \"{twice}\" twice", "each point once, in the order of the log");
        }

        return order;
    }

    private JobAlignment ReadAlignment(JsonItem item)
    {
        switch (item["kind"].Text)
        {
            case "datum":
                var (origin, direction) = (item["origin"], item["direction"]);
                if (origin.Text == direction.Text)
                {
                    _problems.Refuse(
                        direction,
                        "datum-needs-two-points",
                        $"the origin {direction.Text} again",
                        "another point, which gives the direction");
                }

                return new(JobAlignmentKind.Datum, origin.Text, direction.Text, false, false, false);
            case "best-fit":
                var locked = item.Find("locked")?.Items.Select(i => i.Text).ToArray() ?? [];
                return new(JobAlignmentKind.BestFit, null, null, locked.Contains("x"), locked.Contains("y"), locked.Contains("rotation"));
            default:
                return JobAlignment.None;
        }
    }

    private AssumedValues ReadAssumed(JsonItem? item)
    {
        var values = new Dictionary<string, double>(StringComparer.Ordinal);
        foreach (var (name, _, value) in item?.Members ?? [])
        {
            if (!AssumedValues.IsName(name))
            {
                _problems.Refuse(value, "bad-variable", $"\"{name}\"", "the name of a variable, such as #100, R5 or Q1");
            }
            else if (value.Kind != JsonItemKind.Number)
            {
                _problems.Refuse(value, "wrong-type", value.ToJson(), "a number");
            }
            else
            {
                values[name] = value.Number;
            }
        }

        return AssumedValues.Of(values);
    }

    private JobCounterpart ReadCounterpart(JsonItem item) => new(
        item["program"].Text,
        item["dialect"].Text,
        item["toolDiameterMm"].Number,
        item.Find("measured")?.Text,
        item.Find("frame") is { } frame ? ReadFrame(frame) : RigidTransform2.Identity,
        item.Find("mapMm")?.Number ?? JobCounterpart.DefaultMapMm)
    {
        BlockSkip = BlockSkips.Of(item.Find("blockSkip")?.Text),
        Assumed = ReadAssumed(item.Find("assume")),
        Libraries = [.. item.Find("libraries")?.Items.Select(i => i.Text) ?? []],
        ProgramSha256 = item.Find("programSha256")?.Text.ToLowerInvariant(),
    };

    private static RigidTransform2 ReadFrame(JsonItem item)
    {
        var mirror = item.Find("mirror")?.Text switch { "x" => Mirror.X, "y" => Mirror.Y, _ => Mirror.None };
        var by = item.Find("translateMm")?.Items;
        return new(
            mirror, Angle.FromDegrees(item.Find("rotateDeg")?.Number ?? 0), by is null ? Vector2.Zero : new(by[0].Number, by[1].Number));
    }

    private static JobCompensation ReadCompensation(JsonItem item) => new(
        item.Find("from")?.Text == "counterpart" ? CompensationSource.Counterpart : JobCompensation.Default.From,
        item.Find("gain")?.Number ?? JobCompensation.Default.Gain,
        item.Find("amount")?.Text == "excess" ? CompensationAmount.Excess : JobCompensation.Default.Amount,
        item.Find("along")?.Text == "vector" ? CompensationDirection.Vector : JobCompensation.Default.Along,
        item.Find("limitMm")?.Number ?? JobCompensation.Default.LimitMm);

    private JobCorrection ReadCorrection(JsonItem item)
    {
        var limits = OffsetLimits.Default;
        var correction = new JobCorrection(
            [
                .. item["allow"].Items.Select(i => i.Text switch
                {
                    "tool-wear" => CorrectionKind.ToolWear,
                    "work-offset" => CorrectionKind.WorkOffset,
                    _ => CorrectionKind.Blocks,
                })],
            item.Find("otherCuts")?.Text == "may-move",
            item.Find("withinMm")?.Number ?? JobCorrection.DefaultWithinMm,
            (int?)item.Find("firstVariable")?.Number ?? 0,
            (int?)item.Find("programNumber")?.Number ?? JobCorrection.DefaultProgramNumber,
            (int?)item.Find("tool")?.Number,
            (int?)item.Find("radiusOffset")?.Number,
            new(
                (decimal?)item.Find("stepMm")?.Number ?? limits.StepMm,
                (decimal?)item.Find("totalMm")?.Number ?? limits.TotalMm,
                (decimal?)item.Find("stepDegrees")?.Number ?? limits.StepDegrees,
                (decimal?)item.Find("totalDegrees")?.Number ?? limits.TotalDegrees));
        if (correction.AllowsOffsets && correction.FirstVariable == 0)
        {
            _problems.Refuse(
                item,
                "first-variable-missing",
                "no key \"firstVariable\"",
                "the first of ten variables of the control in which the program of the offsets keeps what it did");
        }

        return correction;
    }

    private static DecisionRule ReadRule(JsonItem item) => item["rule"].Text == "guard-band"
        ? DecisionRule.GuardBand(item.Find("riskPercent")?.Number ?? DecisionRule.DefaultRiskPercent)
        : DecisionRule.Simple;

    private List<SourceRule> ReadRules(JsonItem list)
    {
        var rules = new List<SourceRule>();
        foreach (var item in list.Items)
        {
            var pattern = item["pattern"].Text;
            try
            {
                rules.Add(item["in"].Text switch
                {
                    "header" => SourceRule.OfHeaderField(item["name"].Text, pattern),
                    "column" => SourceRule.OfColumn(item["name"].Text, pattern),
                    _ => SourceRule.OfFileName(pattern),
                });
            }
            catch (InputException e)
            {
                _problems.Refuse(item["pattern"], "bad-pattern", e.Refusals[0].Found, e.Refusals[0].Expected);
            }
        }

        return rules;
    }
}
