using ErrorMatching.Json;

namespace ErrorMatching.Mating;

/// <summary>Reads comparisons in addition to those that every feature has.</summary>
/// <param name="problems">The problems of the job.</param>
/// <param name="features">The features, all of them read.</param>
internal sealed class ComparisonReader(JobProblems problems, FeatureReader features)
{
    /// <summary>Reads a list of comparisons.</summary>
    public List<JobComparison> Read(IReadOnlyList<JsonItem> items)
    {
        var comparisons = new List<JobComparison>();
        var names = new HashSet<string>(features.ByName.Keys, StringComparer.Ordinal);
        foreach (var item in items)
        {
            var name = item["name"].Text;
            if (!names.Add(name))
            {
                problems.Refuse(
                    item["name"], "duplicate-name", $"the name \"{name}\" again", "a name that no feature and no other comparison has");
            }

            if (item["quantity"].Text == "angle")
            {
                comparisons.Add(new AngleComparison(name, ReadElement(item["between"].Items[0]), ReadElement(item["between"].Items[1])));
            }
            else if (ReadComparedPoints(item["points"]) is { Count: > 0 } points)
            {
                comparisons.Add(new DeviationComparison(name, item["quantity"].Text == "deviation-x", points));
            }
        }

        return comparisons;
    }

    // Without the points that the job leaves out; none if it leaves out all of them.
    private List<string> ReadComparedPoints(JsonItem list)
    {
        var labels = features.Labels.Expand(list);
        labels.RemoveAll(l => features.Labels.IsLeftOut(l.Label));
        foreach (var (label, item) in labels.Where(l => !features.Labels.Contains(l.Label)))
        {
            problems.Refuse(item, "unknown-point", $"the point {label}", "a point of one of the features");
        }

        return [.. labels.Select(l => l.Label).Distinct(StringComparer.Ordinal)];
    }

    private ElementReference ReadElement(JsonItem item)
    {
        var slash = item.Text.IndexOf('/', StringComparison.Ordinal);
        var name = slash < 0 ? item.Text : item.Text[..slash];
        int? flank = slash < 0 ? null : item.Text[slash..] switch { "/1" => 1, "/2" => 2, _ => 0 };
        if (features.ByName.GetValueOrDefault(name)?.Element(flank) is null)
        {
            var expected = "the name " + string.Join(", or ", FeatureKinds.All.Select(k => k.ElementWords).OfType<string>());
            problems.Refuse(item, "unknown-element", $"\"{item.Text}\"", expected);
        }

        return new(name, flank);
    }
}
