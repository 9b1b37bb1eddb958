using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A face of a STEP file: a surface and the loops of edges that limit it.</summary>
internal static class StepFace
{
    /// <summary>True for a face, false for a surface without one.</summary>
    public static bool IsFace(StepInstance instance) => instance.Keyword is "ADVANCED_FACE" or "FACE_SURFACE";

    /// <summary>The surface of a face with its limits, or a surface as a whole.</summary>
    /// <exception cref="FreeformException">It is broken, or a kind of surface that is not read.</exception>
    public static ReadSurface Read(StepItem item, string name)
    {
        var face = IsFace(item.Instance) ? item.Instance.Records[0] : null;
        var surface = face?.Instance(2) ?? item.Instance;
        if (StepSplineSurface.Read(surface, item.MillimetersPerUnit) is { } spline)
        {
            return new(name, spline, SurfaceRegion.Whole);
        }

        throw surface.Records[0].Fail("not-read", $"a surface of the kind {surface.Keyword}, which is not read: B_SPLINE_SURFACE_WITH_KNOTS (rational too), BEZIER_SURFACE, PLANE and CYLINDRICAL_SURFACE are. Export the surface as a B-spline (NURBS)");
    }
}
