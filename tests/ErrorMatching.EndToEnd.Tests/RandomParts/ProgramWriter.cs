using System.Globalization;
using System.Text;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>Writes moves as an NC program with coordinates in micrometers, rounded once, so that G91 sums are exact.</summary>
internal sealed class ProgramWriter(bool radiusArcs)
{
    private readonly StringBuilder _text = new();
    private int _number;
    private int _motion = -1;
    private (long U, long V) _at;

    public bool Incremental { get; set; }

    public string Text => _text.ToString();

    /// <summary>The number of the block written last.</summary>
    public string Block => $"N{_number}";

    public void Raw(string line) => _text.Append(line).Append('\n');

    public void Words(string words)
    {
        _number += 10;
        Raw($"N{_number} {words}");
    }

    /// <summary>Down to the depth of the cut, the last word of motion before the contour.</summary>
    public void Plunge()
    {
        Words($"{Motion(1)} Z-2. F200.");
    }

    /// <summary>A straight move, with words before it such as G42 D1.</summary>
    public void Line(Flat to, int motion = 1, string before = "", string after = "")
    {
        var target = Round(to);
        var words = new List<string> { before, Motion(motion), Coordinate('X', target.U, _at.U), Coordinate('Y', target.V, _at.V), after };
        _at = target;
        Words(string.Join(' ', words.Where(w => w.Length > 0)));
    }

    public void Arc(PathMove move)
    {
        var target = Round(move.To);
        var exact = move.Center!.Value;
        var inWords = radiusArcs && Math.Abs(move.Sweep) is > 0.35 and < 2.6;
        var radius = (exact - move.To).Length;
        var center = inWords ? "R" + Number((long)Math.Round(radius * 1000)) : Offsets(target, exact, radius);
        var words = new List<string>
        {
            Motion(move.Sweep > 0 ? 3 : 2),
            Coordinate('X', target.U, _at.U),
            Coordinate('Y', target.V, _at.V),
            center
        };
        _at = target;
        Words(string.Join(' ', words.Where(w => w.Length > 0)));
    }

    // Whole micrometers near the exact center for which both radii agree and are the wanted one.
    private string Offsets((long U, long V) target, Flat exact, double radius)
    {
        var near = Round(exact);
        var best = (Cost: double.MaxValue, I: 0L, J: 0L);
        for (var u = near.U - 2; u <= near.U + 2; u++)
        {
            for (var v = near.V - 2; v <= near.V + 2; v++)
            {
                var start = Distance(_at, (u, v));
                var end = Distance(target, (u, v));
                var cost = Math.Abs(start - end) + Math.Abs((start + end) / 2 - (radius * 1000)) + (0.5 * Distance((u, v), (0, 0), exact));
                best = cost < best.Cost ? (cost, u - _at.U, v - _at.V) : best;
            }
        }

        return $"I{Number(best.I)} J{Number(best.J)}";
    }

    private static double Distance((long U, long V) a, (long U, long V) b) => new Flat(a.U - b.U, a.V - b.V).Length;

    private static double Distance((long U, long V) grid, (long U, long V) origin, Flat exact) =>
        (new Flat(grid.U - origin.U, grid.V - origin.V) - (exact * 1000)).Length;

    private string Motion(int motion)
    {
        var word = motion == _motion ? "" : $"G{motion}";
        _motion = motion;
        return word;
    }

    private string Coordinate(char axis, long target, long now) =>
        target == now && _motion < 2 ? "" : Incremental ? axis + Number(target - now) : axis + Number(target);

    private static string Number(long micrometers)
    {
        var text = (micrometers / 1000m).ToString("0.###", CultureInfo.InvariantCulture);
        return text.Contains('.') ? text : text + ".";
    }

    private static (long U, long V) Round(Flat place) => ((long)Math.Round(place.U * 1000), (long)Math.Round(place.V * 1000));
}
