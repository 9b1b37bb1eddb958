using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Peers.Tests;

/// <summary>
/// A random contour under radius compensation, written twice: for LinuxCNC (G41.1, G42.1), where roundings and chamfers are written out as
/// arcs and lines, and in Klartext (RL, RR), with C, CP, CR, CT, LP, RND and CHF. Blocks of both are numbered alike. In the rough ones,
/// some elements are too small for the tool.
/// </summary>
internal sealed class TwoTongueContour
{
    private readonly StringBuilder _iso = new();
    private readonly StringBuilder _klartext = new();
    private readonly Random _random;
    private readonly bool _isRough;
    private Point2 _at;
    private Point2 _before;
    private double _heading;
    private int _number;

    public TwoTongueContour(int seed)
    {
        _random = new Random(seed);
        _isRough = _random.Next(4) == 0;
        Radius = Math.Round(0.5 + (4 * _random.NextDouble()), 3);
        var isLeft = _random.Next(2) == 0;
        _iso.Append(CultureInfo.InvariantCulture, $"G21 G17 G40 G90 G91.1 G94 F300\nG0 X0 Y0 Z5\nG1 Z-1\n");
        _klartext.Append("BEGIN PGM A MM\nTOOL CALL 1 Z S3000\nL X+0 Y+0 Z+5 R0 FMAX\nL Z-1 F300\n");
        _heading = 2 * Math.PI * _random.NextDouble();
        Straight(
            Ahead(Radius * (2 + (4 * _random.NextDouble()))),
            string.Create(CultureInfo.InvariantCulture, $"{(isLeft ? "G41.1" : "G42.1")} D{2 * Radius} "),
            isLeft ? " RL" : " RR");

        // Where compensation begins differs: the first element is long enough for both ways.
        _heading += 0.3 * Next();
        Straight(Ahead(8 * Radius));
        _heading = Turned();
        var elements = 3 + _random.Next(10);
        for (var i = 0; i < elements; i++)
        {
            Element();
        }

        Straight(Ahead(4 * Radius), "G40 ", " R0");
        _iso.Append("M2\n");
        _klartext.Append("END PGM A MM\n");
    }

    /// <summary>The radius of the tool, mm.</summary>
    public double Radius { get; }

    /// <summary>The contour for LinuxCNC.</summary>
    public string Iso => _iso.ToString();

    /// <summary>The contour in Klartext.</summary>
    public string Klartext => _klartext.ToString();

    private void Element()
    {
        switch (_random.Next(10))
        {
            case < 4:
                Straight(Ahead(Length()));
                _heading = Turned();
                break;
            case < 8:
                Arc();
                break;
            default:
                Corner();
                break;
        }
    }

    private double Length() => Radius * (_isRough ? 6 * _random.NextDouble() : 3 + (8 * _random.NextDouble()));

    // Tangential, a corner to either side, or rarely a slight turn.
    private double Turned()
    {
        var kind = _random.NextDouble();
        return _heading + (kind < 0.25 ? 0 : kind < 0.35 ? 0.12 * Next() : 1.9 * Next());
    }

    private void Straight(Point2 end, string iso = "", string klartext = "")
    {
        var words = $"L X{Signed(end.X)} Y{Signed(end.Y)}{klartext}";
        if (klartext.Length == 0 && _random.Next(5) == 0)
        {
            // By its distance from a pole and the angle about it.
            var (pole, ray) = (Grid(end + new Vector2(9 * Next(), 9)), default(Vector2));
            ray = end - pole;
            _klartext.Append(CultureInfo.InvariantCulture, $"CC X{Signed(pole.X)} Y{Signed(pole.Y)}\n");
            words = $"LP PR{Fine(ray.Length)} PA{Fine(Math.Atan2(ray.Y, ray.X) * 180 / Math.PI)}";
        }

        Write($"{iso}G1 X{Number(end.X)} Y{Number(end.Y)}", words);
        _at = end;
    }

