namespace ErrorMatching.Geometry;

/// <summary>Converts points between space and a coordinate plane.</summary>
public static class CoordinatePlaneExtensions
{
    /// <summary>The point's two coordinates in the plane, in the plane's axis order.</summary>
    public static Point2 Project(this CoordinatePlane plane, Point3 point) => plane switch
    {
        CoordinatePlane.ZX => new(point.Z, point.X),
        CoordinatePlane.YZ => new(point.Y, point.Z),
        _ => new(point.X, point.Y),
    };

    /// <summary>The point's coordinate along the plane's third axis.</summary>
    public static double Height(this CoordinatePlane plane, Point3 point) => plane switch
    {
        CoordinatePlane.ZX => point.Y,
        CoordinatePlane.YZ => point.X,
        _ => point.Z,
    };

    /// <summary>The point in space with given coordinates in the plane and along its third axis.</summary>
    public static Point3 Lift(this CoordinatePlane plane, Point2 point, double height) => plane switch
    {
        CoordinatePlane.ZX => new(point.Y, height, point.X),
        CoordinatePlane.YZ => new(height, point.X, point.Y),
        _ => new(point.X, point.Y, height),
    };
}
