namespace ErrorMatching.Geometry;

/// <summary>A rigid motion of the plane with an optional reflection: reflection, rotation about the origin, then translation.</summary>
/// <param name="Mirror">The reflection before the rotation.</param>
/// <param name="Rotation">Counterclockwise rotation about the origin.</param>
/// <param name="Translation">Displacement after reflection and rotation.</param>
public readonly record struct RigidTransform2(Mirror Mirror, Angle Rotation, Vector2 Translation)
{
    /// <summary>The identity transform.</summary>
    public static RigidTransform2 Identity => default;

    /// <summary>A pure translation.</summary>
    public static RigidTransform2 Translate(Vector2 by) => new(Mirror.None, default, by);

    /// <summary>A rotation about a point (equation 2 of Wang 2021, with its printed signs and last term corrected).</summary>
    public static RigidTransform2 RotateAbout(Point2 center, Angle by)
    {
        var turned = new RigidTransform2(Mirror.None, by, Vector2.Zero).Apply(center);
        return new(Mirror.None, by, center - turned);
    }

    /// <summary>Transforms a point.</summary>
    public Point2 Apply(Point2 point) => Point2.Origin + Apply(point - Point2.Origin) + Translation;

    /// <summary>Transforms a displacement: reflects and rotates it, without translation.</summary>
    public Vector2 Apply(Vector2 vector)
    {
        var (x, y) = Mirror switch { Mirror.X => (-vector.X, vector.Y), Mirror.Y => (vector.X, -vector.Y), _ => (vector.X, vector.Y) };
        var (sin, cos) = Elementary.SinCos(Rotation.Radians);
        return new((x * cos) - (y * sin), (x * sin) + (y * cos));
    }

    /// <summary>The inverse transform.</summary>
    public RigidTransform2 Inverse()
    {
        // Reflection and rotation commute up to the sign of the angle, so the inverse has the same form.
        var rotation = Mirror == Mirror.None ? -Rotation : Rotation;
        var linear = new RigidTransform2(Mirror, rotation, Vector2.Zero);
        return linear with { Translation = -linear.Apply(Translation) };
    }
}
