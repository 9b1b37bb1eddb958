using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>An order of points with a short way across: to the nearest that is left, and to and fro over the curves, each improved by turning pieces around (2-opt) until nothing gets shorter; the shorter of the two.</summary>
internal static class MeasuringOrder
{
    /// <summary>Points up to which the nearest is looked for among all, and pieces of any length are turned.</summary>
    private const int Few = 3000;

    private const double LeastGainMm = 1e-9;

    /// <summary>Indexes into the points, in the order of measuring.</summary>
    /// <param name="points">Where each point is approached, seen from above.</param>
    /// <param name="curves">The number of each point's curve; points come curve by curve.</param>
    public static int[] Of(IReadOnlyList<Point2> points, IReadOnlyList<int> curves)
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

        Improve(points, fro);
        if (points.Count <= Few)
        {
            var near = Nearest(points);
            Improve(points, near);
            fro = Length(points, near) < Length(points, fro) ? near : fro;
        }

        // Both ways are as long: it begins at the end that comes first in the grid.
        return fro.Length == 0 || fro[0] <= fro[^1] ? fro : [.. fro.Reverse()];
    }

    /// <summary>Length of the way across.</summary>
    public static double Length(IReadOnlyList<Point2> points, IReadOnlyList<int> order)
    {
        var length = 0.0;
        for (var i = 1; i < order.Count; i++)
        {
            length += points[order[i - 1]].DistanceTo(points[order[i]]);
        }

        return length;
    }

    private static int[] Nearest(IReadOnlyList<Point2> points)
    {
        var (left, order) = (new List<int>(points.Count), new int[points.Count]);
        for (var i = 0; i < points.Count; i++)
        {
            left.Add(i);
        }

        for (var (k, at) = (0, 0); k < order.Length; k++)
        {
            order[k] = left[at];
            left.RemoveAt(at);
            at = 0;
            for (var i = 1; i < left.Count; i++)
            {
                at = points[order[k]].DistanceTo(points[left[i]]) < points[order[k]].DistanceTo(points[left[at]]) ? i : at;
            }
        }

        return order;
    }

    // The way is open: a piece at its end is turned at the cost of one joint.
    private static void Improve(IReadOnlyList<Point2> points, int[] order)
    {
        var reach = order.Length > Few ? 50 : order.Length;
        for (var shorter = true; shorter;)
        {
            shorter = false;
            for (var i = 0; i + 1 < order.Length; i++)
            {
                for (var k = i + 1; k < Math.Min(order.Length, i + reach); k++)
                {
                    var before = Between(i - 1, i) + Between(k, k + 1);
                    var behind = Between(i - 1, k) + Between(i, k + 1);
                    if (behind < before - LeastGainMm)
                    {
                        Array.Reverse(order, i, k - i + 1);
                        shorter = true;
                    }
                }
            }
        }

        double Between(int a, int b) => a < 0 || b >= order.Length ? 0 : points[order[a]].DistanceTo(points[order[b]]);
    }
}
