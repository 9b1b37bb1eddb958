namespace ErrorMatching.Freeform;

/// <summary>A dimension or a geometric tolerance of a STEP file (AP242, ISO 10303-47): not as it is drawn, but as it is meant.</summary>
/// <param name="Number">The number of its instance.</param>
/// <param name="Line">The line in the file on which it begins.</param>
/// <param name="Entity">What it is in the file: <c>#26 SURFACE_PROFILE_TOLERANCE</c>.</param>
/// <param name="Name">Its name; empty if the file has none for it.</param>
/// <param name="Kind"><see cref="Size"/>, <see cref="Location"/>, <see cref="Angle"/>, or the kind of tolerance by its entity:
/// <c>surface-profile</c>, <c>position</c>, <c>flatness</c>; <c>tolerance</c> if it says none.</param>
public sealed record ModelAnnotation(long Number, int Line, string Entity, string Name, string Kind)
{
    /// <summary>The kind of a dimension of one feature, such as a diameter.</summary>
    public const string Size = "size";

    /// <summary>The kind of a distance between two features.</summary>
    public const string Location = "location";

    /// <summary>The kind of a dimension that is an angle.</summary>
    public const string Angle = "angle";

    /// <summary>True for a dimension, false for a geometric tolerance.</summary>
    public bool IsDimension => Kind is Size or Location or Angle;

    /// <summary>Of a dimension what it is of, as the file says: <c>diameter</c>.</summary>
    public string Quantity { get; init; } = "";

    /// <summary>The nominal value of a dimension, or the width of a tolerance's zone, mm (of an angle: degrees); null if not
    /// read.</summary>
    public double? Value { get; init; }

    /// <summary>The limits of a dimension as deviations from <see cref="Value"/>, in its unit; null if the file states none.</summary>
    public (double Lower, double Upper)? Limits { get; init; }

    /// <summary>The fit by which a dimension is limited instead, such as <c>H7</c>; empty if it is not.</summary>
    public string Fit { get; init; } = "";

    /// <summary>How an unequally disposed zone is displaced, mm; null if the zone is disposed equally.</summary>
    public double? DisplacementMm { get; init; }

    /// <summary>Its datums in order, such as <c>A</c>, <c>B</c>.</summary>
    public IReadOnlyList<string> Datums { get; init; } = [];

    /// <summary>Its modifiers as the file spells them, and zones of an unusual form: <c>MAXIMUM_MATERIAL_REQUIREMENT</c>.</summary>
    public IReadOnlyList<string> Modifiers { get; init; } = [];

    /// <summary>True for the lower segment of a composite tolerance, which refines the upper one.</summary>
    public bool IsLowerSegment { get; init; }

    /// <summary>True if it is of the whole part.</summary>
    public bool IsAllOver { get; init; }

    /// <summary>The numbers of the faces that it is of, in the order of the file.</summary>
    public IReadOnlyList<long> Faces { get; init; } = [];

    /// <summary>What else it is of: edges, center planes, meshes.</summary>
    public IReadOnlyList<string> Others { get; init; } = [];

    /// <summary>Millimeters in the unit of its lengths; null if it has none.</summary>
    public double? UnitMm { get; init; }

    /// <summary>Why it is not understood, with instance and line; null if it is.</summary>
    public string? Problem { get; init; }
}

/// <summary>The standard by which a model's tolerances are to be read, as far as the file names one.</summary>
public enum ToleranceStandard
{
    /// <summary>It names none, or both.</summary>
    Unknown,

    /// <summary>ASME Y14.5.</summary>
    Asme,

    /// <summary>ISO 1101.</summary>
    Iso,
}

/// <summary>A face beside a flat one, at one of its edges.</summary>
/// <param name="Number">The number of its instance.</param>
/// <param name="Surface">The name of its surface in STEP.</param>
public sealed record WallFace(long Number, string Surface)
{
    private const double MaxTilt = 1e-5;

    /// <summary>The normal of a plane, the axis of a cylinder, or the direction of an extrusion; null for other surfaces.</summary>
    public Geometry.Vector3? Axis { get; init; }

    /// <summary>A point of the plane or of the cylinder's axis, mm.</summary>
    public Geometry.Point3 Origin { get; init; }

    /// <summary>True if it is a face of a solid, so that the file says on which side the material is.</summary>
    public bool IsOfSolid { get; init; }

    /// <summary>True if the face's normal is that of its surface.</summary>
    public bool IsAlongSurface { get; init; }

    /// <summary>True if it is parallel to a direction everywhere; false also if that is not known.</summary>
    /// <param name="direction">A unit vector.</param>
    public bool IsParallelTo(Geometry.Vector3 direction) => Axis is { } axis
        && (Surface == "PLANE" ? Math.Abs(axis.Dot(direction)) : axis.Cross(direction).Length) <= MaxTilt;

    /// <summary>The direction out of the material at a point of it, not of length 1; null if the file does not say it.</summary>
    /// <param name="at">The point, mm.</param>
    public Geometry.Vector3? OutwardAt(Geometry.Point3 at)
    {
        if (!IsOfSolid || Axis is not { } axis || Surface is not ("PLANE" or "CYLINDRICAL_SURFACE"))
        {
            return null;
        }

        var from = at - Origin;
        var normal = Surface == "PLANE" ? axis : from - (axis * from.Dot(axis));
        return IsAlongSurface ? normal : normal * -1;
    }
}
