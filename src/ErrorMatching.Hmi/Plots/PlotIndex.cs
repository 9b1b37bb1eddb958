using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>Finds the nearest of many points with a k-d tree (J. L. Bentley, Communications of the ACM 18, 1975, 509). The tree
/// is one array; the root of each part is in its middle.</summary>
/// <remarks>Built once per data set, off the UI thread. It works at any scale, also with different scales for the two directions.</remarks>
public sealed class PlotIndex
{
    private readonly IReadOnlyList<Point2> _points;
    private readonly int[] _order;

    /// <summary>An index of points. Points that are not finite are never found.</summary>
    public PlotIndex(IReadOnlyList<Point2> points)
    {
        ArgumentNullException.ThrowIfNull(points);
        _points = points;
        _order = [.. Enumerable.Range(0, points.Count).Where(i => points[i].IsFinite)];
        Build(0, _order.Length, byX: true);
    }

    /// <summary>The index of the nearest point, or the first of several at the same distance; -1 if none is within reach.</summary>
    /// <param name="place">Where to look.</param>
    /// <param name="scaleX">Scale factor of the first coordinate.</param>
    /// <param name="scaleY">Scale factor of the second coordinate.</param>
    /// <param name="reach">Largest distance, scaled.</param>
    public int Nearest(Point2 place, double scaleX, double scaleY, double reach)
    {
        var found = (Index: -1, Square: reach * reach);
        Search(0, _order.Length, byX: true, place, scaleX, scaleY, ref found);
        return found.Index;
    }

    private void Search(int from, int to, bool byX, Point2 place, double scaleX, double scaleY, ref (int Index, double Square) found)
    {
        if (from >= to)
        {
            return;
        }

        var middle = (from + to) / 2;
        var index = _order[middle];
        var (x, y) = ((_points[index].X - place.X) * scaleX, (_points[index].Y - place.Y) * scaleY);
        var square = (x * x) + (y * y);
        if (square < found.Square || (square == found.Square && (found.Index < 0 || index < found.Index)))
        {
            found = (index, square);
        }

        // First the side that contains the place; the other side only if the border is near enough.
        var border = byX ? x : y;
        var (low, high) = ((From: from, To: middle), (From: middle + 1, To: to));
        var (near, far) = border > 0 ? (low, high) : (high, low);
        Search(near.From, near.To, !byX, place, scaleX, scaleY, ref found);
        if (border * border <= found.Square)
        {
            Search(far.From, far.To, !byX, place, scaleX, scaleY, ref found);
        }
    }

    private void Build(int from, int to, bool byX)
    {
        while (to - from > 1)
        {
            var middle = (from + to) / 2;
            Select(from, to - 1, middle, byX);
            Build(from, middle, !byX);
            (from, byX) = (middle + 1, !byX);
        }
    }

    // Hoare's selection: elements not greater go before the middle, elements not less go behind it.
    private void Select(int low, int high, int wanted, bool byX)
    {
        while (low < high)
        {
            var pivot = At(_order[(low + high) / 2], byX);
            var (i, j) = (low, high);
            while (i <= j)
            {
                while (At(_order[i], byX) < pivot)
                {
                    i++;
                }

                while (At(_order[j], byX) > pivot)
                {
                    j--;
                }

                if (i <= j)
                {
                    (_order[i], _order[j]) = (_order[j], _order[i]);
                    (i, j) = (i + 1, j - 1);
                }
            }

            if (wanted <= j)
            {
                high = j;
            }
            else if (wanted >= i)
            {
                low = i;
            }
            else
            {
                return;
            }
        }
    }

    private double At(int index, bool byX) => byX ? _points[index].X : _points[index].Y;
}
