using ErrorMatching.Geometry;

namespace ErrorMatching.Jobs;

/// <summary>The points of a file determine no solution, such as a line through coincident points.</summary>
/// <param name="file">The file as the user named it.</param>
/// <param name="why">The geometry error.</param>
public sealed class PointsException(string file, GeometryException why)
    : Exception($"{file}: {(why ?? throw new ArgumentNullException(nameof(why))).Message}", why)
{
    /// <summary>The file as the user named it.</summary>
    public string File => file;

    /// <summary>The geometry error.</summary>
    public GeometryException Why => why;
}
