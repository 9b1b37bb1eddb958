using System.Globalization;
using ErrorMatching.Json;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The labels of a job's key points during reading: each belongs to one feature.</summary>
/// <param name="problems">The problems of the job.</param>
/// <param name="without">The points that somebody took out of the job.</param>
internal sealed class KeyPointLabels(JobProblems problems, IReadOnlyList<JsonItem> without)
{
    private readonly HashSet<string> _without = new(without.Select(i => i.Text), StringComparer.Ordinal);
    private readonly HashSet<string> _taken = new(StringComparer.Ordinal);
    private readonly Dictionary<string, string> _features = new(StringComparer.Ordinal);

    /// <summary>True if a feature that was read has the point.</summary>
    public bool Contains(string label) => _features.ContainsKey(label);

    /// <summary>True if the job leaves the point out.</summary>
    public bool IsLeftOut(string label) => _without.Contains(label);

    /// <summary>The labels of a list of points; errors become problems of the job.</summary>
    public List<string> Read(JsonItem list, string feature, int least)
    {
        var labels = Expand(list);
        _taken.UnionWith(labels.Select(l => l.Label).Where(_without.Contains));
        labels.RemoveAll(l => _without.Contains(l.Label));
        foreach (var (label, item) in labels)
        {
            // A point in two features would have two normals and two corrections.
            if (!_features.TryAdd(label, feature))
            {
                problems.Refuse(
                    item,
                    "duplicate-point",
                    $"the point {label} again, which belongs to {_features[label]}",
                    "each point in one place");
            }
        }

        if (labels.Count < least)
        {
            problems.Refuse(
                list,
                "too-few-points",
                ReportNumber.Count(labels.Count, "point"),
                string.Create(CultureInfo.InvariantCulture, $"at least {least}"));
        }

        return [.. labels.Select(l => l.Label)];
    }

    /// <summary>Refuses points that are to be taken out of a job and are in none of its features. Called when all are read.</summary>
    public void CheckWithout()
    {
        foreach (var item in without.Where(i => !_taken.Contains(i.Text)))
        {
            problems.Refuse(item, "unknown-point", $"the point {item.Text}, which no feature has", "a key point of a feature");
        }
    }

    /// <summary>The labels of a list, ranges expanded, each with its item; errors become problems of the job.</summary>
    public List<(string Label, JsonItem Item)> Expand(JsonItem list)
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
                problems.Refuse(item, "bad-range", e.Refusals[0].Found, e.Refusals[0].Expected);
            }
        }

        return labels;
    }
}
