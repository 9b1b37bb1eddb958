using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Determines on which side of a surface the material is, from up and down.</summary>
internal static class SurfaceSide
{
    private const int Steps = 24;
    private const int Many = 200;

    /// <summary>A normal with a smaller z component is horizontal.</summary>
    private const double Level = 1e-9;

    /// <summary>Returns +1 if the surface's own normal points out of the material, otherwise -1.</summary>
    /// <exception cref="InputException">The normal points up in some places and down in others, or is horizontal everywhere.</exception>
    public static int Of(ReadSurface surface, string file, bool outsideIsUp)
    {
        var (spline, up, down) = (surface.Spline, default(SurfacePoint?), default(SurfacePoint?));
        foreach (var u in Places(spline.KnotsU))
        {
            foreach (var v in Places(spline.KnotsV))
            {
                if (surface.Region.Contains(u, v))
                {
                    var at = spline.At(u, v);
                    up = at.Normal.Z > Level ? at : up;
                    down = at.Normal.Z < -Level ? at : down;
                }
            }
        }

        return (up, down) switch
        {
            (not null, null) => outsideIsUp ? 1 : -1,
            (null, not null) => outsideIsUp ? -1 : 1,
            (null, null) =>
                throw InputException.At(
                    "upright-surface",
                    file,
                    $"surface {surface.Name} stands upright everywhere: its normal points neither to +z nor to -z. Turn the piece as it "
                        + $"is cut, the tool's axis along z"),
            _ =>
                throw InputException.At(
                    "folded-surface",
                    file,
                    $"surface {surface.Name} turns over: its normal points up at {Place(up.Value.Position)} and down at "
                        + $"{Place(down.Value.Position)}. A surface is expected that the tool reaches along z"),
        };
    }

    // Samples inside each span and at its ends, so that no span of the surface is missed.
    private static IEnumerable<double> Places(KnotVector knots)
    {
        var breaks = knots.Breaks;
        var each = Math.Max(breaks.Count > Many ? 1 : 2, Steps / (breaks.Count - 1));
        for (var i = 1; i < breaks.Count; i++)
        {
            for (var k = i == 1 ? 0 : 1; k <= each; k++)
            {
                yield return breaks[i - 1] + ((breaks[i] - breaks[i - 1]) * k / each);
            }
        }
    }

    private static string Place(Point3 p) => PlaceText.Triple(p);
}
