using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>Wish for one cutting motion: the displacement of its carrying line or circle in its plane, at its start, middle and
/// end.</summary>
/// <param name="Motion">Position of the motion in the path.</param>
/// <param name="Start">Displacement at its start, mm.</param>
/// <param name="Middle">Displacement halfway, mm. Ignored for lines, whose middle follows from the ends.</param>
/// <param name="End">Displacement at its end, mm.</param>
/// <param name="IsFillet">True for an arc that joins two displaced lines and must stay tangent to both: its radius changes by the mean of
/// the two ends.</param>
public readonly record struct ElementWish(int Motion, Vector2 Start, Vector2 Middle, Vector2 End, bool IsFillet = false)
{
    /// <summary>Creates a wish to displace a motion along its own normals by signed amounts, mm, positive to the left of travel.</summary>
    /// <exception cref="GeometryException">The motion does not move in its plane.</exception>
    public static ElementWish AlongNormals(NcPath path, int motion, double start, double middle, double end, bool isFillet = false)
    {
        var m = path.Motions[motion];
        return AlongNormals(m, motion, start, middle, end, isFillet);
    }

    /// <summary>Creates the same wish for a motion that the caller has already read.</summary>
    internal static ElementWish AlongNormals(in NcMotion m, int motion, double start, double middle, double end, bool isFillet = false)
    {
        if (m.IsArc)
        {
            return new(motion, m.TangentAt(0).Left * start, m.TangentAt(0.5).Left * middle, m.TangentAt(1).Left * end, isFillet);
        }

        var normal = m.TangentAt(0).Left;
        return new(motion, normal * start, normal * middle, normal * end, isFillet);
    }
}
