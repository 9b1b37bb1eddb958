using System.Text;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>Finds where a field on a net of places is above a level: closed rings with the level interpolated along the lines of the net.
/// </summary>
/// <remarks>Marching squares (W. E. Lorensen, H. E. Cline, "Marching Cubes", 1987, in the plane). The net has a margin of nodes that are
/// below every level, so that all rings are closed: at its edge they follow the net. A cell with two opposite corners above the level is
/// decided by the mean of its four.</remarks>
/// <param name="countU">Number of places along u.</param>
/// <param name="countV">Number of places along v.</param>
/// <param name="places">Their positions in pixels, v varying fastest.</param>
/// <param name="values">The values there.</param>
internal sealed class ContourRings(
    int countU, int countV, IReadOnlyList<(double X, double Y)> places, IReadOnlyList<double> values)
{
    // For each case of a cell, the pairs of sides that a ring enters and leaves by, with the corners above the level on its left. Corners
    // (bits 1, 2, 4, 8) and sides 0 to 3 go around: (0, 0), (1, 0), (1, 1), (0, 1).
    private static readonly (int In, int Out)[][] Sides =
    [
        [], [(0, 3)], [(1, 0)], [(1, 3)], [(2, 1)], [(0, 3), (2, 1)], [(2, 0)], [(2, 3)],
        [(3, 2)], [(0, 2)], [(1, 0), (3, 2)], [(1, 2)], [(3, 1)], [(0, 1)], [(3, 0)], [],
    ];

    // The two cases of opposite corners if the middle is above the level, too.
    private static readonly (int In, int Out)[] JoinedFirst = [(0, 1), (2, 3)], JoinedSecond = [(3, 0), (1, 2)];

    /// <summary>The rings around all places above a level, as the data of a path; empty if there are none.</summary>
    public string Above(double level)
    {
        var next = Segments(level);
        var data = new StringBuilder();
        for (var start = 0; start < next.Length; start++)
        {
            if (next[start] < 0)
            {
                continue;
            }

            var (place, last, count) = (start, "", 0);
            while (next[place] >= 0)
            {
                var (x, y) = Crossing(place, level);
                var point = SvgNumber.Point(x, y);
                if (point != last)
                {
                    data.Append(count++ == 0 ? 'M' : 'L').Append(point);
                }

                (last, next[place], place) = (point, -1, next[place]);
            }

            data.Append('Z');
        }

        return data.ToString();
    }

    // For each side of a cell that a ring crosses, the next side that it crosses; -1 for the others.
    private int[] Segments(double level)
    {
        var next = new int[2 * (countU + 2) * (countV + 2)];
        Array.Fill(next, -1);
        for (var i = -1; i < countU; i++)
        {
            for (var j = -1; j < countV; j++)
            {
                var corners = (IsAbove(i, j, level) ? 1 : 0) + (IsAbove(i + 1, j, level) ? 2 : 0)
                    + (IsAbove(i + 1, j + 1, level) ? 4 : 0) + (IsAbove(i, j + 1, level) ? 8 : 0);
                var sides = corners switch
                {
                    5 when IsMiddleAbove(i, j, level) => JoinedFirst,
                    10 when IsMiddleAbove(i, j, level) => JoinedSecond,
                    _ => Sides[corners],
                };
                foreach (var (into, outOf) in sides)
                {
                    next[SideOf(i, j, into)] = SideOf(i, j, outOf);
                }
            }
        }

        return next;
    }

    private bool IsInside(int i, int j) => i >= 0 && j >= 0 && i < countU && j < countV;

    private bool IsAbove(int i, int j, double level) => IsInside(i, j) && values[(i * countV) + j] >= level;

    private bool IsMiddleAbove(int i, int j, double level) => IsInside(i, j) && IsInside(i + 1, j + 1)
        && values[(i * countV) + j] + values[(i * countV) + j + 1] + values[((i + 1) * countV) + j] + values[((i + 1) * countV) + j + 1]
            >= 4 * level;

    // A side is named by its lower node, margin included, and its direction: even along u, odd along v.
    private int SideOf(int i, int j, int side) => side switch
    {
        0 => Name(i, j, 0),
        1 => Name(i + 1, j, 1),
        2 => Name(i, j + 1, 0),
        _ => Name(i, j, 1),
    };

    private int Name(int i, int j, int direction) => (2 * (((i + 1) * (countV + 2)) + j + 1)) + direction;

    private (double X, double Y) Crossing(int side, double level)
    {
        var (node, alongV) = (side / 2, side % 2);
        var (i, j) = ((node / (countV + 2)) - 1, (node % (countV + 2)) - 1);
        var (i2, j2) = alongV == 0 ? (i + 1, j) : (i, j + 1);
        if (!IsInside(i, j) || !IsInside(i2, j2))
        {
            return IsInside(i, j) ? places[(i * countV) + j] : places[(i2 * countV) + j2];
        }

        var (a, b) = ((i * countV) + j, (i2 * countV) + j2);
        var t = (level - values[a]) / (values[b] - values[a]);
        return (places[a].X + (t * (places[b].X - places[a].X)), places[a].Y + (t * (places[b].Y - places[a].Y)));
    }
}
