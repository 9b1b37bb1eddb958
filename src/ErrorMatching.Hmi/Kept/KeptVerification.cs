using System.Text.Json;
using ErrorMatching.Geometry;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi;

/// <summary>The stored verification report (<c>errormatch/verify/1</c>): the same numbers as the console's <c>verify --json</c>,
/// read and not recomputed.</summary>
/// <param name="JobName">Name of the job.</param>
/// <param name="WorkOrder">The job's work order; null if there is none.</param>
/// <param name="Result">How well both counterparts fit the part.</param>
/// <param name="Boundaries">The boundaries of the features.</param>
/// <param name="IsBeforeMeasured">True if the counterpart without compensation was measured, false if its nominal shape is used.</param>
public sealed record KeptVerification(
    string JobName, string? WorkOrder, VerificationResult Result, IReadOnlyList<VerifiedBoundary> Boundaries, bool IsBeforeMeasured)
{
    /// <summary>The measurement of the counterpart without compensation; null if its nominal shape is used.</summary>
    public KeptBase? Before { get; init; }

    /// <summary>Reads a report.</summary>
    /// <returns>The report; null if it is of another kind.</returns>
    public static KeptVerification? Read(ReadOnlyMemory<byte> json)
    {
        using var document = JsonDocument.Parse(json);
        var root = document.RootElement;
        if (root.GetProperty("schema").GetString() != VerifyReportJson.Schema)
        {
            return null;
        }

        var job = root.GetProperty("job");
        return new(
            job.GetProperty("name").GetString()!,
            job.GetProperty("workOrder").GetString(),
            new(
                [.. root.GetProperty("points").EnumerateArray().Select(Point)],
                [.. root.GetProperty("features").EnumerateArray().Select(Feature)]),
            [.. root.GetProperty("boundaries").EnumerateArray().Select(Boundary)],
            root.GetProperty("beforeMeasured").GetBoolean())
        {
            Before = root.GetProperty("inputs")
                .EnumerateArray()
                .Where(i => i.GetProperty("role").GetString() == "counterpart")
                .Select(i => new KeptBase(i.GetProperty("file").GetString()!, i.GetProperty("sha256").GetString()!))
                .FirstOrDefault(),
        };
    }

    private static VerifiedPoint Point(JsonElement json)
    {
        var part = KeptPoint.Place(json.GetProperty("part"));
        return new(
            json.GetProperty("point").GetString()!,
            part,
            part + Error(json.GetProperty("before")),
            part + Error(json.GetProperty("after")),
            KeptPoint.Place(json.GetProperty("normal")) - Point2.Origin);
    }

    private static Vector2 Error(JsonElement json) => new(json.GetProperty("dx").GetDouble(), json.GetProperty("dy").GetDouble());

    private static VerifiedFeature Feature(JsonElement json) => new(
        json.GetProperty("name").GetString()!,
        VerifiedQuantity.Of(json.GetProperty("quantity").GetString()!),
        json.GetProperty("wanted").GetDouble(),
        json.GetProperty("before").GetDouble(),
        json.GetProperty("after").GetDouble())
    {
        // Older reports lack this list.
        Points = json.TryGetProperty("points", out var points) ? [.. points.EnumerateArray().Select(p => p.GetString()!)] : [],
    };

    private static VerifiedBoundary Boundary(JsonElement json)
    {
        var band = json.GetProperty("toleranceMm");
        return new(
            json.GetProperty("name").GetString()!,
            new(band[0].GetDouble(), band[1].GetDouble()),
            [
                .. json.GetProperty("points")
                    .EnumerateArray()
                    .Select(p => (p.GetProperty("point").GetString()!, KeptPoint.Place(p.GetProperty("theoretical"))))],
            [.. json.GetProperty("outline").EnumerateArray().Select(KeptPoint.Place)]);
    }
}
