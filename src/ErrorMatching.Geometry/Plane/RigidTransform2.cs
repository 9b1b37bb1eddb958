namespace ErrorMatching.Geometry;

/// <summary>
/// A rigid motion of the plane, optionally mirrored first: mirror, then rotation about the origin, then translation.
/// </summary>
/// <param name="Mirror">What is mirrored before the rotation.</param>
/// <param name="Rotation">Counter-clockwise rotation about the origin.</param>
/// <param name="Translation">Displacement after mirror and rotation.</param>
public readonly record struct RigidTransform2(Mirror Mirror, Angle Rotation, Vector2 Translation)
{
    /// <summary>The transform that changes nothing.</summary>
    public static RigidTransform2 Identity => default;

    /// <summary>A pure translation.</summary>
    public static RigidTransform2 Translate(Vector2 by) => new(Mirror.None, default, by);

    /// <summary>A rotation about a point (equation 2 of Wang 2021, its printed signs and last term corrected).</summary>
    public static RigidTransform2 RotateAbout(Point2 center, Angle by)
    {
        var turned = new RigidTransform2(Mirror.None, by, Vector2.Zero).Apply(center);
        return new(Mirror.None, by, center - turned);
    }

    /// <summary>The place a point is carried to.</summary>
    public Point2 Apply(Point2 point) => Point2.Origin + Apply(point - Point2.Origin) + Translation;

    /// <summary>The displacement a vector becomes: mirrored and turned, never translated.</summary>
    public Vector2 Apply(Vector2 vector)
    {
        var (x, y) = Mirror switch { Mirror.X => (-vector.X, vector.Y), Mirror.Y => (vector.X, -vector.Y), _ => (vector.X, vector.Y) };
        var (sin, cos) = Math.SinCos(Rotation.Radians);
        return new((x * cos) - (y * sin), (x * sin) + (y * cos));
    }

    /// <summary>The transform that undoes this one.</summary>
    public RigidTransform2 Inverse()
    {
        // Mirror and rotation commute up to the sign of the angle, so the inverse has the same form.
        var rotation = Mirror == Mirror.None ? -Rotation : Rotation;
        var linear = new RigidTransform2(Mirror, rotation, Vector2.Zero);
        return linear with { Translation = -linear.Apply(Translation) };
    }
}
