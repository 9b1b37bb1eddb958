using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Reads the IGES plane (entity 108): a x + b y + c z = d.</summary>
internal static class IgesPlane
{
    /// <summary>Returns the plane in millimeters.</summary>
    /// <exception cref="InputException">It has no normal.</exception>
    public static PlanePatch Read(IgesFile file, IgesEntity entity, IgesTransform outer)
    {
        var map = outer.After(IgesTransform.Of(file, entity));
        var parameters = file.ParametersOf(entity);
        var p = parameters.Reals("the plane", 4);
        var normal = new Vector3(p[0], p[1], p[2]);
        if (!(normal.Length > 0))
        {
            throw parameters.Fail("bad-surface", "a plane whose normal has length 0");
        }

        // Maps three of its points. They still span a plane, even if the map stretches.
        var x = (Math.Abs(normal.X) <= Math.Abs(normal.Z) ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0)) is var along
            ? (along - (normal * (along.Dot(normal) / normal.Dot(normal)))).Normalize()
            : default;
        var y = normal.Normalize().Cross(x);
        var foot = normal * (p[3] / normal.Dot(normal));
        var (origin, atX, atY) = (
            map.Map(foot, file.MillimetersPerUnit), map.Map(foot + x, file.MillimetersPerUnit), map.Map(foot + y, file.MillimetersPerUnit));
        var first = (atX - origin).Normalize();
        var second = atY - origin;
        return new(origin, first, (second - (first * second.Dot(first))).Normalize());
    }

    /// <summary>Pointer to the closed curve that bounds a plane of form 1; 0 if none.</summary>
    public static int BoundaryOf(IgesFile file, IgesEntity entity)
    {
        var parameters = file.ParametersOf(entity);
        parameters.Reals("the plane", 4);
        return parameters.Left == 0 ? 0 : parameters.Int("the closed curve");
    }
}
