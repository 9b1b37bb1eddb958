using ErrorMatching.Geometry;

namespace ErrorMatching.Jobs;

/// <summary>Points of a file that determine no answer, such as a line through points that coincide.</summary>
/// <param name="file">The file as the user named it.</param>
/// <param name="why">What geometry says about the points.</param>
public sealed class PointsException(string file, GeometryException why) : Exception($"{file}: {(why ?? throw new ArgumentNullException(nameof(why))).Message}", why)
{
    /// <summary>The file as the user named it.</summary>
    public string File => file;

    /// <summary>What geometry says about the points.</summary>
    public GeometryException Why => why;
}
