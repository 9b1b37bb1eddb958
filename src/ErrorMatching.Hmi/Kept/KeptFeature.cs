using System.Text.Json;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>A feature in a stored report.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Kind">line, triangle or curve.</param>
/// <param name="Decision">compensated, within-tolerance or not-significant.</param>
/// <param name="LowerMm">Lower limit of its normal deviation.</param>
/// <param name="UpperMm">Upper limit of its normal deviation.</param>
/// <param name="LargestMm">The normal deviation with the largest absolute value, with its sign.</param>
/// <param name="UncertaintyMm">Standard uncertainty of a normal deviation.</param>
/// <param name="Quantities">Its lengths and angles.</param>
/// <param name="Outline">The boundary that the original program cuts, in the part's frame.</param>
public sealed record KeptFeature(
    string Name,
    string Kind,
    string Decision,
    double LowerMm,
    double UpperMm,
    double LargestMm,
    double UncertaintyMm,
    IReadOnlyList<KeptQuantity> Quantities,
    IReadOnlyList<Point2> Outline)
{
    internal static KeptFeature Read(JsonElement json)
    {
        var tolerance = json.GetProperty("toleranceMm");
        var (actual, corrected) = (json.GetProperty("actual"), json.GetProperty("corrected"));
        return new(
            json.GetProperty("name").GetString()!,
            json.GetProperty("kind").GetString()!,
            json.GetProperty("decision").GetString()!,
            tolerance[0].GetDouble(),
            tolerance[1].GetDouble(),
            json.GetProperty("largestMm").GetDouble(),
            json.GetProperty("uncertaintyMm").GetDouble(),
            [
                .. json.GetProperty("theoretical")
                    .EnumerateObject()
                    .Select(q => new KeptQuantity(q.Name, q.Value.GetDouble(), Number(actual, q.Name), Number(corrected, q.Name)))],
            [.. json.GetProperty("outline").GetProperty("theoretical").EnumerateArray().Select(KeptPoint.Place)]);
    }

    private static double? Number(JsonElement json, string name) =>
        json.TryGetProperty(name, out var value) && value.ValueKind == JsonValueKind.Number ? value.GetDouble() : null;
}
