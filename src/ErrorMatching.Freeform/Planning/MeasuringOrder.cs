using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Orders points for a short path: alternately along the curves, then shortened by <see cref="ShortWay"/>.</summary>
internal static class MeasuringOrder
{
    /// <summary>Returns indices of the points, in the order of measuring.</summary>
    /// <param name="points">Where each point is approached, seen from above.</param>
    /// <param name="curves">The index of each point's curve. Points are sorted by curve.</param>
    public static int[] Find(IReadOnlyList<Point2> points, IReadOnlyList<int> curves)
    {
        var fro = new int[points.Count];
        for (var (start, curve) = (0, 0); start < fro.Length; curve++)
        {
            var end = start;
            for (; end < fro.Length && curves[end] == curves[start]; end++)
            {
                fro[end] = end;
            }

            if (curve % 2 > 0)
            {
                Array.Reverse(fro, start, end - start);
            }

            start = end;
        }

        var order = ShortWay.From([.. points], fro);

        // Both directions are equally long. The path starts at the end that comes first in the grid.
        return order.Length == 0 || order[0] <= order[^1] ? order : [.. order.Reverse()];
    }

    /// <summary>Length of the path seen from above.</summary>
    public static double Length(IReadOnlyList<Point2> points, IReadOnlyList<int> order)
    {
        var length = 0.0;
        for (var i = 1; i < order.Count; i++)
        {
            length += points[order[i - 1]].DistanceTo(points[order[i]]);
        }

        return length;
    }
}
