using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Json;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Converts a schema-valid document to a job, and collects the problems that a schema cannot detect.</summary>
internal sealed class FreeformJobReader(JsonItem root)
{
    public List<Refusal> Problems { get; } = [];

    public FreeformJob Read(string file, string sha256)
    {
        var (measuring, compensation, fit) = (ReadMeasuring(root["measuring"]), ReadMirror(), ReadFit());
        CheckWithout(fit);
        return new()
        {
            File = file,
            Sha256 = sha256,
            Name = root["name"].Text,
            WorkOrder = root.Find("workOrder")?.Text,
            Surface = new(root["surface"].Text, root.Find("surfaceEntity")?.Text, root.Find("outside")?.Text != "-z"),
            Stock = ReadStock(),
            Tool = ReadTool(),
            Measuring = measuring,
            Fit = fit,
            Toolpath = ReadToolpath(root["toolpath"]),
            Compensation = compensation,
            Profile = ReadProfile(measuring, compensation),
            CommonMotionMm = root.Find("commonMotionMm")?.Number ?? compensation.LimitMm / 2,
            Places = Named().OfType<JsonItem>().ToDictionary(i => i.Path, i => i.Place),
        };
    }

    // Values that name a file, a dialect or a tool, which are checked later.
    private IEnumerable<JsonItem?> Named()
    {
        yield return root["surface"];
        foreach (var program in new[] { root["toolpath"], root["measuring"] })
        {
            yield return program["dialect"];
            yield return program.Find("template");
            yield return program.Find("tool")?.Find("name");
            yield return program.Find("cutBy");
        }
    }

    private JobStock ReadStock()
    {
        if (root.Find("stockMm") is not { } item)
        {
            return JobStock.Default;
        }

        var stock = new JobStock(item["roughing"].Number, item["semiFinishing"].Number);
        if (stock.RoughingMm < stock.SemiFinishingMm)
        {
            Refuse(
                item["roughing"],
                "stock-grows",
                $"{item["roughing"].Text} mm, less than the {item["semiFinishing"].Text} mm of semi-finishing",
                "at least the stock of semi-finishing");
        }

        return stock;
    }

    private JobTool ReadTool() => new(
        root["tool"]["diameterMm"].Number,
        (int)(root["tool"].Find("flutes")?.Number ?? 2),
        root["spindleRpm"].Number,
        root["feedMmPerMin"].Number);

    private JobMeasuring ReadMeasuring(JsonItem item)
    {
        var (curves, each, all, error) = (
            Count(item, "curves"), Count(item, "pointsPerCurve"), Count(item, "points"), item.Find("reconstructionErrorMm")?.Number);
        if (error is null && (curves is null || (each is null && all is null)))
        {
            Refuse(
                item,
                "points-missing",
                "no number of measuring points",
                "\"curves\" with \"pointsPerCurve\" or \"points\", or \"reconstructionErrorMm\"");
        }
        else if (error is not null && (curves ?? each ?? all) is not null)
        {
            Refuse(item["reconstructionErrorMm"], "points-twice", "a wanted error beside numbers of points", "one or the other");
        }
        else if (each is not null && all is not null)
        {
            Refuse(item["points"], "points-twice", "\"points\" beside \"pointsPerCurve\"", "one or the other");
        }
        else if (all < 2 * curves)
        {
            Refuse(item["points"], "too-few-points", $"{all} points on {curves} curves", $"at least {2 * curves}: both ends of each curve");
        }

        return new()
        {
            Curves = curves,
            PointsPerCurve = each,
            Points = all,
            ReconstructionErrorMm = error,
            StylusDiameterMm = item["stylusDiameterMm"].Number,
            ApproachMm = item.Find("approachMm")?.Number ?? 2,
            OvertravelMm = item.Find("overtravelMm")?.Number ?? 2,
            ClearanceMm = item.Find("clearanceMm")?.Number ?? 10,
            FeedMmPerMin = item.Find("feedMmPerMin")?.Number ?? 100,
            Dialect = item["dialect"].Text,
            Template = item.Find("template")?.Text,
            Tool = ReadToolCall(item.Find("tool")),
            CutBy = item.Find("cutBy")?.Text,
            ReportsStylusCenter = item.Find("reports")?.Text == "stylus-center",
            Format = root.Find("gauge")?.Find("format") is { } format
                ? MeasurementFormat.Read(format, Problems, MeasurementFormat.Recognized) ?? MeasurementFormat.Recognized
                : MeasurementFormat.Recognized,
            After = item.Find("measuredAfter")?.Text == "finishing" ? CuttingStage.Finishing : CuttingStage.SemiFinishing,
            UncertaintyMm = item.Find("uncertaintyMm")?.Number ?? 0.000125,
            Without = [.. (item.Find("without")?.Items ?? []).Select(i => (int)i.Number).Distinct().Order()],
            BestFit = item.Find("alignment")?.Text == "best-fit",
        };
    }

