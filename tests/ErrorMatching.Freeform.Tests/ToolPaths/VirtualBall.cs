using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

/// <summary>What a ball cuts that goes along straight lines: nothing but spheres, laid densely along each.
/// Shares no code with the planner.</summary>
internal sealed class VirtualBall
{
    private const double Cell = 0.5;
    private const double Step = 0.02;
    private readonly Dictionary<(int, int), List<(Point3 From, Point3 To)>> _cells = [];
    private readonly double _radius;

    public VirtualBall(double radius, IEnumerable<ToolMove> moves)
    {
        _radius = radius;
        Point3? last = null;
        foreach (var move in moves)
        {
            if (last is { } from && !move.IsRapid)
            {
                Lay(from, move.Center);
            }

            last = move.Center;
        }
    }

    /// <summary>How high above a place, along a unit normal, the first sphere begins:
    /// the material that is left there, negative where it was cut deeper.</summary>
    public double Left(Point3 place, Vector3 normal)
    {
        var lowest = double.PositiveInfinity;
        var (x, y) = (place.X + (normal.X * _radius), place.Y + (normal.Y * _radius));
        for (var i = -2; i <= 2; i++)
        {
            for (var j = -2; j <= 2; j++)
            {
                if (!_cells.TryGetValue(((int)Math.Floor(x / Cell) + i, (int)Math.Floor(y / Cell) + j), out var segments))
                {
                    continue;
                }

                foreach (var (from, to) in segments)
                {
                    var count = (int)Math.Ceiling((to - from).Length / Step);
                    for (var k = 0; k <= count; k++)
                    {
                        lowest = Math.Min(lowest, Enter(place, normal, from + ((to - from) * (count == 0 ? 0 : (double)k / count))));
                    }
                }
            }
        }

        return lowest;
    }

    private double Enter(Point3 place, Vector3 normal, Point3 center)
    {
        var to = center - place;
        var along = to.Dot(normal);
        var inside = (_radius * _radius) - to.Dot(to) + (along * along);
        return inside < 0 ? double.PositiveInfinity : along - Math.Sqrt(inside);
    }

    // A long piece is laid into cells bit by bit.
    private void Lay(Point3 from, Point3 to)
    {
        var bits = Math.Max(1, (int)Math.Ceiling((to - from).Length / Cell));
        for (var i = 0; i < bits; i++)
        {
            var (a, b) = (from + ((to - from) * ((double)i / bits)), from + ((to - from) * ((i + 1.0) / bits)));
            var key = ((int)Math.Floor((a.X + b.X) / 2 / Cell), (int)Math.Floor((a.Y + b.Y) / 2 / Cell));
            if (!_cells.TryGetValue(key, out var list))
            {
                _cells[key] = list = [];
            }

            list.Add((a, b));
        }
    }
}
