using ErrorMatching.Geometry;
using ErrorMatching.Json;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>Reads the features of a job.</summary>
/// <param name="problems">The problems of the job.</param>
/// <param name="tolerances">Reads their limits.</param>
/// <param name="without">The key points that somebody took out of the job.</param>
internal sealed class FeatureReader(JobProblems problems, ToleranceReader tolerances, IReadOnlyList<JsonItem> without)
{
    private readonly Dictionary<string, JobFeature> _byName = new(StringComparer.Ordinal);

    /// <summary>The features that were read, by name.</summary>
    public IReadOnlyDictionary<string, JobFeature> ByName => _byName;

    /// <summary>The labels of their key points.</summary>
    public KeyPointLabels Labels { get; } = new(problems, without);

    /// <summary>Reads a feature.</summary>
    /// <param name="item">The feature in the job.</param>
    /// <param name="chain">The job's chain; null if it has none.</param>
    public JobFeature Read(JsonItem item, ToleranceChain? chain)
    {
        var name = item["name"].Text;
        var named = item.Find("blocks")?.Items ?? [];
        CheckBlocks(named);
        var blocks = named.Select(b => b.Text).ToArray();
        var tolerance = tolerances.ReadTolerance(item["toleranceMm"], chain);
        var plane = item.Find("plane")?.Text switch { "ZX" => CoordinatePlane.ZX, "YZ" => CoordinatePlane.YZ, _ => CoordinatePlane.XY };
        var feature = FeatureKinds.Of(item["kind"].Text).Read(new(item, name, blocks, tolerance, plane, Labels, problems));
        feature = feature with
        {
            GapMm = item.Find("gapMm")?.Number ?? 0,
            CorrectsBase = item.Find("base")?.Text == "correct",
            FormMm = item.Find("formMm")?.Number,
        };
        if (!_byName.TryAdd(name, feature))
        {
            problems.Refuse(item["name"], "duplicate-name", $"the name \"{name}\" again", "a name that no other feature has");
        }

        return feature;
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
                problems.Add(JsonRefusal.At(item, "bad-pattern", $"the pattern {item.Text}", Expected) with
                {
                    Message = e.Problem
                });
            }
        }
    }
}