    // Lines of points, and surfaces through all of them, have no place for a point that is not there.
    private void CheckWithout(JobFit fit)
    {
        if (root["measuring"].Find("without") is { Items: [var first, ..] } && (fit.Method != FitMethod.Best || !fit.OfError))
        {
            Refuse(
                first,
                "points-left-out",
                $"a point left out of a fit by \"{fit.Method.Name}\" of {(fit.OfError ? "the error" : "the points")}",
                "\"method\": \"best\" and \"of\": \"error\" under \"fit\": the others need every point of the plan");
        }
    }

    private JobFit ReadFit() => root.Find("fit") is not { } item
        ? JobFit.Default
        : new(
            item.Find("method") is { } method ? FitMethod.Named(method.Text)! : JobFit.Default.Method,
            item.Find("of")?.Text != "points",
            item.Find("curveToleranceMm")?.Number ?? JobFit.Default.CurveToleranceMm);

    private JobToolpath ReadToolpath(JsonItem item) => new()
    {
        AlongU = item.Find("direction")?.Text != "v",
        Zigzag = item.Find("passes")?.Text == "zigzag",
        ScallopMm = item.Find("scallopMm")?.Number ?? 0.001,
        ChordMm = item.Find("chordMm")?.Number ?? 0.001,
        ClearanceMm = item.Find("clearanceMm")?.Number ?? 10,
        ProgramsTip = item.Find("programs")?.Text == "tip",
        Dialect = item["dialect"].Text,
        Template = item.Find("template")?.Text,
        Tool = ReadToolCall(item.Find("tool")),
    };

    private ToolCall? ReadToolCall(JsonItem? item)
    {
        if (item is null)
        {
            return null;
        }

        var (number, name) = (item.Find("number"), item.Find("name"));
        if (number is null == name is null)
        {
            var (code, found) = number is null
                ? ("tool-missing", "a tool without number and name")
                : ("tool-twice", "a tool by number and by name");
            Refuse(item, code, found, "\"number\", or on a control that knows names \"name\"");
        }
        else if (name is not null && !ToolCall.IsName(name.Text))
        {
            Refuse(
                name,
                "bad-tool-name",
                $"the name {ProbingLogReader.Shown(name.Text)}",
                $"at most {ToolCall.MostCharacters} letters, digits, spaces and _ - . + / #");
        }

        return new((int?)number?.Number, name?.Text, (int)item["lengthOffset"].Number);
    }

    private JobMirror ReadMirror() => root.Find("compensation") is not { } item
        ? JobMirror.Default
        : new(
            item.Find("method")?.Text != "tool-radius",
            item.Find("gain")?.Number ?? JobMirror.Default.Gain,
            item.Find("limitMm")?.Number ?? JobMirror.Default.LimitMm)
        {
            StepLimitMm = item.Find("stepLimitMm")?.Number,
        };

    private ProfileTolerance? ReadProfile(JobMeasuring measuring, JobMirror compensation)
    {
        if (root.Find("profileToleranceMm") is not { } item)
        {
            return null;
        }

        var rule = root.Find("decision") is { } decision && decision["rule"].Text == "guard-band"
            ? DecisionRule.GuardBand(decision.Find("riskPercent")?.Number ?? DecisionRule.DefaultRiskPercent)
            : DecisionRule.Simple;
        var tolerance = new ProfileTolerance(item.Number, rule, measuring.BestFit);
        var (u, limit, found) = (measuring.UncertaintyMm, compensation.LimitMm, item.Text + " mm");
        if (tolerance.Limits.UpperMm > limit)
        {
            Refuse(
                item,
                "limit-implausible",
                found,
                $"at most {Mm(2 * limit)}, twice compensation.limitMm, beyond which the job stops. µm? {item.Text} µm are "
                    + $"{Mm(item.Number / 1000)}");
        }
        else if (2 * u > tolerance.WidthMm)
        {
            Refuse(
                item,
                "gauge-too-coarse",
                found,
                $"at least {Mm(2 * u)}, the uncertainty of a measured point (k = 2): a coarser gauge cannot tell a good surface from a "
                    + "bad one");
        }
        else if (rule.AcceptanceLimits(tolerance.Limits, u) is null)
        {
            Refuse(
                item,
                "guard-bands-overlap",
                found,
                $"at least {Mm(Math.Ceiling(2e6 * rule.GuardMm(u)) / 1e6)}, or the guard bands of \"decision\" leave no error to accept");
        }

        return tolerance;
    }

    private static string Mm(double value) => value.ToString("0.######", CultureInfo.InvariantCulture) + " mm";

    private static int? Count(JsonItem item, string key) => (int?)item.Find(key)?.Number;

    private void Refuse(JsonItem item, string code, string found, string expected) =>
        Problems.Add(JsonRefusal.At(item, code, found, expected));
}
