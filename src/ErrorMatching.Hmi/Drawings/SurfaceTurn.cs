using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>How a surface is turned for an orthographic view: lengths in the plane of the screen are kept.</summary>
/// <param name="YawDegrees">Turn about z, counterclockwise seen from above.</param>
/// <param name="PitchDegrees">Height of the eye: 0 looks along y, 90 from above.</param>
public readonly record struct SurfaceTurn(double YawDegrees, double PitchDegrees)
{
    private const int Whole = 360, Steepest = 90, FirstYaw = -30, FirstPitch = 35;

    /// <summary>The turn in which a surface is shown first.</summary>
    public static SurfaceTurn Default => new(FirstYaw, FirstPitch);

    /// <summary>The turn after turning further. The eye stays above the surface.</summary>
    public SurfaceTurn By(double yawDegrees, double pitchDegrees) => new(
        Math.IEEERemainder(YawDegrees + yawDegrees, Whole), Math.Clamp(PitchDegrees + pitchDegrees, 0, Steepest));

    /// <summary>Where a place is on the screen, y up, and how near it is to the eye.</summary>
    /// <param name="place">The place, from the middle of the turn.</param>
    public (Point2 At, double Nearness) Project(Vector3 place)
    {
        var (yaw, pitch) = (Radians(YawDegrees), Radians(PitchDegrees));
        var (sin, cos) = (Elementary.Sin(yaw), Elementary.Cos(yaw));
        var (x, y) = ((place.X * cos) - (place.Y * sin), (place.X * sin) + (place.Y * cos));
        (sin, cos) = (Elementary.Sin(pitch), Elementary.Cos(pitch));
        return (new(x, (y * sin) + (place.Z * cos)), (place.Z * sin) - (y * cos));
    }

    private static double Radians(double degrees) => degrees * Math.PI * 2 / Whole;
}
