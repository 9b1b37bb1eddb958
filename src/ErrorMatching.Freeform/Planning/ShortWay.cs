using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Shortens an open path through points by 2-opt (reversing a piece) and or-opt (moving up to three points) until no single change
/// helps. For few points, it then swaps adjacent pieces repeatedly and tries both again, to escape local minima. The sequence of swaps is
/// fixed, so the same points always give the same path.</summary>
/// <remarks>Sources: Or, Traveling salesman-type combinatorial problems, Northwestern University 1976; Bentley, Fast algorithms for
/// geometric traveling salesman problems, ORSA Journal on Computing 4 (1992): only the nearest points are tried, and only where the path
/// has changed; Dueck and Scheuer, Threshold accepting, Journal of Computational Physics 90 (1990): the search continues from a slightly
/// longer path.</remarks>
internal sealed class ShortWay
{
    /// <summary>Number of neighbors that are tried for each point.</summary>
    private const int Nearest = 8;

    /// <summary>Maximum number of points that move together.</summary>
    private const int Moved = 3;

    /// <summary>Maximum length of swapped pieces.</summary>
    private const int Swapped = 10;

    /// <summary>Number of swaps per point.</summary>
    private const int Swaps = 10;

    /// <summary>How much longer than the shortest a path may be to continue from, as a share of its mean step.</summary>
    private const double Longer = 0.1;

    /// <summary>Maximum number of points for swaps. Larger paths are short, but seldom the shortest.</summary>
    private const int Few = 300;

    private const double LeastGainMm = 1e-9;

    private readonly Point2[] _points;
    private readonly int[] _near;
    private readonly int _nearOfEach;

    // A virtual point at distance zero from all others, with the last index, closes the path. So its ends need no special handling.
    private readonly int[] _tour;
    private readonly int[] _at;
    private readonly int[] _buffer;
    private readonly Stack<int> _changed = new();

    private ShortWay(Point2[] points, int[] order)
    {
        _points = points;
        _nearOfEach = Math.Min(Nearest, points.Length - 1);
        _near = NearestOf(points, _nearOfEach);
        _tour = [.. order, points.Length];
        (_at, _buffer) = (new int[_tour.Length], new int[_tour.Length]);
        Place();
    }

    /// <summary>Returns a shorter order, or the given one.</summary>
    public static int[] From(Point2[] points, int[] order)
    {
        if (order.Length < 3)
        {
            return order;
        }

        var way = new ShortWay(points, order);
        foreach (var point in order)
        {
            way._changed.Push(point);
        }

        way.Improve();
        if (order.Length <= Few)
        {
            way.Shake();
        }

        var end = way._at[points.Length];
        return [.. way._tour.AsSpan(end + 1), .. way._tour.AsSpan(0, end)];
    }

    // The neighbors of each point, nearest first, and of equally near ones the first. Sorted along x, the nearest are soon found.
    private static int[] NearestOf(Point2[] points, int count)
    {
        var (near, distances) = (new int[points.Length * count], new double[count]);
        var (x, sorted) = (Array.ConvertAll(points, p => p.X), new int[points.Length]);
        for (var k = 0; k < sorted.Length; k++)
        {
            sorted[k] = k;
        }

        Array.Sort(x, sorted);
        for (var at = 0; at < sorted.Length; at++)
        {
            var (i, found) = (sorted[at], 0);
            var mine = near.AsSpan(i * count, count);
            for (var k = at - 1; k >= 0 && IsNear(k); k--)
            {
                Take(sorted[k], mine);
            }

            for (var k = at + 1; k < sorted.Length && IsNear(k); k++)
            {
                Take(sorted[k], mine);
            }

            bool IsNear(int k) => found < count || Math.Abs(x[k] - x[at]) <= distances[^1];

            void Take(int other, Span<int> mine)
            {
                var distance = points[i].DistanceTo(points[other]);
                if (found == count && !IsBefore(distance, other, distances[^1], mine[^1]))
                {
                    return;
                }

                found = Math.Min(found + 1, count);
                var place = found - 1;
                for (; place > 0 && IsBefore(distance, other, distances[place - 1], mine[place - 1]); place--)
                {
                    (distances[place], mine[place]) = (distances[place - 1], mine[place - 1]);
                }

                (distances[place], mine[place]) = (distance, other);
            }
        }

        return near;

        static bool IsBefore(double distance, int point, double other, int its) => distance < other || (distance == other && point < its);
    }

    private double Length()
    {
        var length = 0.0;
        for (var i = 0; i < _tour.Length; i++)
        {
            length += Between(At(i), At(i + 1));
        }

        return length;
    }

    // Applies single changes while they help, at every point whose neighbors on the path have changed. Returns the reduction in length.
    private double Improve()
    {
        var gain = 0.0;
        while (_changed.TryPop(out var point))
        {
            if (point == _points.Length)
            {
                continue;
            }

            var better = Turn(point, 1);
            better = better > 0 ? better : Turn(point, -1);
            better = better > 0 ? better : Move(point, 1);
            better = better > 0 ? better : Move(point, -1);
            if (better > 0)
            {
                gain += better;
                _changed.Push(point);
            }
        }

        return gain;
    }

