using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;

namespace ErrorMatching.Jobs;

/// <summary>Creates a draft from a usable job.</summary>
internal sealed class DraftReader(JsonItem root, string file, MeasurementFile theoretical, string header)
{
    private static readonly string[] Columns = ["point", "x_mm", "y_mm", "z_mm"];
    private readonly Dictionary<string, PointDraft> _points = new(StringComparer.Ordinal);

    /// <summary>Reads the draft.</summary>
    /// <exception cref="DraftException">The job contains something that a draft cannot represent.</exception>
    public MatingDraft Read()
    {
        ReadPoints();
        var features = root["features"].Items.Select(Feature).ToArray();
        var used = features.SelectMany(f => f.Points).Select(p => p.Label).ToHashSet(StringComparer.Ordinal);
        var (alignment, origin) = (root.Find("alignment"), root.Find("originCheck"));
        return new()
        {
            SchemaUri = Text(root, "$schema"),
            Name = Text(root, "name"),
            WorkOrder = Text(root, "workOrder"),
            TheoreticalFile = Text(root["part"], "theoretical"),
            MeasuredFile = Text(root["part"], "measured"),
            Gauge = Gauge(root["gauge"]),
            Alignment = alignment is null ? new() : new(
                Text(alignment, "kind"),
                Text(alignment, "origin"),
                Text(alignment, "direction"),
                Locks(alignment, "x"),
                Locks(alignment, "y"),
                Locks(alignment, "rotation")),
            OriginPoint = Text(origin, "point"),
            OriginLimit = Text(origin, "limitMm"),
            Features = features,
            OtherPoints = [.. theoretical.Points.Where(p => !used.Contains(p.Label)).Select(p => _points[p.Label])],
            Counterpart = Counterpart(root["counterpart"]),
            Compensation = Compensation(root.Find("compensation")),
            Decision = new(Text(root.Find("decision"), "rule", DecisionDraft.Simple), Text(root.Find("decision"), "riskPercent")),
            Chain = [
                .. root.Find("toleranceChain")?.Items.Select(l => new ChainLinkDraft(
                    Text(l, "name"),
                    Text(l, "nominalMm"),
                    l["toleranceMm"].Items[0].Text,
                    l["toleranceMm"].Items[1].Text,
                    l["sign"].Number > 0 ? "1" : "-1"))
                    ?? []],
            Comparisons = [
                .. root.Find("verify")?.Items.Select(c => new ComparisonDraft(
                    Text(c, "name"), Text(c, "quantity"), Names(c["quantity"].Text == "angle" ? c["between"] : c["points"])))
                    ?? []],
            RecognitionJson = root.Find("recognition")?.ToJson() ?? "",
        };
    }

    private static string Text(JsonItem? item, string key, string otherwise = "") => item?.Find(key)?.Text ?? otherwise;

    private static bool Locks(JsonItem alignment, string what) => alignment.Find("locked")?.Items.Any(i => i.Text == what) ?? false;

    private void ReadPoints()
    {
        var (x, y, z) = (theoretical.ColumnTexts("x_mm"), theoretical.ColumnTexts("y_mm"), theoretical.ColumnTexts("z_mm"));
        if (x is null
            || y is null
            || x.Count != theoretical.Points.Count
            || header.Split(',').Any(c => !Columns.Contains(c.Trim(), StringComparer.OrdinalIgnoreCase)))
        {
            throw new DraftException(file, "$.part.theoretical", $"a file with other columns than {string.Join(", ", Columns)}");
        }

        for (var i = 0; i < theoretical.Points.Count; i++)
        {
            var label = theoretical.Points[i].Label;
            _points[label] = new(label, x[i].Trim(), y[i].Trim(), z?[i].Trim() ?? "");
        }
    }

