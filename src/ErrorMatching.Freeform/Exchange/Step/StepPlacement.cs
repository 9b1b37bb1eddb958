using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>A coordinate frame (AXIS2_PLACEMENT_3D) in the file's unit.</summary>
/// <param name="Origin">Its origin.</param>
/// <param name="X">Its first unit axis.</param>
/// <param name="Y">Its second axis.</param>
/// <param name="Z">Its third axis.</param>
internal sealed record StepPlacement(Vector3 Origin, Vector3 X, Vector3 Y, Vector3 Z)
{
    /// <summary>Reads the frame of an instance. Omitted axes get the defaults of ISO 10303-42 (axis z, ref_direction x, made
    /// perpendicular).</summary>
    /// <exception cref="InputException">It is not a frame, or its axes are parallel or of length zero.</exception>
    public static StepPlacement Of(StepInstance instance)
    {
        var record = instance.Get("AXIS2_PLACEMENT_3D");
        var origin = record.Coordinates(record.At(1), 1, "CARTESIAN_POINT");
        var axis = record.At(2).Kind == StepValueKind.Omitted ? new(0, 0, 1) : record.Coordinates(record.At(2), 2, "DIRECTION");
        var wanted = record.At(3).Kind == StepValueKind.Omitted
            ? Math.Abs(axis.Y) + Math.Abs(axis.Z) > 1e-12 * axis.Length
            ? new(1, 0, 0)
            : new Vector3(0, 1, 0)
            : record.Coordinates(record.At(3), 3, "DIRECTION");
        try
        {
            var z = axis.Normalize();
            var x = (wanted - (z * wanted.Dot(z))).Normalize();
            return new(origin, x, z.Cross(x), z);
        }
        catch (GeometryException)
        {
            throw record.Fail("bad-value", "axes of length zero or parallel to each other; two that span a plane are expected");
        }
    }
}
