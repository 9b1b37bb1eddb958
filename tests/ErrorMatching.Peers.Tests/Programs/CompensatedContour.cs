using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Peers.Tests;

/// <summary>
/// A random program of contours under G41.1 and G42.1: lines and arcs, inside and outside corners, tangents, leads of all kinds, moves of
/// the third axis, and, in the rough ones, elements that are too small for the tool. Blocks are numbered by their lines.
/// </summary>
internal sealed class CompensatedContour
{
    private readonly StringBuilder _text = new();
    private readonly Random _random;
    private readonly bool _inch;
    private readonly bool _zx;
    private readonly bool _incremental;
    private readonly bool _isRough;
    private readonly double _radius;
    private Point2 _at;
    private double _height = 5;
    private double _heading;
    private int _line;

    public CompensatedContour(int seed)
    {
        _random = new Random(seed);
        (_inch, _zx, _incremental) = (_random.Next(5) == 0, _random.Next(6) == 0, _random.Next(4) == 0);
        _isRough = _random.Next(3) == 0;
        _radius = Math.Round(0.5 + (4 * _random.NextDouble()), 3);
        Line($"{(_inch ? "G20" : "G21")} {(_zx ? "G18" : "G17")} G40 G90 G91.1 G94 F{Number(300)}");
        Line($"G0 {Words(Grid(new(40 * Next(), 40 * Next())))} {Height(5)}");
        Line($"G1 {Height(-1)}");
        if (_incremental)
        {
            Line("G91");
        }

        var contours = 1 + _random.Next(2);
        for (var i = 0; i < contours; i++)
        {
            Contour();
        }

        Line($"G0 G90 {Height(5)}");
        Line($"G0 {Words(Grid(new(3, 4)), absolute: true)}");
        Line("M2");
    }

    /// <summary>The program.</summary>
    public string Text => _text.ToString();

    /// <summary>The blocks of contour elements.</summary>
    public List<int> Elements { get; } = [];

    private void Contour()
    {
        _heading = 2 * Math.PI * _random.NextDouble();
        var lead = _radius * (_isRough && _random.Next(4) == 0 ? 2 * _random.NextDouble() : 1.3 + (6 * _random.NextDouble()));
        var on = string.Create(
            CultureInfo.InvariantCulture, $"{(_random.Next(2) == 0 ? "G41.1" : "G42.1")} D{Number(2 * _radius)}");
        if (_random.Next(3) == 0)
        {
            Line(on);
            on = "";
        }

        if (_random.Next(10) == 0)
        {
            Arc(on, Turned(0.3));
        }
        else
        {
            Straight($"{on} {(_random.Next(6) == 0 ? "G0" : "G1")}", lead);
        }

        var elements = 2 + _random.Next(_isRough ? 8 : 12);
        for (var i = 0; i < elements; i++)
        {
            Elements.Add(_line);
            switch (_random.Next(20))
            {
                case 0:
                    _height = Math.Round(_height + 0.5, 3);
                    Line($"{(_random.Next(2) == 0 ? "G0" : "G1")} {Height(_height, by: 0.5)}");
                    break;
                case 1:
                    Straight("G0", Length());
                    break;
                case < 8:
                    Arc("", Turned(0.4));
                    break;
                default:
                    _heading = Turned(0.15);
                    Straight("G1", Length());
                    break;
            }
        }

        _heading = Turned(0.2);
        if (_random.Next(3) == 0)
        {
            Line("G40");
            Straight("G1", lead);
        }
        else
        {
            Straight("G40 G1", lead);
        }
    }

    // Mostly well above the tool's size; in rough programs down to nothing.
    private double Length() => _radius * (_isRough ? 6 * _random.NextDouble() : 3 + (8 * _random.NextDouble()));

    // A tangent with the given probability, a slight turn, or a corner to either side.
    private double Turned(double tangents)
    {
        var kind = _random.NextDouble();
        var most = _isRough ? Math.PI : 1.9;
        return _heading + (kind < tangents ? 0 : kind < tangents + 0.15 ? 0.12 * Next() : most * Next());
    }

    private void Straight(string words, double length)
    {
        var end = Grid(_at + (Vector2.FromDirection(Angle.FromRadians(_heading)) * length));
        var helix = _random.Next(8) == 0 && words.Contains("G1", StringComparison.Ordinal);
        Line($"{words} {Words(end)}{(helix ? " " + Raised() : "")}");
    }

    private void Arc(string words, double heading)
    {
        var left = _random.Next(2) == 0;
        var radius = _radius * (_isRough ? 0.3 + (5 * _random.NextDouble()) : 1.5 + (7 * _random.NextDouble()));
        var side = Vector2.FromDirection(Angle.FromRadians(heading)).Left * (left ? radius : -radius);
        var start = _at;
        var center = Fine(start + side);
        var full = _random.Next(12) == 0;
        var sweep = full ? 2 * Math.PI : (_isRough ? 0.05 : 0.6) + (4.5 * _random.NextDouble() * _random.NextDouble());
        var back = start - center;
        var direction = Math.Atan2(back.Y, back.X) + (left ? sweep : -sweep);
        var end = full ? start : Grid(center + (Vector2.FromDirection(Angle.FromRadians(direction)) * back.Length));
        _heading = direction + (left ? Math.PI / 2 : -Math.PI / 2);
        var code = left ? "G3" : "G2";
        var by = sweep is > 0.2 and < 2.8 && _random.Next(2) == 0
            ? $"R{Number(Math.Round(back.Length / Unit, 4) * Unit)}"
            : $"{(_zx ? "K" : "I")}{Number(center.X - start.X)} {(_zx ? "I" : "J")}{Number(center.Y - start.Y)}";
        var extra = (_random.Next(10) == 0 ? " " + Raised() : "") + (full && _random.Next(3) == 0 ? " P2" : "");
        Line($"{words} {code} {Words(end)} {by}{extra}");
    }

    private string Raised()
    {
        _height = Math.Round(_height + 0.25, 3);
        return Height(_height, by: 0.25);
    }

    private double Next() => (2 * _random.NextDouble()) - 1;

    private double Unit => _inch ? 25.4 : 1;

    private Point2 Grid(Point2 p) => Rounded(p, _inch ? 4 : 3);

    private Point2 Fine(Point2 p) => Rounded(p, 5);

    private Point2 Rounded(Point2 p, int decimals) =>
        new(Math.Round(p.X / Unit, decimals) * Unit, Math.Round(p.Y / Unit, decimals) * Unit);

    private string Words(Point2 end, bool absolute = false)
    {
        var (x, y) = _incremental && !absolute && _line > 3 ? (end.X - _at.X, end.Y - _at.Y) : (end.X, end.Y);
        _at = end;
        return _zx ? $"Z{Number(x)} X{Number(y)}" : $"X{Number(x)} Y{Number(y)}";
    }

    private string Height(double height, double? by = null)
    {
        _height = height;
        return $"{(_zx ? "Y" : "Z")}{Number(_incremental && by is { } step ? step : height)}";
    }

    private string Number(double mm) => ((mm / Unit) + 0.0).ToString("0.######", CultureInfo.InvariantCulture);

    private void Line(string words)
    {
        _line++;
        _text.Append(CultureInfo.InvariantCulture, $"N{_line} {words.Trim()}\n");
    }
}
