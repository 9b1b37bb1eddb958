using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A tree of boxes over the sides of loops, for finding the sides near a place.</summary>
internal sealed class LoopSideTree
{
    /// <summary>Maximum number of sides that are tested one by one.</summary>
    private const int Few = 4;

    private readonly int[] _order;
    private readonly Box3[] _own;
    private readonly Box3[] _boxes;

    public LoopSideTree(IReadOnlyList<LoopSide> sides)
    {
        _own = [.. sides.Select(s => s.Box)];
        _order = [.. Enumerable.Range(0, sides.Count)];
        _boxes = new Box3[2 * sides.Count];
        if (sides.Count > 0)
        {
            Build(0, sides.Count);
        }
    }

    /// <summary>Number of sides tested so far.</summary>
    public long Looks { get; private set; }

    /// <summary>Finds the sides whose boxes are within a distance of a side's box along each axis, including the side itself.</summary>
    public void Near(int side, double distanceMm, List<int> found)
    {
        found.Clear();
        Collect(0, _order.Length, _own[side], distanceMm, found);
    }

    // The middle identifies a range, because the smallest ranges have two sides or are the whole.
    private static int Middle(int first, int count) => (2 * first) + count - 1;

    private void Build(int first, int count)
    {
        var all = _own[_order[first]];
        for (var i = first + 1; i < first + count; i++)
        {
            all = Around(all, _own[_order[i]]);
        }

        _boxes[Middle(first, count)] = all;
        if (count <= Few)
        {
            return;
        }

        var size = all.Max - all.Min;
        Func<Box3, double> center = size.X >= size.Y && size.X >= size.Z
            ? b => b.Min.X + b.Max.X
            : size.Y >= size.Z
            ? b => b.Min.Y + b.Max.Y
            : b => b.Min.Z + b.Max.Z;
        var keys = new double[count];
        for (var i = 0; i < count; i++)
        {
            keys[i] = center(_own[_order[first + i]]);
        }

        keys.AsSpan().Sort(_order.AsSpan(first, count));
        Build(first, count / 2);
        Build(first + (count / 2), count - (count / 2));
    }

    private void Collect(int first, int count, in Box3 box, double distanceMm, List<int> found)
    {
        if (!AreNear(_boxes[Middle(first, count)], box, distanceMm))
        {
            return;
        }

        if (count > Few)
        {
            Collect(first, count / 2, box, distanceMm, found);
            Collect(first + (count / 2), count - (count / 2), box, distanceMm, found);
            return;
        }

        Looks += count;
        for (var i = first; i < first + count; i++)
        {
            if (AreNear(_own[_order[i]], box, distanceMm))
            {
                found.Add(_order[i]);
            }
        }
    }

    private static bool AreNear(in Box3 a, in Box3 b, double mm) =>
        a.Min.X - b.Max.X <= mm
            && b.Min.X - a.Max.X <= mm
            && a.Min.Y - b.Max.Y <= mm
            && b.Min.Y - a.Max.Y <= mm
            && a.Min.Z - b.Max.Z <= mm
            && b.Min.Z - a.Max.Z <= mm;

    private static Box3 Around(Box3 a, Box3 b) => Box3.Around([a.Min, a.Max, b.Min, b.Max]);
}
