using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Reads a face of a STEP file: a surface and the edge loops that bound it.</summary>
internal static class StepFace
{
    /// <summary>True for a face, false for a bare surface.</summary>
    public static bool IsFace(StepInstance instance) => instance.Keyword is "ADVANCED_FACE" or "FACE_SURFACE";

    /// <summary>Reads the surface of a face with its boundaries, or a complete surface.</summary>
    /// <exception cref="InputException">It is broken or not supported.</exception>
    public static ReadSurface Read(StepItem item, string name)
    {
        var (instance, scale) = item;
        var owner = instance.Records[0];
        var surface = IsFace(instance) ? owner.Instance(2) : instance;
        if (StepSplineSurface.Read(surface, scale) is { } spline)
        {
            if (!IsFace(instance))
            {
                return new(name, spline, SurfaceRegion.Whole);
            }

            var loops = Trace(owner, surface, scale, SurfaceMap.Of(spline), hasParameters: true);
            return new(name, spline, RegionLimits.Of(spline, loops, owner.Fail));
        }

        if (surface.Keyword is not ("PLANE" or "CYLINDRICAL_SURFACE"))
        {
            throw surface.Records[0].Fail(
                "not-read",
                "this kind of surface is not read: B_SPLINE_SURFACE_WITH_KNOTS (rational too), BEZIER_SURFACE, PLANE and "
                    + "CYLINDRICAL_SURFACE are. Export the surface as a B-spline (NURBS)");
        }

        if (!IsFace(instance))
        {
            throw owner.Fail("no-limits", "a plane or cylinder without a face, so without limits; a face is expected");
        }

        var record = surface.Records[0];
        var frame = StepPlacement.Of(record.Instance(1));
        var origin = new Point3(frame.Origin.X * scale, frame.Origin.Y * scale, frame.Origin.Z * scale);
        if (surface.Keyword == "PLANE")
        {
            var plane = new PlanePatch(origin, frame.X, frame.Y);
            var (flat, inside) = plane.Inside(Trace(owner, surface, scale, plane.Map, hasParameters: false), owner.Fail);
            return new(name, flat, inside);
        }

        var radius = record.Real(2) * scale;
        var cylinder = new CylinderPatch(
            origin,
            frame.X,
            frame.Y,
            frame.Z,
            radius > 0
                ? radius
                : throw record.Fail(
                    "bad-value", string.Create(CultureInfo.InvariantCulture, $"a radius of {radius}; a positive one is expected")));
        var (bent, region) = cylinder.Inside(Trace(owner, surface, scale, cylinder.Map, hasParameters: false), owner.Fail);
        return new(name, bent, region);
    }

    private static IReadOnlyList<IReadOnlyList<Point2>> Trace(
        StepRecord face, StepInstance surface, double scale, SurfaceMap map, bool hasParameters)
    {
        var tracer = new RegionTracer(map, face.Fail);
        var loops = new StepLoops(surface, scale, map, hasParameters, tracer);
        foreach (var bound in face.Instances(1))
        {
            loops.Trace(bound);
        }

        return tracer.Loops;
    }
}
