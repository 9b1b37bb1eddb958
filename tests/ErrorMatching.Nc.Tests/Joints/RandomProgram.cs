using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>
/// A small random program with everything that is ordinary: contours of lines and arcs, on the grid of 0.001 mm, that often begin or end
/// where another one did; plunges, retracts and rapids; steps in depth, ramps and repeated points; increments, subprograms, tool changes,
/// work offsets, compensation; ways home in machine coordinates and to reference points. Blocks that cut have numbers N1, N2 and so on.
/// </summary>
internal sealed class RandomProgram
{
    private readonly StringBuilder _text = new();
    private readonly StringBuilder _subprograms = new();
    private readonly List<Point2> _places = [];
    private readonly NcSyntax _syntax;
    private readonly string _plane;
    private readonly bool _compensates;
    private StringBuilder _out;
    private ulong _state;
    private Point2 _at;
    private double _depth;
    private bool _incremental;
    private int _subprogram = 100;

    public RandomProgram(int seed)
    {
        _state = (ulong)seed * 0xD1B54A32D192ED03UL;
        _state ^= _state >> 32;
        Dialect = NcDialects.All[Below(NcDialects.All.Count)];
        _syntax = Dialect.Syntax;
        _plane = Chance(0.1) ? "G18" : Chance(0.05) ? "G19" : "G17";
        _compensates = Chance(0.15);
        _out = _text;
        Line($"G21 G90 G40 {_plane} G54".Replace("G21", _syntax == NcSyntax.Siemens ? "G71" : "G21", StringComparison.Ordinal));
        for (var contour = 1 + Below(4); contour > 0; contour--)
        {
            Approach();
            Contour();
            Leave();
        }

        Line("M30");
        Text = _text.ToString() + _subprograms;
    }

    public NcDialect Dialect { get; }

    public string Text { get; }

    /// <summary>Number of the last numbered block.</summary>
    public int Count { get; private set; }

    public int Below(int count) => (int)(Next() * count);

    public double Uniform(double low, double high) => low + ((high - low) * Next());

    private char First => _plane switch { "G18" => 'Z', "G19" => 'Y', _ => 'X' };

    private char Second => _plane switch { "G18" => 'X', "G19" => 'Z', _ => 'Y' };

    private char Third => _plane switch { "G18" => 'Y', "G19" => 'X', _ => 'Z' };

    private bool Chance(double of) => Next() < of;

    private double Next()
    {
        _state += 0x9E3779B97F4A7C15UL;
        var mixed = (_state ^ (_state >> 30)) * 0xBF58476D1CE4E5B9UL;
        mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EBUL;
        return Math.ScaleB((mixed ^ (mixed >> 31)) >> 11, -53);
    }

    private void Line(string text) => _out.Append(text).Append('\n');

    private void Numbered(string text) => Line(string.Create(CultureInfo.InvariantCulture, $"N{++Count} {text}"));

    private static string Number(double value) => value.ToString("0.0##", CultureInfo.InvariantCulture);

    private static Point2 Grid(Point2 p) => new(Math.Round(p.X, 3), Math.Round(p.Y, 3));

    // Words of a place in the plane; those that do not change are mostly left out.
    private string Words(Point2 to, bool all = false)
    {
        var (x, y) = _incremental ? (Math.Round(to.X - _at.X, 3), Math.Round(to.Y - _at.Y, 3)) : (to.X, to.Y);
        var text = (all || to.X != _at.X || Chance(0.2) ? $" {First}{Number(x)}" : "")
            + (all || to.Y != _at.Y || Chance(0.2) ? $" {Second}{Number(y)}" : "");
        _at = to;
        return text;
    }

    private string Height(double z)
    {
        var word = $" {Third}{Number(_incremental ? Math.Round(z - _depth, 3) : z)}";
        _depth = z;
        return word;
    }

    private void Approach()
    {
        var start = _places.Count > 0 && Chance(0.5) ? _places[Below(_places.Count)] : Grid(new(Uniform(-40, 40), Uniform(-40, 40)));
        var isThere = start == _at && _places.Count > 0;
        if (isThere && Chance(0.3))
        {
            Line("G0" + Height(5));
        }
        else
        {
            Line("G0" + Words(start, all: true) + (Chance(0.2) ? Height(5) : ""));
            Line((_syntax != NcSyntax.Siemens && Chance(0.3) ? "G43 H1" : "G0") + Height(Chance(0.5) ? 5 : 2));
        }

        Feed("G1" + Height(-Math.Round(Uniform(1, 3), 1)) + " F200.");
    }

    private void Feed(string text)
    {
        if (Chance(0.7))
        {
            Numbered(text);
        }
        else
        {
            Line(text);
        }
    }

