using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>
/// A random contour of lines and arcs on the grid of 0.001 mm: corners of 45 to 110 degrees (or any) or smooth joints.
/// The same contour can be spelled in several ways.
/// </summary>
internal sealed class RandomContour
{
    private readonly List<(bool IsArc, bool CounterClockwise, Point2 Start, Point2 End, Point2 Center)> _elements = [];
    private ulong _state;

    public RandomContour(int seed, bool onlyLines = false, bool anyCorner = false)
    {
        _state = (ulong)seed * 0x9E3779B97F4A7C15UL;
        var (place, heading) = (new Point2(Grid(Uniform(-50, 50)), Grid(Uniform(-50, 50))), Uniform(-Math.PI, Math.PI));
        var count = 4 + (int)Uniform(0, 8);
        for (var i = 0; i < count; i++)
        {
            var turn = Uniform(0, 1) < 0.25
                ? 0
                : (anyCorner ? Uniform(1, 179) : Uniform(45, 110)) * Math.PI / 180 * (Uniform(0, 1) < 0.5 ? -1 : 1);
            var (start, direction) = (place, Vector2.FromDirection(Angle.FromRadians(heading + turn)));
            if (onlyLines || Uniform(0, 1) < 0.5)
            {
                place = Grid(start + (direction * Uniform(5, 20)));
                _elements.Add((false, false, start, place, default));
                heading = (place - start).Direction.Radians;
            }
            else
            {
                var left = Uniform(0, 1) < 0.5;
                var center = Grid(start + (direction.Left * (Uniform(4, 15) * (left ? 1 : -1))));
                var arc = new Arc2(
                    center, start.DistanceTo(center), (start - center).Direction, Angle.FromDegrees(Uniform(40, 150) * (left ? 1 : -1)));
                place = Grid(arc.End);
                _elements.Add((true, left, start, place, center));
                heading = arc.TangentAt(1).Direction.Radians;
            }
        }
    }

    public int Count => _elements.Count;

    /// <summary>The contour's blocks N1, N2 and so on, with a plunge before and a retract behind.</summary>
    public string Spell(bool incremental = false, string plane = "G17", bool byRadius = false)
    {
        var (x, y, z, i, j) = plane switch
        {
            "G18" => ('Z', 'X', 'Y', 'K', 'I'),
            "G19" => ('Y', 'Z', 'X', 'J', 'K'),
            _ => ('X', 'Y', 'Z', 'I', 'J')
        };
        var first = _elements[0].Start;
        var text = new StringBuilder();
        text.Append(
            CultureInfo.InvariantCulture,
            $"G21 G40 G90 {plane}\nG0 {x}{first.X:0.0##} {y}{first.Y:0.0##} {z}5.\nG1 {z}-1. F500.\n{(incremental ? "G91\n" : "")}");
        for (var n = 0; n < _elements.Count; n++)
        {
            var e = _elements[n];
            var to = incremental ? e.End - e.Start : e.End - Point2.Origin;
            text.Append(
                CultureInfo.InvariantCulture,
                $"N{n + 1} {(e.IsArc ? e.CounterClockwise ? "G3" : "G2" : "G1")} {x}{to.X:0.0##} {y}{to.Y:0.0##}");
            if (e.IsArc && byRadius)
            {
                text.Append(CultureInfo.InvariantCulture, $" R{e.Start.DistanceTo(e.Center):0.000}");
            }
            else if (e.IsArc)
            {
                text.Append(CultureInfo.InvariantCulture, $" {i}{e.Center.X - e.Start.X:0.0##} {j}{e.Center.Y - e.Start.Y:0.0##}");
            }

            text.Append('\n');
        }

        return text.Append(CultureInfo.InvariantCulture, $"G90 G0 {z}5.\n{x}0. {y}0.\nM30\n").ToString();
    }

    /// <summary>The same contour and blocks in Siemens spelling: ends as increments of their own,
    /// centers as places or radii by CR=.</summary>
    public string SpellSiemens(bool byRadius)
    {
        var first = _elements[0].Start;
        var text = new StringBuilder();
        text.Append(CultureInfo.InvariantCulture, $"G71 G40 G90 G17\nG0 X={first.X:0.0##} Y={first.Y:0.0##} Z5\nG1 Z-1 F500\n");
        for (var n = 0; n < _elements.Count; n++)
        {
            var (e, to) = (_elements[n], _elements[n].End - _elements[n].Start);
            text.Append(
                CultureInfo.InvariantCulture,
                $"N{n + 1} {(e.IsArc ? e.CounterClockwise ? "G3" : "G2" : "G1")} X=IC({to.X:0.0##}) Y=IC({to.Y:0.0##})");
            text.Append(!e.IsArc ? "" : byRadius
                ? string.Create(CultureInfo.InvariantCulture, $" CR={e.Start.DistanceTo(e.Center):0.000}")
                : string.Create(CultureInfo.InvariantCulture, $" I=AC({e.Center.X:0.0##}) J=AC({e.Center.Y:0.0##})"));
            text.Append('\n');
        }

        return text.Append("G0 Z5\nX0 Y0\nM30\n").ToString();
    }

    /// <summary>A number between two others; the same on every run.</summary>
    public double Uniform(double low, double high)
    {
        _state += 0x9E3779B97F4A7C15UL;
        var mixed = (_state ^ (_state >> 30)) * 0xBF58476D1CE4E5B9UL;
        mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EBUL;
        return low + ((high - low) * Math.ScaleB((mixed ^ (mixed >> 31)) >> 11, -53));
    }

    private static double Grid(double value) => Math.Round(value, 3);

    private static Point2 Grid(Point2 point) => new(Grid(point.X), Grid(point.Y));
}
