using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Peers.Tests;

/// <summary>
/// A closed ring of lines and arcs around the origin, convex and concave, in one of LinuxCNC's spellings. It begins with a lead-in block
/// and ends with a lead-out, so that all its named elements have displaced neighbors but for the two at the ends,
/// which run far enough to be cut by them.
/// </summary>
internal sealed class DisplacedContour
{
    private readonly List<(bool IsArc, bool CounterClockwise, Point2 Start, Point2 End, Point2 Center)> _elements = [];
    private readonly Random _random;
    private readonly double _unit;
    private readonly int _decimals;

    public DisplacedContour(int seed, bool inch)
    {
        _random = new Random(seed);
        (_unit, _decimals) = inch ? (25.4, 4) : (1, 3);
        var corners = 5 + _random.Next(5);
        var points = new List<Point2>();
        for (var i = 0; i < corners; i++)
        {
            var (angle, radius) = (i * 2 * Math.PI / corners, 30 + (12 * _random.NextDouble()));
            points.Add(Grid(new(radius * Math.Cos(angle), radius * Math.Sin(angle))));
        }

        for (var i = 0; i + 1 < corners; i++)
        {
            Add(points[i], points[i + 1]);
        }
    }

    public int Count => _elements.Count;

    /// <summary>The program; its elements are numbered N101, N102 and so on.</summary>
    public string Spell(bool incremental, bool byRadius, bool absoluteCenters)
    {
        var text = new StringBuilder();
        var first = _elements[0].Start;
        text.Append(
            CultureInfo.InvariantCulture,
            $"N1 {(_unit == 1 ? "G21" : "G20")} G17 G40 G90 {(absoluteCenters ? "G90.1" : "G91.1")} G94\nN2 G0 X{Number(first.X)} "
                + $"Y{Number(first.Y)} Z5\nN3 G1 Z-1 F100\n{(incremental ? "N4 G91\n" : "")}");
        for (var i = 0; i < _elements.Count; i++)
        {
            var e = _elements[i];
            var (x, y) = incremental ? (e.End.X - e.Start.X, e.End.Y - e.Start.Y) : (e.End.X, e.End.Y);
            text.Append(
                CultureInfo.InvariantCulture,
                $"N{101 + i} {(e.IsArc ? e.CounterClockwise ? "G3" : "G2" : "G1")} X{Number(x)} Y{Number(y)}");
            if (e.IsArc && byRadius)
            {
                text.Append(
                    CultureInfo.InvariantCulture, $" R{Number(Math.Ceiling(e.Start.DistanceTo(e.Center) / _unit * 1e4) / 1e4 * _unit)}");
            }
            else if (e.IsArc)
            {
                var (a, b) = absoluteCenters ? (e.Center.X, e.Center.Y) : (e.Center.X - e.Start.X, e.Center.Y - e.Start.Y);
                text.Append(CultureInfo.InvariantCulture, $" I{Number(a)} J{Number(b)}");
            }

            text.Append('\n');
        }

        return text.Append("N901 G90 G0 Z5\nN902 X0 Y0\nM2\n").ToString();
    }

    private void Add(Point2 start, Point2 end)
    {
        if (_random.Next(2) == 0)
        {
            _elements.Add((false, false, start, end, default));
            return;
        }

        // A flat arc over the chord: its center on the bisector, moved to the grid so that both radii agree.
        var chord = end - start;
        var left = _random.Next(2) == 0;
        var away = chord.Length * (0.7 + _random.NextDouble());
        var center = Grid(start.Lerp(end, 0.5) + (chord.Normalize().Left * (left ? away : -away)));
        _elements.Add((true, left, start, end, center));
    }

    // On the grid of the program's own unit.
    private Point2 Grid(Point2 p) => new(Math.Round(p.X / _unit, _decimals) * _unit, Math.Round(p.Y / _unit, _decimals) * _unit);

    private string Number(double mm) => ((mm / _unit) + 0.0).ToString(_unit == 1 ? "0.####" : "0.#####", CultureInfo.InvariantCulture);
}
