using System.Text.Json;

namespace ErrorMatching.Hmi;

/// <summary>The generated tool path in a stored report. Lengths in mm.</summary>
/// <param name="Passes">Number of passes.</param>
/// <param name="Points">Number of points.</param>
/// <param name="LengthMm">Its length.</param>
/// <param name="ChordMm">The largest chordal error found.</param>
/// <param name="ScallopMm">The largest scallop.</param>
/// <param name="GougeMm">How far the ball gouges beyond what is allowed, at most.</param>
/// <param name="RaisedPoints">Number of points raised because the ball does not fit.</param>
/// <param name="RaisedMm">The largest amount by which they were raised.</param>
public sealed record KeptToolPath(
    int Passes, int Points, double LengthMm, double ChordMm, double ScallopMm, double GougeMm, int RaisedPoints, double RaisedMm)
{
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
