using System.Globalization;
using System.Text;

namespace ErrorMatching.Nc.Tests;

/// <summary>An open contour of straight lines in XY, N101 and so on, with a quarter of a circle in ZX or YZ that leads in to it from above,
/// N5, and one that leads out, N201. All is on a grid of 0.001 mm.</summary>
internal sealed class LedContour
{
    private readonly List<(double X, double Y)> _points = [];
    private readonly (bool IsZX, int Side, double Radius) _in;
    private readonly (bool IsZX, int Side, double Radius) _out;

    public LedContour(int seed)
    {
        var random = new Random(seed);
        var (x, y, angle) = (random.Next(-9000, 9000) / 1000.0, random.Next(-9000, 9000) / 1000.0, random.NextDouble() * 2 * Math.PI);
        angle = random.Next(3) == 0 ? Math.Round(angle / (Math.PI / 2)) * Math.PI / 2 : angle;
        _points.Add((x, y));
        for (var i = random.Next(2, 6); i > 0; i--)
        {
            var length = 15 + (15 * random.NextDouble());
            (x, y) = (Math.Round(x + (length * Math.Cos(angle)), 3), Math.Round(y + (length * Math.Sin(angle)), 3));
            _points.Add((x, y));
            angle += (random.Next(2) == 0 ? 1 : -1) * (0.5 + (1.3 * random.NextDouble()));
        }

        (_in, _out) = (Lead(), Lead());

        (bool IsZX, int Side, double Radius) Lead() =>
            (random.Next(2) == 0, random.Next(2) == 0 ? 1 : -1, random.Next(500, 4000) / 1000.0);
    }

    /// <summary>Number of lines.</summary>
    public int Count => _points.Count - 1;

    /// <summary>The program.</summary>
    /// <param name="incremental">True to write the contour and both arcs in increments.</param>
    /// <param name="radius">The word of the arcs' radius; empty to write their centers.</param>
    public string Spell(bool incremental, string radius)
    {
        var text = new StringBuilder();
        var (x, y) = _points[0];
        var (beside, before) = (Beside(_in), (X: x + Beside(_in).X, Y: y + Beside(_in).Y));
        text.Append(
            CultureInfo.InvariantCulture,
            $"N1 G17 G40 G90\nN2 G0 X{Text(before.X)} Y{Text(before.Y)}\nN3 G0 Z10.\nN4 G1 Z{Text(_in.Radius)} F100.\n"
                + $"{(incremental ? "N50 G91\n" : "")}");

        // Down to the bottom of its circle, or up from there. The sense is seen against the third axis: from Z to X, from Y to Z.
        var (words, height) = incremental
            ? ((X: -beside.X, Y: -beside.Y), -_in.Radius) : ((X: x, Y: y), 0);
        text.Append(
            CultureInfo.InvariantCulture,
            $"N5 {(_in.IsZX ? "G18" : "G19")} {(_in.IsZX == _in.Side > 0 ? "G3" : "G2")} {End(_in, words, height)} "
                + $"{(radius.Length > 0 ? radius + Text(_in.Radius) : (_in.IsZX ? "I" : "J") + Text(-_in.Side * _in.Radius) + " K0.")}\n");
        for (var i = 1; i <= Count; i++)
        {
            var to = incremental ? (X: _points[i].X - _points[i - 1].X, Y: _points[i].Y - _points[i - 1].Y) : _points[i];
            text.Append(CultureInfo.InvariantCulture, $"N{100 + i} {(i == 1 ? "G1 " : "")}X{Text(to.X)} Y{Text(to.Y)}\n");
        }

        var (away, last) = (Beside(_out), _points[^1]);
        (words, height) = (incremental ? away : (last.X + away.X, last.Y + away.Y), _out.Radius);
        return text.Append(
            CultureInfo.InvariantCulture,
            $"N201 {(_out.IsZX ? "G18" : "G19")} {(_out.IsZX == _out.Side > 0 ? "G2" : "G3")} {End(_out, words, height)} "
                + $"{(radius.Length > 0 ? radius : "K")}{Text(_out.Radius)}\nN202 G90 G0 Z10.\nN203 G17\nN204 G0 X0. Y0.\nM30\n")
                    .ToString();
    }

    private static (double X, double Y) Beside((bool IsZX, int Side, double Radius) lead) =>
        lead.IsZX ? (lead.Side * lead.Radius, 0) : (0, lead.Side * lead.Radius);

    private static string End((bool IsZX, int Side, double Radius) lead, (double X, double Y) end, double height) =>
        (lead.IsZX ? "X" + Text(end.X) : "Y" + Text(end.Y)) + " Z" + Text(height);

    private static string Text(double mm) => (Math.Round(mm, 3) + 0.0).ToString("0.0##", CultureInfo.InvariantCulture);
}
