using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>A random polygon on the grid of 0.001 mm, open or closed. Its corners are sharp, rounded by an arc that touches both sides,
/// or reached by a piece so short that a displacement may make it vanish.</summary>
internal sealed class RoundedPolygon
{
    private readonly StringBuilder _text = new("G21 G40 G90 G17\n");

    public RoundedPolygon(int seed)
    {
        var random = new RandomContour(seed);
        var (corners, turn, side) = (3 + (int)random.Uniform(0, 5), random.Uniform(0, 2 * Math.PI), seed % 2 == 0 ? 1 : -1);
        var places = Enumerable.Range(0, corners)
            .Select(i => Point2.Origin
                + (Vector2.FromDirection(Angle.FromRadians(turn + (side * i * 2 * Math.PI / corners))) * random.Uniform(25, 35)))
            .ToArray();
        var middle = Grid(places[0].Lerp(places[^1], 0.5));
        _text.Append(CultureInfo.InvariantCulture, $"G0 X{middle.X:0.0##} Y{middle.Y:0.0##} Z5.\nG1 Z-1. F500.\n");
        for (var i = 0; i < corners; i++)
        {
            var (before, corner, behind) = (i == 0 ? middle : places[i - 1], places[i], places[(i + 1) % corners]);
            var (into, outOf) = ((corner - before).Normalize(), (behind - corner).Normalize());
            var sort = random.Uniform(0, 1);
            if (sort < 0.3)
            {
                Line(corner);
            }
            else if (sort < 0.4)
            {
                Line(corner - (into * 0.05));
                Line(corner);
            }
            else
            {
                var radius = random.Uniform(1, 3);
                var length = radius * Math.Abs(into.Cross(outOf)) / (1 + into.Dot(outOf));
                var (from, to) = (Grid(corner - (into * length)), Grid(corner + (outOf * length)));
                var center = Grid(corner - (into * length) + (into.Left * (radius * side)));
                Line(from);
                IsArc.Add(true);
                var by = center - from;
                _text.Append(
                    CultureInfo.InvariantCulture,
                    $"N{IsArc.Count} {(side > 0 ? "G3" : "G2")} X{to.X:0.0##} Y{to.Y:0.0##} I{by.X:0.0##} J{by.Y:0.0##}\n");
            }
        }

        Line(middle);
        _text.Append("G0 Z5.\nX0. Y0.\nM30\n");
    }

    /// <summary>Whether the blocks N1, N2 and so on are arcs.</summary>
    public List<bool> IsArc { get; } = [];

    public string Text => _text.ToString();

    private void Line(Point2 to)
    {
        var place = Grid(to);
        IsArc.Add(false);
        _text.Append(CultureInfo.InvariantCulture, $"N{IsArc.Count} G1 X{place.X:0.0##} Y{place.Y:0.0##}\n");
    }

    private static Point2 Grid(Point2 point) => new(Math.Round(point.X, 3), Math.Round(point.Y, 3));
}
