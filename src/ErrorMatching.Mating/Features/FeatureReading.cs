using ErrorMatching.Geometry;
using ErrorMatching.Json;

namespace ErrorMatching.Mating;

/// <summary>A feature of a job during reading: the common properties, and access to those of its kind.</summary>
/// <param name="Item">The feature in the job.</param>
/// <param name="Name">Its name.</param>
/// <param name="Blocks">Selectors of its blocks.</param>
/// <param name="Tolerance">Its limits.</param>
/// <param name="Plane">Its plane.</param>
/// <param name="Labels">The labels of all key points.</param>
/// <param name="Problems">The problems of the job.</param>
internal sealed record FeatureReading(
    JsonItem Item,
    string Name,
    IReadOnlyList<string> Blocks,
    JobTolerance Tolerance,
    CoordinatePlane Plane,
    KeyPointLabels Labels,
    JobProblems Problems)
{
    /// <summary>Its labels, list by list, each with the kind's minimum number; errors become problems of the job.</summary>
    /// <param name="kind">The kind.</param>
    public IReadOnlyList<List<string>> Points(FeatureKind kind)
    {
        var points = Item["points"];
        return kind.LeastPoints.Count == 1
            ? [Labels.Read(points, Name, kind.LeastPoints[0])]
            : [.. kind.LeastPoints.Select((least, i) => Labels.Read(points.Items[i], Name, least))];
    }

    /// <summary>A number; null if it is missing or chosen automatically.</summary>
    public double? Number(string key) => Item.Find(key) is { Kind: JsonItemKind.Number } n ? n.Number : null;

    /// <summary>Adds a problem with one of its keys to the job's.</summary>
    public void Refuse(string key, string code, string found, string expected) => Problems.Refuse(Item[key], code, found, expected);
}
