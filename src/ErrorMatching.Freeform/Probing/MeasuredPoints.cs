using ErrorMatching.Geometry;
using ErrorMatching.Json;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>The measured points of a plan.</summary>
/// <param name="File">The file name, as given by the caller.</param>
/// <param name="Sha256">SHA-256 of the file's bytes as 64 lowercase hexadecimal digits.</param>
/// <param name="Points">Each point of the plan once, in the order of the plan.</param>
/// <param name="Warnings">Harmless irregularities, in sentences.</param>
public sealed record MeasuredPoints(string File, string Sha256, IReadOnlyList<MeasuredPoint> Points, IReadOnlyList<ReportWarning> Warnings)
{
    /// <summary>The SHA-256 of the measurement that the cutting program followed, or another word if it cannot be read; null if the log
    /// names none.</summary>
    public string? CutByMeasurement { get; init; }

    /// <summary>The measured contact of a planned point.</summary>
    /// <param name="point">The number of the point, from 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">The plan has no such point.</exception>
    public Point3 this[int point] =>
        point >= 1 && point <= Points.Count
            ? Points[point - 1].Contact
            : throw new ArgumentOutOfRangeException(nameof(point), point, "The plan has no such point.");

    /// <summary>SHA-256 of a measurement: that of its file, or of the sorted ones of several files, which count as one.</summary>
    public static string Sha256Of(IReadOnlyList<MeasuredPoints> measured)
    {
        ArgumentNullException.ThrowIfNull(measured);
        return measured is [var only]
            ? only.Sha256
            : ContentHash.Sha256OfText(string.Concat(measured.Select(m => m.Sha256).Order(StringComparer.Ordinal)));
    }

    /// <summary>Throws if files contain the same measurement, which would count several times.</summary>
    /// <exception cref="InputException"><c>same-measurement</c>.</exception>
    internal static void ThrowIfTwice(IReadOnlyList<MeasuredPoints> files)
    {
        var first = new Dictionary<string, string>(StringComparer.Ordinal);
        foreach (var file in files)
        {
            if (!first.TryAdd(file.Sha256, file.File))
            {
                throw InputException.At(
                    "same-measurement",
                    file.File,
                    $"its bytes are those of {first[file.Sha256]}: one measurement counts once. Give each measurement once.");
            }
        }
    }
}

/// <summary>A planned point with its measurement.</summary>
/// <param name="Planned">The planned point.</param>
/// <param name="Contact">Where the ball touched the surface, in millimeters.</param>
/// <param name="Line">Line of the file.</param>
public sealed record MeasuredPoint(PlanPoint Planned, Point3 Contact, int Line);
