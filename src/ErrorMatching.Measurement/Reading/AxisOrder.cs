using ErrorMatching.Geometry;

namespace ErrorMatching.Measurement;

/// <summary>Another way to read the coordinates of a file: columns exchanged, or axes reversed.</summary>
public sealed class AxisOrder
{
    private static readonly string[] Letters = ["x", "y", "z"];

    private AxisOrder(string name, Func<Point3, Point3> apply) => (Name, Apply) = (name, apply);

    /// <summary>What stands for the axes, in their order: <c>y, x</c>, <c>-x, y</c>, <c>x, z, y</c>.</summary>
    public string Name { get; }

    /// <summary>Reads a point so.</summary>
    public Func<Point3, Point3> Apply { get; }

    /// <summary>The ways to read X and Y, but for the usual one: the exchange first, then reversed axes.</summary>
    public static IReadOnlyList<AxisOrder> InPlane { get; } = Make([[1, 0, 2], [0, 1, 2]], axes: 2);

    /// <summary>The ways to read X, Y and Z, but for the usual one: exchanges first, then reversed axes.</summary>
    public static IReadOnlyList<AxisOrder> InSpace { get; } =
        Make([[1, 0, 2], [0, 2, 1], [2, 1, 0], [1, 2, 0], [2, 0, 1], [0, 1, 2]], axes: 3);

    /// <summary>The first way in which points lie where they are expected, while they do not as they were read; null if there is
    /// none.</summary>
    /// <param name="orders">The ways, simplest first.</param>
    /// <param name="read">The points as read.</param>
    /// <param name="expected">Where they are expected.</param>
    /// <param name="limitMm">The largest distance that is still expected.</param>
    public static AxisOrder? Fitting(
        IReadOnlyList<AxisOrder> orders, IReadOnlyList<Point3> read, IReadOnlyList<Point3> expected, double limitMm)
    {
        ArgumentNullException.ThrowIfNull(orders);
        ArgumentNullException.ThrowIfNull(read);
        ArgumentNullException.ThrowIfNull(expected);
        return read.Count < 2 || AreNear(p => p) ? null : orders.FirstOrDefault(o => AreNear(o.Apply));

        bool AreNear(Func<Point3, Point3> way)
        {
            for (var i = 0; i < read.Count; i++)
            {
                if (!((way(read[i]) - expected[i]).Length <= limitMm))
                {
                    return false;
                }
            }

            return true;
        }
    }

    // Few reversed axes first, exchanges before the usual order.
    private static List<AxisOrder> Make(int[][] orders, int axes)
    {
        var made = new List<(int Reversed, AxisOrder Order)>();
        foreach (var order in orders)
        {
            for (var signs = 0; signs < 1 << axes; signs++)
            {
                if (signs == 0 && order is [0, 1, 2])
                {
                    continue;
                }

                double[] by = [.. Enumerable.Range(0, 3).Select(a => (signs & (1 << a)) == 0 ? 1.0 : -1)];
                made.Add((System.Numerics.BitOperations.PopCount((uint)signs), new AxisOrder(
                    string.Join(", ", Enumerable.Range(0, axes).Select(a => (by[a] < 0 ? "-" : "") + Letters[order[a]])),
                    p =>
                    {
                        double[] from = [p.X, p.Y, p.Z];
                        return new(by[0] * from[order[0]], by[1] * from[order[1]], by[2] * from[order[2]]);
                    })));
            }
        }

        return [.. made.OrderBy(m => m.Reversed).Select(m => m.Order)];
    }
}