    // Swaps adjacent pieces, improves the result, and keeps the shortest path.
    private void Shake()
    {
        var (kept, shortest) = ((int[])_tour.Clone(), (int[])_tour.Clone());
        var (above, sequence) = (0.0, 1u);
        var allowed = Longer * Length() / _points.Length;
        for (var swaps = Swaps * _points.Length; swaps > 0; swaps--)
        {
            var (first, one, two) = (Next(_tour.Length), 1 + Next(Swapped), 1 + Next(Swapped));
            if (one + two + 2 > _tour.Length)
            {
                continue;
            }

            var longer = Swap(first, one, two);
            longer -= Improve();
            if (above + longer < allowed)
            {
                above += longer;
                _tour.CopyTo(kept, 0);
            }
            else
            {
                kept.CopyTo(_tour, 0);
                Place();
            }

            if (above < -LeastGainMm)
            {
                above = 0;
                kept.CopyTo(shortest, 0);
            }
        }

        shortest.CopyTo(_tour, 0);
        Place();

        // Linear congruential generator: Numerical Recipes, 3rd edition, section 7.1. Drops the low bits, which hardly change.
        int Next(int below) => (int)(((sequence = (1664525 * sequence) + 1013904223) >> 8) % (uint)below);
    }

    // Swaps two adjacent pieces of the given lengths after a position. Returns the increase in length.
    private double Swap(int first, int one, int two)
    {
        var (before, start, end) = (At(first), At(first + 1), At(first + one));
        var (next, last, behind) = (At(first + one + 1), At(first + one + two), At(first + one + two + 1));
        for (var k = 0; k < one + two; k++)
        {
            _buffer[k] = At(first + 1 + ((k + one) % (one + two)));
        }

        for (var k = 0; k < one + two; k++)
        {
            Put(_buffer[k], first + 1 + k);
        }

        Change(before, start, end);
        Change(next, last, behind);
        return Between(before, next) + Between(last, start)
            + Between(end, behind) - Between(before, start) - Between(end, next) - Between(last, behind);
    }

    // Joins a point with one that is nearer than its successor, and reverses the piece between them. Returns the reduction in length.
    private double Turn(int point, int forward)
    {
        var next = Step(point, forward);
        var leaves = Between(point, next);
        for (var k = -1; k < _nearOfEach; k++)
        {
            var other = NearOf(point, k);
            var joined = Between(point, other);
            if (joined >= leaves)
            {
                break;
            }

            var beyond = Step(other, forward);
            var gain = leaves + Between(other, beyond) - joined - Between(next, beyond);
            if (gain > LeastGainMm)
            {
                Reverse(_at[forward > 0 ? next : other], _at[forward > 0 ? other : next]);
                Change(point, next, other);
                _changed.Push(beyond);
                return gain;
            }
        }

        return 0;
    }

    // Moves points, starting with this one, so that the first is next to a near point. Returns the reduction in length.
    private double Move(int point, int forward)
    {
        var (before, last) = (Step(point, -forward), point);
        for (var count = 1; count <= Moved; count++)
        {
            var behind = Step(last, forward);
            if (last == _points.Length || behind == before)
            {
                break;
            }

            var leaves = Between(before, point) + Between(last, behind) - Between(before, behind);
            for (var k = -1; k < _nearOfEach; k++)
            {
                var other = NearOf(point, k);
                var joined = Between(point, other);
                if (joined >= leaves)
                {
                    break;
                }

                foreach (var side in (ReadOnlySpan<int>)[1, -1])
                {
                    var beyond = Step(other, side);
                    var gain = leaves + Between(other, beyond) - joined - Between(last, beyond);
                    if (gain > LeastGainMm && !IsAmong(other) && !IsAmong(beyond))
                    {
                        Insert(point, count, forward, other, beyond);
                        Change(before, behind, point);
                        Change(last, other, beyond);
                        return gain;
                    }
                }
            }

            last = behind;

            bool IsAmong(int other) => ((forward * (_at[other] - _at[point])) + _tour.Length) % _tour.Length < count;
        }

        return 0;
    }

    // Rewrites the path: the remaining points, starting after the moved ones, with these between their new neighbors.
    private void Insert(int point, int count, int forward, int other, int beyond)
    {
        var (length, from) = (0, forward > 0 ? _at[point] + count : _at[point] + 1);
        for (var k = 0; k < _tour.Length - count; k++)
        {
            var (here, next) = (At(from + k), At(from + k + 1));
            _buffer[length++] = here;
            for (var q = 0; q < count && ((here == other && next == beyond) || (here == beyond && next == other)); q++)
            {
                _buffer[length++] = At(_at[point] + (forward * (here == other ? q : count - 1 - q)));
            }
        }

        _buffer.CopyTo(_tour, 0);
        Place();
    }

    // Reverses from one position to another, across the end of the array if necessary; or the rest, which gives the same path.
    private void Reverse(int from, int to)
    {
        var count = ((to - from + _tour.Length) % _tour.Length) + 1;
        if (2 * count > _tour.Length)
        {
            (from, count) = (to + 1, _tour.Length - count);
        }

        for (var k = 0; k < count / 2; k++)
        {
            var (a, b) = (At(from + k), At(from + count - 1 - k));
            Put(b, from + k);
            Put(a, from + count - 1 - k);
        }
    }

    private void Place()
    {
        for (var i = 0; i < _tour.Length; i++)
        {
            _at[_tour[i]] = i;
        }
    }

    private void Put(int point, int place) => _tour[_at[point] = place % _tour.Length] = point;

    private void Change(int a, int b, int c)
    {
        _changed.Push(a);
        _changed.Push(b);
        _changed.Push(c);
    }

    // The virtual end is nearest to every point.
    private int NearOf(int point, int k) => k < 0 ? _points.Length : _near[(point * _nearOfEach) + k];

    private int At(int place) => _tour[(place + _tour.Length) % _tour.Length];

    private int Step(int point, int forward) => At(_at[point] + forward);

    private double Between(int a, int b) => a == _points.Length || b == _points.Length ? 0 : _points[a].DistanceTo(_points[b]);
}
