using ErrorMatching.Freeform;
using ErrorMatching.Geometry;

namespace ErrorMatching.Jobs;

/// <summary>Along which axis a model is looked at, so that the faces perpendicular to it are drawings.</summary>
/// <param name="Axis">The axis: <c>Z</c>.</param>
/// <param name="Right">The axis of the model that becomes X of the drawing.</param>
/// <param name="Up">The axis of the model that becomes Y of the drawing.</param>
internal sealed record ModelView(string Axis, string Right, string Up)
{
    // The sine of the largest angle between a face's normal and the axis. It shortens a meter by 0.05 nm.
    private const double MaxTilt = 1e-5;

    /// <summary>The view from above.</summary>
    public static ModelView AlongZ { get; } = new("Z", "X", "Y");

    /// <summary>The views from the side. As from above, the axis points to the viewer.</summary>
    public static IReadOnlyList<ModelView> FromSide { get; } = [new("X", "Y", "Z"), new("Y", "Z", "X")];

    /// <summary>True if a plane is perpendicular to the axis.</summary>
    /// <param name="normal">Its unit normal.</param>
    public bool Sees(Vector3 normal) => Of(normal).Length <= MaxTilt;

    /// <summary>The place of a point in the drawing.</summary>
    public Point2 Of(Point3 p) => Point2.Origin + Of(p - default(Point3));

    /// <summary>A displacement in the drawing.</summary>
    public Vector2 Of(Vector3 v) => new(Along(v, Right), Along(v, Up));

    /// <summary>How far along the axis a point is, mm.</summary>
    public double HeightOf(Point3 p) => Along(p - default(Point3), Axis);

    /// <summary>The point of the model at a place of the drawing.</summary>
    /// <param name="p">The place.</param>
    /// <param name="heightMm">How far along the axis it is.</param>
    public Point3 At(Point2 p, double heightMm) => Axis switch
    {
        "X" => new(heightMm, p.X, p.Y),
        "Y" => new(p.Y, heightMm, p.X),
        _ => new(p.X, p.Y, heightMm),
    };

    /// <summary>True if a face is perpendicular to the drawing.</summary>
    public bool IsUpright(WallFace face) => face.IsParallelTo(
        new(Axis == "X" ? 1 : 0, Axis == "Y" ? 1 : 0, Axis is "X" or "Y" ? 0 : 1));

    private static double Along(Vector3 v, string axis) => axis switch
    {
        "X" => v.X,
        "Y" => v.Y,
        _ => v.Z,
    };
}
