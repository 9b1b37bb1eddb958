using System.Text.Json;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>A measured point of a surface in a stored report.</summary>
/// <param name="Number">Its number in the measuring plan, in the order of measuring.</param>
/// <param name="Nominal">Its foot on the nominal surface, in mm.</param>
/// <param name="ErrorMm">Its error along the normal, in mm, positive for excess material.</param>
/// <param name="MirrorMm">Error expected to remain after mirroring.</param>
/// <param name="ToolRadiusMm">Error expected to remain with a modified tool radius.</param>
public sealed record KeptSurfacePoint(int Number, Point3 Nominal, double ErrorMm, double MirrorMm, double ToolRadiusMm)
{
    internal static KeptSurfacePoint Read(JsonElement json)
    {
        var nominal = json.GetProperty("nominal");
        return new(
            json.GetProperty("point").GetInt32(),
            new(nominal[0].GetDouble(), nominal[1].GetDouble(), nominal[2].GetDouble()),
            KeptSurface.Millimeters(json, "errorUm"),
            KeptSurface.Millimeters(json, "mirrorUm"),
            KeptSurface.Millimeters(json, "toolRadiusUm"));
    }
}