    private FeatureDraft Feature(JsonItem item)
    {
        var kind = FeatureKinds.Of(item["kind"].Text);
        var (points, tolerance) = (item["points"], item["toleranceMm"]);
        var isStated = tolerance.Kind == JsonItemKind.List;
        return new()
        {
            Kind = kind,
            Name = Text(item, "name"),
            Flanks = kind.LeastPoints.Count > 1 ? [.. points.Items.Select(Points)] : [Points(points)],
            Blocks = Blocks(item["blocks"]),
            Tolerance = isStated ? FeatureDraft.Stated : tolerance.Text,
            Lower = isStated ? tolerance.Items[0].Text : "",
            Upper = isStated ? tolerance.Items[1].Text : "",
            Plane = Text(item, "plane", "XY"),
            Keys = kind.Keys.ToDictionary(k => k.Name, k => Text(item, k.Name, k.Default), StringComparer.Ordinal),
        };
    }

    private IReadOnlyList<PointDraft> Points(JsonItem list) =>
        [.. list.Items.SelectMany(i => LabelRange.Expand(i.Text)).Select(l => _points.GetValueOrDefault(l) ?? new PointDraft(l))];

    private string Blocks(JsonItem list)
    {
        var text = DraftList.Join(list.Items.Select(i => i.Text));
        return DraftList.Blocks(text).SequenceEqual(list.Items.Select(i => i.Text), StringComparer.Ordinal)
            ? text
            : throw new DraftException(file, list.Path, "this list of blocks");
    }

    private string Names(JsonItem list)
    {
        var text = DraftList.Join(list.Items.Select(i => i.Text));
        return DraftList.Names(text).SequenceEqual(list.Items.Select(i => i.Text), StringComparer.Ordinal)
            ? text
            : throw new DraftException(file, list.Path, "a name with a comma");
    }

    private static GaugeDraft Gauge(JsonItem item)
    {
        var (format, uncertainty, measuring) = (item["format"], item["uncertaintyMm"], item.Find("measuring"));
        var isSum = uncertainty.Kind == JsonItemKind.List;
        return new()
        {
            Format = format.Kind == JsonItemKind.Text ? format.Text : "",
            FormatJson = format.Kind == JsonItemKind.Text ? "" : format.ToJson(),
            LabelsJson = item.Find("labels")?.ToJson() ?? "",
            Uncertainty = isSum ? "" : uncertainty.Text,
            Contributions = isSum ? [.. uncertainty.Items.Select(c => new ContributionDraft(Text(c, "name"), Text(c, "valueMm")))] : [],
            AcceptsCoarse = item.Find("acceptCoarse")?.Flag ?? false,
            Reports = Text(item, "reports", "contact"),
            StylusDiameter = Text(item, "stylusDiameterMm"),
            ProbingSpeed = Text(measuring, "probingSpeedMmPerS"),
            ProbingDistance = Text(measuring, "probingDistanceMm"),
            Calculating = Text(measuring, "calculatingS"),
            Touches = Text(measuring, "touches"),
        };
    }

    private static CounterpartDraft Counterpart(JsonItem item)
    {
        var frame = item.Find("frame");
        var by = frame?.Find("translateMm")?.Items;
        return new(
            Text(item, "program"),
            Text(item, "dialect"),
            Text(item, "toolDiameterMm"),
            Text(item, "measured"),
            Text(frame, "mirror", "none"),
            Text(frame, "rotateDeg"),
            by?[0].Text ?? "",
            by?[1].Text ?? "",
            Text(item, "mapMm"),
            Text(item, "blockSkip"),
            string.Join(';', item.Find("libraries")?.Items.Select(i => i.Text) ?? []),
            string.Join(';', item.Find("assume")?.Members.Select(m => $"{m.Name}={m.Value.Text}") ?? []))
        {
            ProgramSha256 = Text(item, "programSha256"),
        };
    }

    private static CompensationDraft Compensation(JsonItem? item) => new(
        Text(item, "from", "part"),
        Text(item, "gain"),
        Text(item, "amount", "whole"),
        Text(item, "along", "normal"),
        Text(item, "limitMm"));
}
