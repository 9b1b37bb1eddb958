using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>What was measured at each point of a plan.</summary>
/// <param name="File">The file as the caller named it.</param>
/// <param name="Sha256">SHA-256 of the file's bytes as 64 lower-case hexadecimal digits.</param>
/// <param name="Points">Each point of the plan once, in the order of the plan.</param>
/// <param name="Warnings">What is strange and does no harm, in sentences.</param>
public sealed record MeasuredPoints(string File, string Sha256, IReadOnlyList<MeasuredPoint> Points, IReadOnlyList<string> Warnings)
{
    /// <summary>
    /// Of a log behind a program that follows a measurement: the SHA-256 of that measurement, or another word where it cannot be read any more; null where the file names none.
    /// </summary>
    public string? CutByMeasurement { get; init; }

    /// <summary>Where the ball touched the surface at a point of the plan.</summary>
    /// <param name="point">The number of the point, from 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">The plan has no such point.</exception>
    public Point3 this[int point] => point >= 1 && point <= Points.Count ? Points[point - 1].Contact : throw new ArgumentOutOfRangeException(nameof(point), point, "The plan has no such point.");

    /// <summary>Refuses files that hold the same measurement: it would count several times.</summary>
    /// <exception cref="FreeformException"><c>same-measurement</c>.</exception>
    internal static void ThrowIfTwice(IReadOnlyList<MeasuredPoints> files)
    {
        var first = new Dictionary<string, string>(StringComparer.Ordinal);
        foreach (var file in files)
        {
            if (!first.TryAdd(file.Sha256, file.File))
            {
                throw new FreeformException("same-measurement", file.File, $"its bytes are those of {first[file.Sha256]}: one measurement counts once. Give each measurement once.");
            }
        }
    }
}
