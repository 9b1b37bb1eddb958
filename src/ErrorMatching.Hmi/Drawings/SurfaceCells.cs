using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>A surface seen from above as quadrangles of one color each, and the border around them, in units of the drawing.</summary>
/// <remarks>Within a cell of the net, what has a part of the cell on either side in the same color is one quadrangle: lines of one parameter are straight there.</remarks>
public sealed class SurfaceCells
{
    /// <summary>Each cell of the net has so many by so many parts: colors change little from one to the next.</summary>
    public const int Parts = 3;

    private readonly SurfaceNet _net;
    private readonly bool[] _isOutside;
    private readonly List<(int Color, IReadOnlyList<Point2> Corners)> _quadrangles = [];
    private readonly List<(Point2 From, Point2 To)> _border = [];

    /// <summary>Divides a surface.</summary>
    /// <param name="net">The surface.</param>
    /// <param name="valuesMm">A value at each place of the net; null for none.</param>
    /// <param name="limitMm">The absolute value that has the last color, above zero.</param>
    public SurfaceCells(SurfaceNet net, IReadOnlyList<double>? valuesMm, double limitMm)
    {
        _net = net ?? throw new ArgumentNullException(nameof(net));
        _isOutside = new bool[(net.CountU - 1) * (net.CountV - 1)];
        foreach (var cell in net.Outside)
        {
            _isOutside[cell] = true;
        }

        for (var cell = 0; cell < _isOutside.Length; cell++)
        {
            if (!_isOutside[cell])
            {
                Divide(CornersOf(cell), valuesMm, limitMm);
                Bound(cell);
            }
        }
    }

    /// <summary>The quadrangles with the numbers of their colors; -1 where there are no values.</summary>
    public IReadOnlyList<(int Color, IReadOnlyList<Point2> Corners)> Quadrangles => _quadrangles;

    /// <summary>The border of the surface, piece by piece in no order.</summary>
    public IReadOnlyList<(Point2 From, Point2 To)> Border => _border;

    private static double Between(double a, double b, double c, double d, double s, double t) => (a * (1 - s) * (1 - t)) + (b * s * (1 - t)) + (c * s * t) + (d * (1 - s) * t);

    private int[] CornersOf(int cell)
    {
        var a = (cell / (_net.CountV - 1) * _net.CountV) + (cell % (_net.CountV - 1));
        return [a, a + _net.CountV, a + _net.CountV + 1, a + 1];
    }

    private Point2 Above(int place) => new(_net.Places[place].X, _net.Places[place].Y);

    private void Divide(int[] corners, IReadOnlyList<double>? values, double limitMm)
    {
        var (a, b, c, d) = (Above(corners[0]), Above(corners[1]), Above(corners[2]), Above(corners[3]));
        if (values is null)
        {
            _quadrangles.Add((-1, [a, b, c, d]));
            return;
        }

        Span<int> colors = stackalloc int[Parts * Parts];
        for (var part = 0; part < colors.Length; part++)
        {
            var (s, t) = (((part / Parts) + 0.5) / Parts, ((part % Parts) + 0.5) / Parts);
            colors[part] = DivergingColors.IndexOf(Between(values[corners[0]], values[corners[1]], values[corners[2]], values[corners[3]], s, t), limitMm);
        }

        // As far as the color goes along t, then as far as all of that goes along s.
        for (var part = 0; part < colors.Length; part++)
        {
            if (colors[part] is not (>= 0 and var color))
            {
                continue;
            }

            var (row, column) = (part / Parts, part % Parts);
            var (rows, columns) = (1, 1);
            while (column + columns < Parts && colors[part + columns] == color)
            {
                columns++;
            }

            while (row + rows < Parts && !colors.Slice(part + (rows * Parts), columns).ContainsAnyExcept(color))
            {
                rows++;
            }

            for (var taken = 0; taken < rows; taken++)
            {
                colors.Slice(part + (taken * Parts), columns).Fill(-1);
            }

            var (s1, s2, t1, t2) = ((double)row / Parts, (double)(row + rows) / Parts, (double)column / Parts, (double)(column + columns) / Parts);
            _quadrangles.Add((color, [At(s1, t1), At(s2, t1), At(s2, t2), At(s1, t2)]));
        }

        Point2 At(double s, double t) => new(Between(a.X, b.X, c.X, d.X, s, t), Between(a.Y, b.Y, c.Y, d.Y, s, t));
    }

    // Those sides of a cell beyond which there is none.
    private void Bound(int cell)
    {
        var (i, j, corners) = (cell / (_net.CountV - 1), cell % (_net.CountV - 1), CornersOf(cell));
        (int I, int J)[] neighbors = [(i, j - 1), (i + 1, j), (i, j + 1), (i - 1, j)];
        for (var side = 0; side < neighbors.Length; side++)
        {
            var (u, v) = neighbors[side];
            if (u < 0 || v < 0 || u >= _net.CountU - 1 || v >= _net.CountV - 1 || _isOutside[(u * (_net.CountV - 1)) + v])
            {
                _border.Add((Above(corners[side]), Above(corners[(side + 1) % corners.Length])));
            }
        }
    }
}
