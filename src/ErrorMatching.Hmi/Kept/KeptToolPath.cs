using System.Text.Json;

namespace ErrorMatching.Hmi;

/// <summary>What a kept report says of the tool path that was made. Lengths in mm.</summary>
/// <param name="Passes">How many passes.</param>
/// <param name="Points">How many points.</param>
/// <param name="LengthMm">How long it is.</param>
/// <param name="ChordMm">The largest chordal error that was found.</param>
/// <param name="ScallopMm">The largest scallop.</param>
/// <param name="GougeMm">How far the ball comes nearer to the surface than it may, at most.</param>
/// <param name="RaisedPoints">Points that were raised where the ball does not fit.</param>
/// <param name="RaisedMm">By how much, at most.</param>
public sealed record KeptToolPath(int Passes, int Points, double LengthMm, double ChordMm, double ScallopMm, double GougeMm, int RaisedPoints, double RaisedMm)
{
    /// <summary>Reads it.</summary>
    internal static KeptToolPath Read(JsonElement json) => new(
        json.GetProperty("passes").GetInt32(),
        json.GetProperty("points").GetInt32(),
        json.GetProperty("lengthMm").GetDouble(),
        KeptSurface.Millimeters(json, "chordUm"),
        KeptSurface.Millimeters(json, "scallopUm"),
        KeptSurface.Millimeters(json, "gougeUm"),
        json.GetProperty("raisedPoints").GetInt32(),
        KeptSurface.Millimeters(json, "raisedUm"));
}
