using ErrorMatching.Json;

namespace ErrorMatching.Mating;

/// <content>Comparisons in addition to those that every feature has.</content>
internal sealed partial class JobReader
{
    private List<JobComparison> ReadComparisons()
    {
        var comparisons = new List<JobComparison>();
        var names = new HashSet<string>(_features.Keys, StringComparer.Ordinal);
        foreach (var item in root.Find("verify")?.Items ?? [])
        {
            var name = item["name"].Text;
            if (!names.Add(name))
            {
                Refuse(item["name"], "duplicate-name", $"the name \"{name}\" again", "a name that no feature and no other comparison has");
            }

            comparisons.Add(item["quantity"].Text == "angle"
                ? new AngleComparison(name, ReadElement(item["between"].Items[0]), ReadElement(item["between"].Items[1]))
                : new DeviationComparison(name, item["quantity"].Text == "deviation-x", ReadComparedPoints(item["points"])));
        }

        return comparisons;
    }

    private List<string> ReadComparedPoints(JsonItem list)
    {
        var labels = Labels(list);
        foreach (var (label, item) in labels.Where(l => !_featureOfPoint.ContainsKey(l.Label)))
        {
            Refuse(item, "unknown-point", $"the point {label}", "a point of one of the features");
        }

        return [.. labels.Select(l => l.Label).Distinct(StringComparer.Ordinal)];
    }

    private ElementReference ReadElement(JsonItem item)
    {
        var slash = item.Text.IndexOf('/', StringComparison.Ordinal);
        var name = slash < 0 ? item.Text : item.Text[..slash];
        int? flank = slash < 0 ? null : item.Text[slash..] switch { "/1" => 1, "/2" => 2, _ => 0 };
        if (_features.GetValueOrDefault(name)?.Element(flank) is null)
        {
            var expected = "the name " + string.Join(", or ", FeatureKinds.All.Select(k => k.ElementWords).OfType<string>());
            Refuse(item, "unknown-element", $"\"{item.Text}\"", expected);
        }

        return new(name, flank);
    }
}
