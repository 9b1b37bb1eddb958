using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>A surface seen from above as areas of one color each, and its border, in units of the drawing.</summary>
/// <remarks>A cell of the net whose corners share one color is one area. If the colors differ, the cell is cut where its values,
/// interpolated linearly along each side, change color; these lines continue in the next cell. A saddle, whose opposite corners
/// are higher than the others, is cut as four triangles around its center.</remarks>
public sealed class SurfaceCells
{
    private readonly SurfaceNet _net;
    private readonly bool[] _isOutside;
    private readonly List<(int Color, IReadOnlyList<Point2> Corners)> _pieces = [];
    private readonly List<(Point2 From, Point2 To)> _border = [];

    /// <summary>Divides a surface.</summary>
    /// <param name="net">The surface.</param>
    /// <param name="valuesMm">A value at each place of the net; null for none.</param>
    /// <param name="limitMm">The absolute value of the last color, above zero.</param>
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

    /// <summary>The areas with their color indexes; -1 if there are no values.</summary>
    public IReadOnlyList<(int Color, IReadOnlyList<Point2> Corners)> Pieces => _pieces;

    /// <summary>The segments of the surface's border, in no particular order.</summary>
    public IReadOnlyList<(Point2 From, Point2 To)> Border => _border;

    // Colors change at integers of this step, which DivergingColors rounds.
    private static double StepOf(double mm, double limitMm) => (((mm / limitMm) + 1) / 2 * (DivergingColors.Count - 1)) + 0.5;

    private static int ColorOf(double step) => (int)Math.Clamp(Math.Floor(step), 0, DivergingColors.Count - 1);

    // The part of a polygon on one side of the line where the step has a given value (I. Sutherland and G. Hodgman, "Reentrant
    // polygon clipping", 1974).
    private static List<(Point2 At, double Step)> Cut(IReadOnlyList<(Point2 At, double Step)> figure, double step, int side)
    {
        var kept = new List<(Point2 At, double Step)>();
        for (var i = 0; i < figure.Count; i++)
        {
            var (from, to) = (figure[i], figure[(i + 1) % figure.Count]);
            if (side * (from.Step - step) >= 0)
            {
                kept.Add(from);
            }

            if ((from.Step - step) * (to.Step - step) < 0)
            {
                kept.Add((from.At.Lerp(to.At, (step - from.Step) / (to.Step - from.Step)), step));
            }
        }

        return kept;
    }

    private int[] CornersOf(int cell)
    {
        var a = (cell / (_net.CountV - 1) * _net.CountV) + (cell % (_net.CountV - 1));
        return [a, a + _net.CountV, a + _net.CountV + 1, a + 1];
    }

    private Point2 Above(int place) => new(_net.Places[place].X, _net.Places[place].Y);

    private void Divide(int[] corners, IReadOnlyList<double>? values, double limitMm)
    {
        Point2[] at = [.. corners.Select(Above)];
        if (values is null)
        {
            _pieces.Add((-1, at));
            return;
        }

        double[] steps = [.. corners.Select(c => StepOf(values[c], limitMm))];
        if (steps.All(s => ColorOf(s) == ColorOf(steps[0])))
        {
            _pieces.Add((ColorOf(steps[0]), at));
            return;
        }

        if (!IsSaddle(steps))
        {
            Divide([.. at.Zip(steps)]);
            return;
        }

        var middle = (new Point2(at.Average(p => p.X), at.Average(p => p.Y)), steps.Average());
        for (var i = 0; i < at.Length; i++)
        {
            var next = (i + 1) % at.Length;
            Divide([(at[i], steps[i]), (at[next], steps[next]), middle]);
        }
    }

    // Both corners of one diagonal are above both of the other: a color can enter through all four sides.
    private static bool IsSaddle(double[] steps) =>
        Math.Min(steps[0], steps[2]) > Math.Max(steps[1], steps[3]) || Math.Min(steps[1], steps[3]) > Math.Max(steps[0], steps[2]);

    private void Divide((Point2 At, double Step)[] figure)
    {
        var (low, high) = (ColorOf(figure.Min(c => c.Step)), ColorOf(figure.Max(c => c.Step)));
        for (var color = low; color <= high; color++)
        {
            IReadOnlyList<(Point2 At, double Step)> piece = figure;
            piece = color > low ? Cut(piece, color, 1) : piece;
            piece = color < high ? Cut(piece, color + 1, -1) : piece;
            if (piece.Count > 2)
            {
                _pieces.Add((color, [.. piece.Select(c => c.At)]));
            }
        }
    }

    // The sides of a cell without a neighboring cell.
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
