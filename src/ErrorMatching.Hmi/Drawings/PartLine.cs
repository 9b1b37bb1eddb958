using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>A feature in the drawing of a part.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Points">Its points, labels and places, mm or schematic.</param>
public sealed record PartLine(string Name, IReadOnlyList<(string Label, Point2 At)> Points)
{
    /// <summary>The place at a share of its length from its first point.</summary>
    /// <param name="share">From 0 for the first point to 1 for the last one.</param>
    /// <exception cref="InvalidOperationException">There are no points.</exception>
    public Point2 At(double share)
    {
        if (Points.Count == 0)
        {
            throw new InvalidOperationException("A line without points has no places.");
        }

        var left = share * Points.Zip(Points.Skip(1), (a, b) => a.At.DistanceTo(b.At)).Sum();
        for (var i = 1; i < Points.Count; i++)
        {
            var (from, to) = (Points[i - 1].At, Points[i].At);
            var length = from.DistanceTo(to);
            if (left <= length && length > 0)
            {
                return from.Lerp(to, left / length);
            }

            left -= length;
        }

        return Points[^1].At;
    }
}
