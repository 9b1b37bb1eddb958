using System.Globalization;
using System.Text;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;

namespace ErrorMatching.Jobs;

/// <summary>The order in which a probing program touches the key points of a mating job, and the number by which its log names
/// it.</summary>
internal static class TouchOrder
{
    /// <summary>The labels: in the order that the job states for logs without labels, else in that of the theoretical file.</summary>
    public static IReadOnlyList<string> Labels(MatingJob job, MeasurementFile theoretical)
    {
        if (job.Gauge.Order.Count > 0)
        {
            return job.Gauge.Order;
        }

        var needed = job.NeededPoints.ToHashSet(StringComparer.Ordinal);
        return [.. theoretical.Points.Select(p => p.Label).Where(needed.Contains)];
    }

    /// <summary>16 hexadecimal digits of the SHA-256 of the labels and their places as designed.</summary>
    public static string PlanOf(MatingJob job, MeasurementFile theoretical) => PlanOf(job, theoretical, "");

    /// <summary>The same for the counterpart, which is touched in the frame of its program.</summary>
    public static string PlanOfCounterpart(MatingJob job, MeasurementFile theoretical)
    {
        var frame = job.Counterpart.Frame;
        return PlanOf(
            job,
            theoretical,
            string.Create(
                CultureInfo.InvariantCulture,
                $"counterpart,{frame.Mirror},{frame.Rotation.Degrees:0.000000},{frame.Translation.X:0.000000},"
                    + $"{frame.Translation.Y:0.000000}\n"));
    }

    private static string PlanOf(MatingJob job, MeasurementFile theoretical, string head)
    {
        var text = new StringBuilder(head);
        foreach (var label in Labels(job, theoretical))
        {
            var at = theoretical[label].Position;
            text.Append(CultureInfo.InvariantCulture, $"{label},{at.X:0.000000},{at.Y:0.000000}\n");
        }

        return ContentHash.Sha256OfText(text.ToString())[..16].ToUpperInvariant();
    }
}
