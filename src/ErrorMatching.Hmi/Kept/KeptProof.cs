using System.Text.Json;

namespace ErrorMatching.Hmi;

/// <summary>The proof in a stored report.</summary>
/// <param name="Holds">True if the new program moves as intended and nothing else changed.</param>
/// <param name="Motions">Number of motions compared.</param>
/// <param name="MovedMotions">Number of motions that differ.</param>
/// <param name="MaxDeviationFromWantedMm">Largest distance of an end point or center from its intended position.</param>
/// <param name="UntouchedBytesIdentical">True if all bytes outside the edits are the original ones.</param>
public sealed record KeptProof(bool Holds, int Motions, int MovedMotions, double MaxDeviationFromWantedMm, bool UntouchedBytesIdentical)
{
    /// <summary>The comment in the program that tells its origin, as written; null if there is none.</summary>
    public string? Marker { get; init; }

    internal static KeptProof Read(JsonElement json) => new(
        json.GetProperty("holds").GetBoolean(),
        json.GetProperty("motions").GetInt32(),
        json.GetProperty("movedMotions").GetInt32(),
        json.GetProperty("maxDeviationFromWantedMm").GetDouble(),
        json.GetProperty("untouchedBytesIdentical").GetBoolean())
    {
        Marker = json.TryGetProperty("marker", out var marker) ? marker.GetString() : null,
    };
}
