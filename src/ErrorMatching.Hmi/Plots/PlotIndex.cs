using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>Finds the nearest of many points: a k-d tree (J. L. Bentley, Communications of the ACM 18, 1975, 509) in one array, the middle of each part in its middle.</summary>
/// <remarks>Made once for the data, beside the screen; used at any scale, also with one for each direction.</remarks>
public sealed class PlotIndex
{
    private readonly IReadOnlyList<Point2> _points;
    private readonly int[] _order;

    /// <summary>An index of some points. Those that are no finite numbers are never found.</summary>
    public PlotIndex(IReadOnlyList<Point2> points)
    {
        ArgumentNullException.ThrowIfNull(points);
        _points = points;
        _order = [.. Enumerable.Range(0, points.Count).Where(i => points[i].IsFinite)];
        Build(0, _order.Length, byX: true);
    }

    /// <summary>The number of the nearest point; of several that are as near, the first one. -1 if none is near enough.</summary>
    /// <param name="place">Where to look.</param>
    /// <param name="scaleX">How much a unit of the first coordinate counts.</param>
    /// <param name="scaleY">How much a unit of the second one counts.</param>
    /// <param name="reach">How far it may be, in what counts.</param>
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

        // The side where the place is first; the other one only if the border is near enough.
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

    // Hoare's selection: what is not greater before the middle, what is not less behind it.
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
