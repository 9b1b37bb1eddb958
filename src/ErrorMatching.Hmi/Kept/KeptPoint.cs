using System.Text.Json;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>A key point in a stored report. Positions are in the part's frame, in mm.</summary>
/// <param name="Point">Its label.</param>
/// <param name="Feature">Name of its feature.</param>
/// <param name="Theoretical">Nominal position.</param>
/// <param name="Actual">Measured position.</param>
/// <param name="Correction">What is added to the program there, in the program's frame.</param>
/// <param name="Normal">Unit normal, from the counterpart's material to its tool.</param>
/// <param name="NormalMm">Actual - theoretical along the normal.</param>
/// <param name="DecidedMm">The deviation that was the basis of the decision, along the normal.</param>
/// <param name="ExcessMm">The part of it beyond the limit.</param>
/// <param name="PredictedMm">The part of it predicted to remain on the corrected counterpart.</param>
/// <param name="Blocks">Blocks of the original program that cut the point.</param>
public sealed record KeptPoint(
    string Point,
    string Feature,
    Point2 Theoretical,
    Point2 Actual,
    Vector2 Correction,
    Vector2 Normal,
    double NormalMm,
    double DecidedMm,
    double ExcessMm,
    double PredictedMm,
    IReadOnlyList<string> Blocks)
{
    internal static KeptPoint Read(JsonElement json) => new(
        json.GetProperty("point").GetString()!,
        json.GetProperty("feature").GetString()!,
        Place(json.GetProperty("theoretical")),
        Place(json.GetProperty("actual")),
        Place(json.GetProperty("correction")) - Point2.Origin,
        Place(json.GetProperty("normal")) - Point2.Origin,
        json.GetProperty("normalMm").GetDouble(),
        json.GetProperty("decidedMm").GetDouble(),
        json.GetProperty("excessMm").GetDouble(),
        json.GetProperty("predictedMm").GetDouble(),
        [.. json.GetProperty("blocks").EnumerateArray().Select(b => b.GetString()!)]);

    internal static Point2 Place(JsonElement json) => new(json.GetProperty("x").GetDouble(), json.GetProperty("y").GetDouble());
}
