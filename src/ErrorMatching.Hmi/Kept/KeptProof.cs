using System.Text.Json;

namespace ErrorMatching.Hmi;

/// <summary>The proof in a kept report.</summary>
/// <param name="Holds">True if the new program moves as wanted and nothing else changed.</param>
/// <param name="Motions">How many motions were compared.</param>
/// <param name="MovedMotions">How many differ.</param>
/// <param name="MaxDeviationFromWantedMm">How far an end point or center is from where it was wanted, at most.</param>
/// <param name="UntouchedBytesIdentical">True if every byte outside the edits is the original one.</param>
public sealed record KeptProof(bool Holds, int Motions, int MovedMotions, double MaxDeviationFromWantedMm, bool UntouchedBytesIdentical)
{
    /// <summary>The comment that says what the program was made of, as it stands in it; null where it has none.</summary>
    public string? Marker { get; init; }

    /// <summary>Reads a proof.</summary>
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