    private void Contour()
    {
        var inSubprogram = _syntax == NcSyntax.Iso && Chance(0.1);
        if (inSubprogram)
        {
            _subprogram++;
            Line(string.Create(CultureInfo.InvariantCulture, $"M98 P{_subprogram}"));
            _out = _subprograms;
            Line(string.Create(CultureInfo.InvariantCulture, $"O{_subprogram}"));
        }

        if (Chance(0.2))
        {
            _incremental = true;
            Line("G91");
        }

        var (start, heading) = (_at, Uniform(-Math.PI, Math.PI));
        _places.Add(start);
        if (_compensates)
        {
            Numbered((Chance(0.5) ? "G41" : "G42") + " D1 G1" + Words(Away(heading), all: true));
        }

        var first = _at;
        for (var n = 1 + Below(6); n > 0; n--)
        {
            heading = Element(heading);
            if (Chance(0.12))
            {
                Feed("G1" + Height(Math.Round(_depth - Uniform(0.2, 1), 1)));
            }

            if (Chance(0.05))
            {
                Numbered("G1" + Words(_at, all: true));
            }
        }

        if (Chance(0.3) && first != _at)
        {
            Numbered("G1" + Words(first));
        }

        if (_compensates)
        {
            Numbered("G40 G1" + Words(Away(heading + Uniform(-1, 1)), all: true));
        }

        _places.Add(_at);
        if (_incremental)
        {
            _incremental = false;
            Line("G90");
        }

        if (inSubprogram)
        {
            Line("M99");
            _out = _text;
        }
    }

    private Point2 Away(double heading) => Grid(_at + (Vector2.FromDirection(Angle.FromRadians(heading)) * 8));

    private double Element(double heading)
    {
        heading += Chance(0.25) ? 0 : Uniform(20, 150) * Math.PI / 180 * (Chance(0.5) ? -1 : 1);
        var (start, direction) = (_at, Vector2.FromDirection(Angle.FromRadians(heading)));
        if (Chance(0.65))
        {
            var end = Grid(Chance(0.2) ? new(start.X + Uniform(5, 20), start.Y) : start + (direction * Uniform(3, 20)));
            Numbered("G1" + Words(end) + (Chance(0.05) ? Height(Math.Round(_depth - 0.3, 1)) : ""));
            return (end - start).Direction.Radians;
        }

        var isLeft = Chance(0.5);
        var center = Grid(start + (direction.Left * (Uniform(3, 12) * (isLeft ? 1 : -1))));
        var sweep = (Chance(0.9) ? Uniform(30, 160) : Uniform(200, 300)) * (isLeft ? 1 : -1);
        var arc = new Arc2(center, start.DistanceTo(center), (start - center).Direction, Angle.FromDegrees(sweep));
        var byRadius = Math.Abs(arc.Sweep.Degrees) < 170 && Chance(0.3);
        var radius = (_syntax == NcSyntax.Siemens ? " CR=" : " R") + Number(arc.Radius + 0.001);
        var (i, j) = _plane switch { "G18" => ('K', 'I'), "G19" => ('J', 'K'), _ => ('I', 'J') };
        Numbered((isLeft ? "G3" : "G2") + Words(Grid(arc.End), all: true) + (Chance(0.05) ? Height(Math.Round(_depth - 0.3, 1)) : "")
            + (byRadius ? radius : $" {i}{Number(Math.Round(center.X - start.X, 3))} {j}{Number(Math.Round(center.Y - start.Y, 3))}"));
        return arc.TangentAt(1).Direction.Radians;
    }

    private void Leave()
    {
        if (Chance(0.1))
        {
            // On to the next contour without lifting the tool; whoever changes it may do so.
            if (Chance(0.4))
            {
                Line("T4 M6");
            }

            return;
        }

        Line((Chance(0.9) ? "G0" : "G1") + Height(Chance(0.5) ? 5 : 50));
        var way = Below(9);
        if (way == 0)
        {
            Home(Third);
        }
        else if (way == 1)
        {
            Home(Third);
            Home(Second);
        }
        else if (way == 2)
        {
            Home(Third);
            Line("T2 M6");
        }
        else if (way == 3)
        {
            Line("T3 M6");
        }
        else if (way == 4)
        {
            Line("G0" + Words(Grid(new(Uniform(-40, 40), _at.Y))));
        }
        else if (way == 5)
        {
            Home(First);
        }
        else if (way == 6 && Chance(0.3))
        {
            Line("G55");
        }
    }

    private void Home(char axis)
    {
        if (_syntax == NcSyntax.Siemens)
        {
            Line(Chance(0.5) ? $"G0 SUPA {axis}0" : $"G0 G53 {axis}100");
        }
        else if (Chance(0.5))
        {
            Line($"G0 G53 {axis}0.");
        }
        else if (Chance(0.7))
        {
            Line($"G91 {(Chance(0.8) ? "G28" : "G30")} {axis}0.");
            Line("G90");
        }
        else
        {
            Line($"G28 {axis}{Number(axis == Third ? 60 : 10)}");
        }

        // Where it stands is not known any more; the next contour states it.
        _at = axis == First ? new(double.NaN, _at.Y) : axis == Second ? new(_at.X, double.NaN) : _at;
    }
}
