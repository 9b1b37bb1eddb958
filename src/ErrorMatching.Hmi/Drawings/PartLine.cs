using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>A feature in the drawing of a part.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Points">Its points: labels, and positions in mm or schematic.</param>
/// <param name="Outline">The line through them. A triangle's line passes through its apex, which is not measured.</param>
internal sealed record PartLine(string Name, IReadOnlyList<(string Label, Point2 At)> Points, IReadOnlyList<Point2> Outline)
{
    /// <summary>The position at a share of its length from its first point.</summary>
    /// <param name="share">From 0 for the first point to 1 for the last one.</param>
    /// <exception cref="InvalidOperationException">There are no points.</exception>
    public Point2 At(double share)
    {
        if (Outline.Count == 0)
        {
            throw new InvalidOperationException("A line without points has no places.");
        }

        var left = share * Outline.Zip(Outline.Skip(1), (a, b) => a.DistanceTo(b)).Sum();
        for (var i = 1; i < Outline.Count; i++)
        {
            var (from, to) = (Outline[i - 1], Outline[i]);
            var length = from.DistanceTo(to);
            if (left <= length && length > 0)
            {
                return from.Lerp(to, left / length);
            }

            left -= length;
        }

        return Outline[^1];
    }
}
