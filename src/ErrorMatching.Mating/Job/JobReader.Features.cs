using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Json;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <content>Features: their points, limits and blocks.</content>
internal sealed partial class JobReader
{
    private JobFeature ReadFeature(JsonItem item, ToleranceChain? chain)
    {
        var name = item["name"].Text;
        var named = item.Find("blocks")?.Items ?? [];
        CheckBlocks(named);
        var blocks = named.Select(b => b.Text).ToArray();
        var tolerance = ReadTolerance(item["toleranceMm"], chain);
        var plane = item.Find("plane")?.Text switch { "ZX" => CoordinatePlane.ZX, "YZ" => CoordinatePlane.YZ, _ => CoordinatePlane.XY };
        var feature = FeatureKinds.Of(item["kind"].Text).Read(new(item, name, blocks, tolerance, plane, this));
        if (!_features.TryAdd(name, feature))
        {
            Refuse(item["name"], "duplicate-name", $"the name \"{name}\" again", "a name that no other feature has");
        }

        return feature;
    }

    private JobTolerance ReadTolerance(JsonItem item, ToleranceChain? chain)
    {
        if (item.Kind == JsonItemKind.List)
        {
            return new(ReadBand(item), ToleranceSource.Stated) { Place = item.Place };
        }

        var source = item.Text == "chain:rss" ? ToleranceSource.RootSumOfSquares : ToleranceSource.WorstCase;
        if (chain is null)
        {
            Refuse(
                item,
                "chain-missing",
                $"\"{item.Text}\" in a job without \"toleranceChain\"",
                "a tolerance chain, or a lower and an upper limit");
            return new(default, source);
        }

        var computed = source == ToleranceSource.WorstCase ? chain.WorstCase() : chain.RootSumOfSquares();
        return new(computed.Band, source) { Place = item.Place };
    }

    /// <summary>The labels of a list of points; errors become problems of the job.</summary>
    public List<string> ReadPoints(JsonItem list, string feature, int least)
    {
        var labels = Labels(list);
        foreach (var (label, item) in labels)
        {
            // A point in two features would have two normals and two corrections.
            if (!_featureOfPoint.TryAdd(label, feature))
            {
                Refuse(
                    item,
                    "duplicate-point",
                    $"the point {label} again, which belongs to {_featureOfPoint[label]}",
                    "each point in one place");
            }
        }

        if (labels.Count < least)
        {
            Refuse(
                list,
                "too-few-points",
                string.Create(CultureInfo.InvariantCulture, $"{labels.Count} point(s)"),
                string.Create(CultureInfo.InvariantCulture, $"at least {least}"));
        }

        return [.. labels.Select(l => l.Label)];
    }

    private List<(string Label, JsonItem Item)> Labels(JsonItem list)
    {
        var labels = new List<(string, JsonItem)>();
        foreach (var item in list.Items)
        {
            try
            {
                labels.AddRange(LabelRange.Expand(item.Text).Select(l => (l, item)));
            }
            catch (InputException e)
            {
                Refuse(item, "bad-range", e.Refusals[0].Found, e.Refusals[0].Expected);
            }
        }

        return labels;
    }

    private void CheckBlocks(IReadOnlyList<JsonItem> blocks)
    {
        foreach (var item in blocks.Where(i => i.Text.StartsWith('/')))
        {
            try
            {
                _ = BlockSelector.Parse(item.Text);
            }
            catch (InputException e)
            {
                const string Expected = "a regular expression without look-around and back references";
                Problems.Add(JsonRefusal.At(item, "bad-pattern", $"the pattern {item.Text}", Expected) with
                {
                    Message = e.Problem
                });
            }
        }
    }
}
