using System.Globalization;
using System.Text;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A random program of a dialect: two to four rings of lines and arcs on the grid of 0.001 mm, some in increments, some in
/// subprograms, with the dialect's own words between them. The blocks of ring 1 are N101, N102 and so on.</summary>
internal sealed class DialectProgram
{
    private const double Grid = 1000;

    private readonly StringBuilder _text = new();
    private readonly StringBuilder _subprograms = new();
    private readonly Random _random;

    public DialectProgram(DialectSpelling spelling, int seed)
    {
        _random = new Random(seed);
        _text.Append(spelling.Head).Append('\n');
        var rings = 2 + _random.Next(3);
        for (var ring = 1; ring <= rings; ring++)
        {
            if (ring > 1)
            {
                var interlude = spelling.Interludes[_random.Next(spelling.Interludes.Length)];
                _text.Append(interlude.Replace("{1}", ring.ToString(CultureInfo.InvariantCulture), StringComparison.Ordinal)).Append('\n');
            }

            Ring(spelling, ring);
        }

        Displaced = 1 + _random.Next(rings);
        Left = (_random.Next(2) == 0 ? 1 : -1) * _random.Next(20, 200) / Grid;
        Text = _text.Append("M30\n").Append(_subprograms).Append(spelling.Further).ToString();
    }

    public string Text { get; }

    /// <summary>The ring to displace.</summary>
    public int Displaced { get; }

    /// <summary>By how much to the left, mm.</summary>
    public double Left { get; }

    /// <summary>Number of blocks of each ring.</summary>
    public Dictionary<int, int> Blocks { get; } = [];

    private static (double X, double Y) Round((double X, double Y) p) => (Math.Round(p.X * Grid) / Grid, Math.Round(p.Y * Grid) / Grid);

    private static string Number(double value) => (Math.Round(value, 3) + 0.0).ToString("0.0##", CultureInfo.InvariantCulture);

    private bool Coin() => _random.Next(2) == 0;

    private void Ring(DialectSpelling spelling, int ring)
    {
        var corners = 4 + _random.Next(5);
        var (x, y) = (100.0 * ring, 50 * _random.NextDouble());
        var points = new (double X, double Y)[corners];
        for (var i = 0; i < corners; i++)
        {
            var (turn, radius) = (i * 2 * Math.PI / corners, 30 + (12 * _random.NextDouble()));
            points[i] = Round((x + (radius * Math.Cos(turn)), y + (radius * Math.Sin(turn))));
        }

        Line($"G0 X{Number(points[0].X)} Y{Number(points[0].Y)} Z5.");
        Line($"G1 Z{Number(-1 - (_random.Next(20) / 10.0))} F200.");
        var isCalled = spelling.Call.Length > 0 && _random.Next(3) == 0;
        var number = 1000 + ring;
        if (isCalled)
        {
            Line(string.Format(CultureInfo.InvariantCulture, spelling.Call, number));
            _subprograms.Append(CultureInfo.InvariantCulture, $"{string.Format(CultureInfo.InvariantCulture, spelling.Begin, number)}\n");
        }

        var lines = Elements(spelling, ring, points, isCalled ? "PX" : "XOFS");
        (isCalled ? _subprograms : _text).AppendJoin('\n', lines).Append('\n');
        if (isCalled)
        {
            _subprograms.Append(spelling.End).Append('\n');
        }

        Line("G0 Z5.\nG0 X0. Y0.");
    }

    private void Line(string text) => _text.Append(text).Append('\n');

    private List<string> Elements(DialectSpelling spelling, int ring, (double X, double Y)[] points, string three)
    {
        var lines = new List<string>();
        var incremental = _random.Next(3) == 0;
        if (incremental)
        {
            lines.Add("G91");
        }

        for (var i = 0; i + 1 < points.Length; i++)
        {
            var (from, to) = (points[i], points[i + 1]);
            var (dx, dy) = (to.X - from.X, to.Y - from.Y);
            string Word(double value) => spelling.Formula?.Invoke(Math.Round(value, 3), three, _random) ?? Number(value);
            var end = $"X{Word(incremental ? dx : to.X)} Y{Word(incremental ? dy : to.Y)}";
            lines.Add($"N{(100 * ring) + i + 1} " + (Coin() ? $"G1 {end}" : Arc(from, dx, dy, end)));
        }

        if (incremental)
        {
            lines.Add("G90");
        }

        Blocks[ring] = points.Length - 1;
        return lines;
    }

    // A flat arc over the chord: its center is on the bisector, moved to the grid.
    private string Arc((double X, double Y) from, double dx, double dy, string end)
    {
        var (left, away) = (Coin(), 0.7 + _random.NextDouble());
        var side = left ? away : -away;
        var center = Round((from.X + (dx / 2) - (dy * side), from.Y + (dy / 2) + (dx * side)));
        var (i, j) = (center.X - from.X, center.Y - from.Y);
        var radius = Math.Ceiling(Math.Sqrt((i * i) + (j * j)) * Grid) / Grid;
        return $"{(left ? "G3" : "G2")} {end} " + (_random.Next(3) == 0 ? $"R{Number(radius)}" : $"I{Number(i)} J{Number(j)}");
    }
}
