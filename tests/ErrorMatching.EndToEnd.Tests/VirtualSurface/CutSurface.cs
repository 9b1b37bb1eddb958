namespace ErrorMatching.EndToEnd.Tests;

/// <summary>What a ball end mill leaves of a block that is large enough:
/// the envelope of its sphere along all feed moves, cusps included.</summary>
internal sealed class CutSurface
{
    // Fine enough that a ball between two places stands less than 0.02 um off.
    private const double Step = 0.02;

    // Moves are found by the cell of the plane in which they lie.
    private const double Cell = 1;

    private readonly Dictionary<(int, int), List<(Place From, Place To)>> _cells = [];
    private readonly double _radius;

    /// <summary>Cuts a program.</summary>
    /// <param name="moves">Moves of the ball's center.</param>
    /// <param name="radius">Radius of the ball in millimetres.</param>
    /// <param name="machine">Where the tool really goes.</param>
    public CutSurface(IEnumerable<AxisMove> moves, double radius, MachineError machine)
    {
        _radius = radius;
        foreach (var move in moves.Where(m => !m.IsRapid))
        {
            // Short parts, since the machine's error bends long moves.
            var parts = Math.Max(1, (int)Math.Ceiling((move.To - move.From).Length / 0.5));
            for (var i = 0; i < parts; i++)
            {
                Add(
                    machine.At(move.From + ((move.To - move.From) * ((double)i / parts))),
                    machine.At(move.From + ((move.To - move.From) * ((i + 1.0) / parts))));
            }
        }
    }

    /// <summary>Where the center of a stylus ball stops on its way into the material:
    /// the first place where the ball touches what is left.</summary>
    /// <param name="from">Where the move begins, outside of the material.</param>
    /// <param name="to">Where it ends; on the way the material is met nearly square.</param>
    /// <param name="stylusRadius">Radius of the stylus ball.</param>
    /// <returns>The center at the touch, or null if nothing is met.</returns>
    public Place? Touch(Place from, Place to, double stylusRadius)
    {
        const double reach = 0.4, grid = 0.1;
        var down = (to - from).Unit();
        var a = (Math.Abs(down.X) < 0.9 ? new Place(1, 0, 0) : new Place(0, 1, 0)).Cross(down).Unit();
        var b = down.Cross(a);
        var near = Near(from, to, down, a, b, reach + 0.3);
        if (near.Count == 0)
        {
            return null;
        }

        // Depths along the move from its beginning: the cut goes as deep as the deepest ball,
        // the stylus only as deep as the highest cusp lets it.
        var stop = double.MaxValue;
        for (var s = -reach; s < reach + (grid / 2); s += grid)
        {
            for (var t = -reach; t < reach + (grid / 2); t += grid)
            {
                if ((s * s) + (t * t) >= stylusRadius * stylusRadius)
                {
                    continue;
                }

                var cut = double.MinValue;
                foreach (var (p, q, depth) in near)
                {
                    var square = ((s - p) * (s - p)) + ((t - q) * (t - q));
                    if (square < _radius * _radius)
                    {
                        cut = Math.Max(cut, depth + Math.Sqrt((_radius * _radius) - square));
                    }
                }

                stop = Math.Min(stop, cut - Math.Sqrt((stylusRadius * stylusRadius) - (s * s) - (t * t)));
            }
        }

        return stop > (to - from).Length || stop == double.MinValue ? null : from + (down * stop);
    }

    private List<(double P, double Q, double Depth)> Near(Place from, Place to, Place down, Place a, Place b, double reach)
    {
        var list = new List<(double, double, double)>();
        var (minX, maxX) = (Math.Min(from.X, to.X) - reach, Math.Max(from.X, to.X) + reach);
        var (minY, maxY) = (Math.Min(from.Y, to.Y) - reach, Math.Max(from.Y, to.Y) + reach);
        for (var i = (int)Math.Floor(minX / Cell); i <= (int)Math.Floor(maxX / Cell); i++)
        {
            for (var j = (int)Math.Floor(minY / Cell); j <= (int)Math.Floor(maxY / Cell); j++)
            {
                foreach (var (p, q) in _cells.GetValueOrDefault((i, j)) ?? [])
                {
                    var steps = Math.Max(1, (int)Math.Ceiling((q - p).Length / Step));
                    for (var k = 0; k <= steps; k++)
                    {
                        var arm = p + ((q - p) * ((double)k / steps)) - from;
                        var (s, t) = (arm.Dot(a), arm.Dot(b));
                        if (Math.Abs(s) <= reach && Math.Abs(t) <= reach)
                        {
                            list.Add((s, t, arm.Dot(down)));
                        }
                    }
                }
            }
        }

        return list;
    }

    private void Add(Place p, Place q)
    {
        var cells = new HashSet<(int, int)>();
        for (var k = 0; k <= 2; k++)
        {
            var at = p + ((q - p) * (k / 2.0));
            cells.Add(((int)Math.Floor(at.X / Cell), (int)Math.Floor(at.Y / Cell)));
        }

        foreach (var cell in cells)
        {
            if (!_cells.TryGetValue(cell, out var list))
            {
                _cells[cell] = list = [];
            }

            list.Add((p, q));
        }
    }
}
