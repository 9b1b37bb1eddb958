using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>A measured point projected to the plane of its feature, with its height over that plane.</summary>
/// <param name="Label">Name of the point.</param>
/// <param name="Position">Its position in the plane, in the plane's axis order.</param>
/// <param name="HeightMm">Its coordinate along the plane's third axis; null if the file has no Z.</param>
internal readonly record struct ProjectedPoint(string Label, Point2 Position, double? HeightMm)
{
    /// <summary>Projects a point (Wang 2021, section 2.3: the three-dimensional problem is reduced to two dimensions).</summary>
    /// <param name="point">The point.</param>
    /// <param name="plane">The feature's plane.</param>
    /// <param name="file">File of the point, for messages.</param>
    /// <exception cref="InputException">The plane is not XY and the file has no Z
    /// (<see cref="MeasurementError.MissingCoordinate"/>).</exception>
    public static ProjectedPoint Of(LabelledPoint point, CoordinatePlane plane, string file)
    {
        if (!point.HasZ && plane != CoordinatePlane.XY)
        {
            throw MeasurementRefusal.Of(
                MeasurementError.MissingCoordinate,
                string.Create(CultureInfo.InvariantCulture, $"no Z of the point {point.Label}"),
                $"a Z coordinate, since its feature lies in the plane {plane}",
                file,
                point.Line);
        }

        return new(point.Label, plane.Project(point.Position), point.HasZ ? plane.Height(point.Position) : null);
    }

    /// <summary>Height of a measured point above the theoretical point; null if either has no height.</summary>
    public double? StandsOutMm(ProjectedPoint theoretical) => HeightMm - theoretical.HeightMm;
}