    // About a center, by its radius, or in Klartext as a continuation of the line before it.
    private void Arc()
    {
        if (_random.Next(4) == 0)
        {
            Straight(Ahead(Length()));
            Continue();
            return;
        }

        var left = _random.Next(2) == 0;
        var radius = Radius * (1.5 + (7 * _random.NextDouble()));
        var center = Fine(_at + (Vector2.FromDirection(Angle.FromRadians(_heading)).Left * (left ? radius : -radius)));
        var back = _at - center;
        var sweep = 0.6 + (4.5 * _random.NextDouble() * _random.NextDouble());
        var direction = Math.Atan2(back.Y, back.X) + (left ? sweep : -sweep);
        var end = center + (Vector2.FromDirection(Angle.FromRadians(direction)) * back.Length);
        var isToAngle = _random.Next(3) == 0;
        end = isToAngle ? end : Grid(end);
        _heading = direction + (left ? Math.PI / 2 : -Math.PI / 2);
        var sense = left ? "DR+" : "DR-";
        var (code, to) = (left ? "G3" : "G2", $"X{Signed(end.X)} Y{Signed(end.Y)}");
        if (isToAngle)
        {
            _klartext.Append(CultureInfo.InvariantCulture, $"CC X{Signed(center.X)} Y{Signed(center.Y)}\n");
            Write(
                $"{code} X{Number(end.X)} Y{Number(end.Y)} I{Number(center.X - _at.X)} J{Number(center.Y - _at.Y)}",
                $"CP IPA{Fine((left ? sweep : -sweep) * 180 / Math.PI)} {sense}");
        }
        else if (sweep < 2.8 && _random.Next(2) == 0)
        {
            var by = Number(Math.Round(back.Length, 4));
            Write($"{code} X{Number(end.X)} Y{Number(end.Y)} R{by}", $"CR {to} R+{by} {sense}");
        }
        else
        {
            _klartext.Append(CultureInfo.InvariantCulture, $"CC X{Signed(center.X)} Y{Signed(center.Y)}\n");
            Write(
                $"{code} X{Number(end.X)} Y{Number(end.Y)} I{Number(center.X - _at.X)} J{Number(center.Y - _at.Y)}",
                $"C {to} {sense}");
        }

        _at = end;
        _heading = Turned();
    }

    // CT: the circle that touches the line before it and goes through the end.
    private void Continue()
    {
        var side = Math.Sign(Next()) * (0.3 + _random.NextDouble());
        var end = Grid(_at + (Vector2.FromDirection(Angle.FromRadians(_heading + side)) * (Radius * (3 + (6 * _random.NextDouble())))));
        var (chord, along) = (end - _at, (_at - _before).Normalize());
        var radius = chord.Dot(chord) / (2 * along.Cross(chord));
        var center = _at + (along.Left * radius);
        Write(
            $"{(radius > 0 ? "G3" : "G2")} X{Number(end.X)} Y{Number(end.Y)} I{Number(center.X - _at.X)} J{Number(center.Y - _at.Y)}",
            $"CT X{Signed(end.X)} Y{Signed(end.Y)}");
        var radial = end - center;
        _heading = Math.Atan2(radial.Y, radial.X) + (radius > 0 ? Math.PI / 2 : -Math.PI / 2);
        _at = end;
        _heading = Turned();
    }

    // Two lines with a rounding or a chamfer between them, which LinuxCNC gets as an arc or a line.
    private void Corner()
    {
        var vertex = Ahead(Length() + (4 * Radius));
        var turn = (0.5 + (1.2 * _random.NextDouble())) * Math.Sign(Next());
        var end = Grid(vertex + (Vector2.FromDirection(Angle.FromRadians(_heading + turn)) * (Length() + (4 * Radius))));
        var (a, b) = ((vertex - _at).Normalize(), (end - vertex).Normalize());
        turn = Math.Atan2(a.Cross(b), a.Dot(b));
        var isRounding = _random.Next(2) == 0;
        var size = Math.Round(Radius * (1.2 + _random.NextDouble()), 3);
        var leg = isRounding ? size * Math.Tan(Math.Abs(turn) / 2) : size;
        var (from, to) = (vertex - (a * leg), vertex + (b * leg));
        var center = from + (a.Left * (turn > 0 ? size : -size));
        Write($"G1 X{Number(from.X)} Y{Number(from.Y)}", $"L X{Signed(vertex.X)} Y{Signed(vertex.Y)}");
        Write(
            isRounding
                ? $"{(turn > 0 ? "G3" : "G2")} X{Number(to.X)} Y{Number(to.Y)} I{Number(center.X - from.X)} J{Number(center.Y - from.Y)}"
                : $"G1 X{Number(to.X)} Y{Number(to.Y)}",
            isRounding ? $"RND R{Number(size)}" : $"CHF {Number(size)}");
        Write($"G1 X{Number(end.X)} Y{Number(end.Y)}", $"L X{Signed(end.X)} Y{Signed(end.Y)}");
        (_at, _heading) = (end, Math.Atan2(b.Y, b.X));
        _heading = Turned();
    }

    private Point2 Ahead(double length)
    {
        _before = _at;
        return Grid(_at + (Vector2.FromDirection(Angle.FromRadians(_heading)) * length));
    }

    private double Next() => (2 * _random.NextDouble()) - 1;

    private static Point2 Grid(Point2 p) => new(Math.Round(p.X, 3), Math.Round(p.Y, 3));

    private static Point2 Fine(Point2 p) => new(Math.Round(p.X, 4), Math.Round(p.Y, 4));

    private static string Fine(double value) => value.ToString("+0.########;-0.########;+0", CultureInfo.InvariantCulture);

    private static string Number(double value) => (value + 0.0).ToString("0.#########", CultureInfo.InvariantCulture);

    private static string Signed(double value) => (value + 0.0).ToString("+0.####;-0.####;+0", CultureInfo.InvariantCulture);

    private void Write(string iso, string klartext)
    {
        _number++;
        _iso.Append(CultureInfo.InvariantCulture, $"N{_number} {iso}\n");
        _klartext.Append(CultureInfo.InvariantCulture, $"{_number} {klartext}\n");
    }
}
