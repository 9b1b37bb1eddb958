using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A point cloud of a surface with its stock, searchable by horizontal position.</summary>
internal sealed class SurfaceCloud
{
    /// <summary>Maximum number of points along each parameter.</summary>
    private const int Most = 500;

    private const int Fewest = 40;
    private readonly Dictionary<(int X, int Y), List<Point3>> _cells = [];
    private readonly double _cell;

    /// <summary>Samples the region with a step, unless that exceeds the maximum number.</summary>
    /// <param name="surface">The surface.</param>
    /// <param name="stockMm">Stock on the surface along its normal.</param>
    /// <param name="stepMm">Target distance between neighbors.</param>
    /// <param name="cellMm">Radius of queries.</param>
    public SurfaceCloud(PartSurface surface, double stockMm, double stepMm, double cellMm)
    {
        _cell = cellMm;
        var (knotsU, knotsV) = (surface.Spline.KnotsU, surface.Spline.KnotsV);
        var (countU, countV) = (Count(surface, alongU: true, stepMm), Count(surface, alongU: false, stepMm));
        for (var i = 0; i <= countU; i++)
        {
            var u = knotsU.Start + ((knotsU.End - knotsU.Start) * i / countU);
            var line = new RegionLine(surface.Region, alongU: false, u);
            for (var j = 0; j <= countV; j++)
            {
                var v = knotsV.Start + ((knotsV.End - knotsV.Start) * j / countV);
                if (line.IsInside(v))
                {
                    var at = surface.Spline.At(u, v);
                    Add(at.Position + (surface.NormalOf(at) * stockMm));
                }
            }
        }
    }

    public double Top { get; private set; } = double.NegativeInfinity;

    /// <summary>Points that may be within the radius of a vertical line.</summary>
    public IEnumerable<Point3> Near(double x, double y)
    {
        var (column, row) = Cell(x, y);
        for (var i = column - 1; i <= column + 1; i++)
        {
            for (var j = row - 1; j <= row + 1; j++)
            {
                foreach (var point in _cells.GetValueOrDefault((i, j)) ?? [])
                {
                    yield return point;
                }
            }
        }
    }

    private static int Count(PartSurface surface, bool alongU, double step)
    {
        var longest = 0.0;
        for (var line = 0; line <= 4; line++)
        {
            var (knots, across) = alongU ? (surface.Spline.KnotsU, surface.Spline.KnotsV) : (surface.Spline.KnotsV, surface.Spline.KnotsU);
            var curve = new IsoCurve(surface, alongU, across.Start + ((across.End - across.Start) * line / 4));
            var (length, before) = (0.0, curve.At(knots.Start).Position);
            for (var i = 1; i <= Fewest; i++)
            {
                var behind = curve.At(knots.Start + ((knots.End - knots.Start) * i / Fewest)).Position;
                length += (behind - before).Length;
                before = behind;
            }

            longest = Math.Max(longest, length);
        }

        return (int)Math.Clamp(Math.Ceiling(longest / step), Fewest, Most);
    }

    private void Add(Point3 point)
    {
        Top = Math.Max(Top, point.Z);
        var cell = Cell(point.X, point.Y);
        if (!_cells.TryGetValue(cell, out var list))
        {
            _cells.Add(cell, list = []);
        }

        list.Add(point);
    }

    private (int X, int Y) Cell(double x, double y) => ((int)Math.Floor(x / _cell), (int)Math.Floor(y / _cell));
}
