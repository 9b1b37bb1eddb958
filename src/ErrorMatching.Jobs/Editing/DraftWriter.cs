using System.Globalization;
using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json.Nodes;

namespace ErrorMatching.Jobs;

/// <summary>Writes a draft as a job. Text that is not a number is written as text, so that the job's reader reports it with its
/// place.</summary>
internal sealed class DraftWriter(MatingDraft draft)
{
    private static readonly System.Text.Json.JsonSerializerOptions Plain = new() { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    /// <summary>The job's file, with one line per key and one per feature.</summary>
    public byte[] Job()
    {
        var root = new JsonObject();
        Optional(root, "$schema", draft.SchemaUri);
        root["kind"] = "mating";
        root["name"] = draft.Name.Trim();
        Optional(root, "workOrder", draft.WorkOrder);
        root["part"] = new JsonObject { ["theoretical"] = draft.TheoreticalFile.Trim(), ["measured"] = draft.MeasuredFile.Trim() };
        root["gauge"] = Gauge();
        root["alignment"] = Alignment();
        if (HasText(draft.OriginPoint) || HasText(draft.OriginLimit))
        {
            root["originCheck"] = new JsonObject { ["point"] = draft.OriginPoint.Trim(), ["limitMm"] = Number(draft.OriginLimit) };
        }

        root["features"] = List(draft.Features, Feature);
        root["counterpart"] = Counterpart();
        root["compensation"] = Compensation();
        if (draft.Decision.Rule != DecisionDraft.Simple)
        {
            var decision = new JsonObject { ["rule"] = draft.Decision.Rule };
            OptionalNumber(decision, "riskPercent", draft.Decision.Risk);
            root["decision"] = decision;
        }

        if (draft.Chain.Count > 0)
        {
            root["toleranceChain"] = List(
                draft.Chain,
                l => new JsonObject
                {
                    ["name"] = l.Name.Trim(),
                    ["nominalMm"] = Number(l.Nominal),
                    ["toleranceMm"] = new JsonArray(Number(l.Lower), Number(l.Upper)),
                    ["sign"] = Number(l.Sign)
                });
        }

        Raw(root, "recognition", draft.RecognitionJson);
        if (draft.Comparisons.Count > 0)
        {
            root["verify"] = List(
                draft.Comparisons,
                c => new JsonObject
                {
                    ["name"] = c.Name.Trim(),
                    ["quantity"] = c.Quantity,
                    [c.Quantity == "angle" ? "between" : "points"] = Texts(DraftList.Names(c.Of))
                });
        }

        return Encoding.UTF8.GetBytes(Lines(root));
    }

    private JsonObject Gauge()
    {
        var g = draft.Gauge;
        var gauge = new JsonObject();
        if (HasText(g.FormatJson))
        {
            Raw(gauge, "format", g.FormatJson);
        }
        else
        {
            gauge["format"] = g.Format.Trim();
        }

        if (HasText(g.LabelsJson))
        {
            Raw(gauge, "labels", g.LabelsJson);
        }

        gauge["uncertaintyMm"] = g.Contributions.Count == 0
            ? Number(g.Uncertainty)
            : List(g.Contributions, c => new JsonObject { ["name"] = c.Name.Trim(), ["valueMm"] = Number(c.Value) });
        if (g.AcceptsCoarse)
        {
            gauge["acceptCoarse"] = true;
        }

        gauge["reports"] = g.Reports;
        OptionalNumber(gauge, "stylusDiameterMm", g.StylusDiameter);
        var measuring = new JsonObject();
        OptionalNumber(measuring, "probingSpeedMmPerS", g.ProbingSpeed);
        OptionalNumber(measuring, "probingDistanceMm", g.ProbingDistance);
        OptionalNumber(measuring, "calculatingS", g.Calculating);
        OptionalNumber(measuring, "touches", g.Touches);
        if (measuring.Count > 0)
        {
            gauge["measuring"] = measuring;
        }

        return gauge;
    }

    private JsonObject Alignment()
    {
        var (a, alignment) = (draft.Alignment, new JsonObject { ["kind"] = draft.Alignment.Kind });
        switch (a.Kind)
        {
            case "datum":
                (alignment["origin"], alignment["direction"]) = (a.Origin.Trim(), a.Direction.Trim());
                break;
            case "best-fit" when a.LockX || a.LockY || a.LockRotation:
                alignment["locked"] = Texts(
                    new[] { a.LockX ? "x" : "", a.LockY ? "y" : "", a.LockRotation ? "rotation" : "" }.Where(l => l.Length > 0));
                break;
            default:
                break;
        }

        return alignment;
    }

    private static JsonObject Feature(FeatureDraft f)
    {
        var feature = new JsonObject
        {
            ["name"] = f.Name.Trim(),
            ["kind"] = f.Kind.Word,
            ["points"] = f.Flanks.Count > 1
                ? List(f.Flanks, k => Texts(k.Select(p => p.Label.Trim())))
                : Texts(f.Points.Select(p => p.Label.Trim())),
            ["blocks"] = Texts(DraftList.Blocks(f.Blocks)),
            ["toleranceMm"] = f.Tolerance == FeatureDraft.Stated ? new JsonArray(Number(f.Lower), Number(f.Upper)) : f.Tolerance,
        };
        if (f.Plane != "XY")
        {
            feature["plane"] = f.Plane;
        }

        foreach (var key in f.Kind.Keys)
        {
            if (key.Words.Count > 0)
            {
                feature[key.Name] = f.Key(key.Name);
            }
            else
            {
                OptionalNumber(feature, key.Name, f.Key(key.Name));
            }
        }

        return feature;
    }

    private JsonObject Counterpart()
    {
        var c = draft.Counterpart;
        var counterpart = new JsonObject
        {
            ["program"] = c.Program.Trim(),
            ["dialect"] = c.Dialect.Trim(),
            ["toolDiameterMm"] = Number(c.ToolDiameter)
        };
        Optional(counterpart, "measured", c.Measured);
        var frame = new JsonObject { ["mirror"] = c.Mirror };
        OptionalNumber(frame, "rotateDeg", c.Rotate);
        if (HasText(c.TranslateX) || HasText(c.TranslateY))
        {
            frame["translateMm"] = new JsonArray(Number(c.TranslateX), Number(c.TranslateY));
        }

        counterpart["frame"] = frame;
        OptionalNumber(counterpart, "mapMm", c.Map);
        Optional(counterpart, "blockSkip", c.BlockSkip);
        if (HasText(c.Assume))
        {
            var assume = new JsonObject();
            foreach (var stated in c.Assume.Split(';', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries))
            {
                var equals = stated.LastIndexOf('=');
                assume[equals < 0 ? stated : stated[..equals]] = Number(equals < 0 ? "" : stated[(equals + 1)..]);
            }

            counterpart["assume"] = assume;
        }

        Optional(counterpart, "programSha256", c.ProgramSha256);
        if (HasText(c.Libraries))
        {
            counterpart["libraries"] = Texts(c.LibraryList);
        }

        return counterpart;
    }

    private JsonObject Compensation()
    {
        var (c, compensation) = (draft.Compensation, new JsonObject { ["from"] = draft.Compensation.From });
        OptionalNumber(compensation, "gain", c.Gain);
        (compensation["amount"], compensation["along"]) = (c.Amount, c.Along);
        OptionalNumber(compensation, "limitMm", c.Limit);
        return compensation;
    }

    private static bool HasText(string text) => !string.IsNullOrWhiteSpace(text);

    private static JsonNode Number(string text) =>
        DraftNumber.Json(text) is { } number ? JsonNode.Parse(number)! : JsonValue.Create(text.Trim());

    private static void Optional(JsonObject to, string key, string text)
    {
        if (HasText(text))
        {
            to[key] = text.Trim();
        }
    }

    private static void OptionalNumber(JsonObject to, string key, string text)
    {
        if (HasText(text))
        {
            to[key] = Number(text);
        }
    }

    private static void Raw(JsonObject to, string key, string json)
    {
        if (HasText(json))
        {
            to[key] = JsonNode.Parse(json);
        }
    }

    private static JsonArray Texts(IEnumerable<string> texts) => new([.. texts.Select(t => (JsonNode)JsonValue.Create(t))]);

    private static JsonArray List<T>(IEnumerable<T> items, Func<T, JsonNode> of) => new([.. items.Select(of)]);

    private static string Lines(JsonObject root) =>
        "{\n" + string.Join(",\n", root.Select(m => string.Create(CultureInfo.InvariantCulture, $"  {Text(m.Key)}: {Value(m.Value!)}")))
            + "\n}\n";

    private static string Value(JsonNode value) => value is JsonArray { Count: > 0 } list && list[0] is JsonObject
        ? "[\n" + string.Join(",\n", list.Select(i => "    " + OneLine(i!))) + "\n  ]"
        : OneLine(value);

    private static string OneLine(JsonNode value) => value switch
    {
        JsonObject o => "{ " + string.Join(", ", o.Select(m => $"{Text(m.Key)}: {OneLine(m.Value!)}")) + " }",
        JsonArray a => "[" + string.Join(", ", a.Select(i => OneLine(i!))) + "]",
        _ => value.ToJsonString(Plain),
    };

    private static string Text(string text) => JsonEdit.Text(text);
}
