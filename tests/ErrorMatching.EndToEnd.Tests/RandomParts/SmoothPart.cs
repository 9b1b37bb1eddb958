using System.Globalization;
using System.Text;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// A part whose whole boundary is known, not only its key points: lines and waves that deviate smoothly, corners that the tool leaves
/// round, lead-outs of any angle, and points measured with the noise of a gauge. The same seed gives the same part.
/// </summary>
internal sealed class SmoothPart
{
    private const double Chord = 0.62;
    private const double Margin = 1;

    private readonly Random _random;
    private readonly List<Element> _elements = [];
    private readonly List<Feature> _features = [];
    private readonly double _side;
    private readonly List<(Flat From, Flat To)> _nominal;

    private SmoothPart(int seed, bool onCorners, double noise)
    {
        _random = new(seed);
        (Seed, Noise) = (seed, noise);
        ToolRadius = Math.Round(Draw.Between(_random, 2, 5), 1);
        _side = Draw.Chance(_random, 0.5) ? 1 : -1;
        DrawElements();
        Join();
        Cut();
        _nominal = SmoothMatch.PathOf(Encoding.ASCII.GetBytes(Program));
        Measure(onCorners);
    }

    /// <summary>The number that reproduces it.</summary>
    public int Seed { get; }

    /// <summary>Standard deviation of a measured coordinate along its normal, mm.</summary>
    public double Noise { get; }

    /// <summary>Radius of the tool, mm.</summary>
    public double ToolRadius { get; }

    /// <summary>The nominal program.</summary>
    public string Program { get; private set; } = "";

    /// <summary>The key points.</summary>
    public List<KeyPoint> Points { get; } = [];

    /// <summary>The boundary from the first to the last key point: where it should be, and where it is.</summary>
    public List<(Flat Nominal, Flat Actual)> Boundary { get; } = [];

    /// <summary>The features in the order of cutting.</summary>
    public IReadOnlyList<Feature> Features => _features;

    public static SmoothPart Generate(int seed, bool onCorners, double noise) => new(seed, onCorners, noise);

    /// <summary>The path with the best displacement of each element for the true part: a line can only shift and tilt.</summary>
    public List<(Flat From, Flat To)> BestPath() => PathOf(e => e.Best);

    /// <summary>The path of somebody who knows each wave but for the gauge's noise at its points, and puts each line through its measured
    /// points by least squares: who knows only the points of a line can hardly do better. For parts without points on corners.</summary>
    public List<(Flat From, Flat To)> PathByPoints() => PathOf(element =>
    {
        KeyPoint[] own = [.. Points.Where(p => p.Feature == element.Feature)];
        if (own.Length == 0)
        {
            return element.Best;
        }

        if (element.IsWave)
        {
            return at => element.Best(at) + Noise(element.Offset + at);
        }

        var (along, measured) = (own.Average(p => p.Along), own.Average(p => p.Measured));
        var tilt = own.Sum(p => (p.Along - along) * p.Measured) / own.Sum(p => (p.Along - along) * (p.Along - along));
        return at => measured + (tilt * (element.Offset + at - along));

        double Noise(double at)
        {
            var k = Math.Clamp(Array.FindLastIndex(own, p => p.Along <= at), 0, own.Length - 2);
            var share = Math.Clamp((at - own[k].Along) / (own[k + 1].Along - own[k].Along), 0, 1);
            return ((own[k].Measured - own[k].True) * (1 - share)) + ((own[k + 1].Measured - own[k + 1].True) * share);
        }
    });

    /// <summary>Where each element of the nominal boundary begins and ends.</summary>
    public IEnumerable<Flat> Ends => _elements.SelectMany(e => new[]
    {
        e.Start - (e.NormalAt(0) * ToolRadius), e.End - (e.NormalAt(e.Length) * ToolRadius),
    });

    /// <summary>The nominal path.</summary>
    public List<(Flat From, Flat To)> NominalPath() => PathOf(e => e.Nominal);

    /// <summary>The path whose block ends were moved by the measured deviations, interpolated between the key points.</summary>
    public List<(Flat From, Flat To)> NaivePath()
    {
        var path = new List<(Flat From, Flat To)>();
        Flat? last = null;
        foreach (var element in _elements)
        {
            foreach (var (from, to, at) in element.Blocks)
            {
                var start = last ?? from;
                var end = to + ByPoints(element, at);
                path.Add((start, end));
                last = end;
            }
        }

        return path;
    }

    private Flat ByPoints(Element element, double length)
    {
        if (element.Feature < 0 && !ReferenceEquals(element, _elements[0]))
        {
            return new(0, 0);
        }

        var at = element.Offset + length;
        var before = Points.LastOrDefault(p => p.Along <= at) ?? Points[0];
        var behind = Points.FirstOrDefault(p => p.Along >= at) ?? Points[^1];
        var share = behind.Along > before.Along ? Math.Clamp((at - before.Along) / (behind.Along - before.Along), 0, 1) : 0;
        return (before.Normal * (before.Measured * (1 - share))) + (behind.Normal * (behind.Measured * share));
    }

    private void DrawElements()
    {
        var heading = Draw.Between(_random, -Math.PI, Math.PI);
        var main = heading;
        Add(heading, 12, -1, wave: false);
        var count = _random.Next(2, 6);
        for (var f = 0; f < count; f++)
        {
            heading = Turned(0.35, 1.3);
            var wave = Draw.Chance(_random, 0.3);
            Add(heading, wave ? Draw.Between(_random, 35, 45) : Draw.Between(_random, 18, 30), f, wave);
            heading = _elements[^1].HeadingOut;
        }

        heading = Turned(0.1, 1.3);
        Add(heading, 12, -1, wave: false);

        double Turned(double least, double most)
        {
            double turned;
            do
            {
                turned = heading + Draw.Signed(_random, least, most);
            }
            while (Math.Abs(turned - main) > 1.2);
            return turned;
        }
    }

    private void Add(double heading, double length, int feature, bool wave)
    {
        var phase = Draw.Between(_random, 0, 2 * Math.PI);
        var bend = wave ? Draw.Between(_random, 0.15, 0.45) : 0;
        var period = Draw.Between(_random, 25, 50);
        var element = new Element(heading, length, feature, bend, period, phase, _side);
        if (feature >= 0)
        {
            element.Deviate(_random, wave);
        }

        _elements.Add(element);
    }

    // Puts the elements one behind the other, so that they meet where the nominal ones do.
    private void Join()
    {
        var (at, offset) = (new Flat(Draw.Between(_random, -50, 50), Draw.Between(_random, -50, 50)), 0.0);
        foreach (var element in _elements)
        {
            element.Put(at, offset);
            (at, offset) = (element.End, offset + element.Length);
        }
    }

    // The program with whole micrometers. Path elements without a feature are the ways in and out.
    private void Cut()
    {
        var text = new StringBuilder("%\nO1234 (SMOOTH PART)\nN10 G21 G90 G17 G40 G49 G80\nN20 G54\n");
        var at = Rounded(_elements[0].Start);
        text.Append(CultureInfo.InvariantCulture, $"N30 G0 X{at.U:0.000} Y{at.V:0.000}\nN40 G0 Z2.\nN50 G1 Z-5. F200.\n");
        var block = 100;
        foreach (var element in _elements)
        {
            var first = block + 10;
            foreach (var (_, to, _) in element.Blocks)
            {
                block += 10;
                text.Append(CultureInfo.InvariantCulture, $"N{block} G1 X{Rounded(to).U:0.000} Y{Rounded(to).V:0.000} F500.\n");
            }

            if (element.Feature >= 0)
            {
                var blocks = first == block ? $"N{first}" : $"N{first}..N{block}";
                _features.Add(new($"F{element.Feature}", element.IsWave ? "curve" : "line", blocks));
            }
        }

        Program = text.Append("N9980 G0 Z50.\nN9990 M30\n%\n").ToString();
    }

    private static Flat Rounded(Flat place) => new(Math.Round(place.U, 3), Math.Round(place.V, 3));

    private void Measure(bool onCorners)
    {
        var named = _elements.Where(e => e.Feature >= 0).ToList();
        var dense = Dense(named);
        var label = 0;
        for (var f = 0; f < named.Count; f++)
        {
            var element = named[f];
            var index = _elements.IndexOf(element);
            var (from, to) = (Trim(index - 1, index) + Margin, element.Length - Trim(index, index + 1) - Margin);
            var count = element.IsWave ? _random.Next(5, 13) : _random.Next(2, 6);
            var hasCornerAhead = onCorners && f > 0 && IsRound(index - 1, index) && Draw.Chance(_random, 0.4)
                && Points[^1].Fraction is null;
            var hasCornerBehind = onCorners && f < named.Count - 1 && IsRound(index, index + 1) && Draw.Chance(_random, 0.5);
            var points = new List<KeyPoint>();
            for (var k = 0; k < count; k++)
            {
                var length = from + ((to - from) * k / (count - 1));
                var normal = element.NormalAt(length);
                var place = element.At(length) - (normal * ToolRadius);
                place += ChordsAt(place, normal);
                points.Add(new(f, "", element.Offset + length, place, normal, null));
            }

            if (hasCornerAhead)
            {
                points[0] = OnCorner(index - 1, index, f);
            }

            if (hasCornerBehind)
            {
                points[^1] = OnCorner(index, index + 1, f);
            }

            foreach (var point in points)
            {
                point.Label = $"P{label++}";
                point.True = Probe(dense, point);
                point.Measured = point.True + (Noise * Gauss());
                Points.Add(point);
                _features[f].Points.Add(point.Label);
            }
        }

        var (begin, end) = (Points[0].Along, Points[^1].Along);
        Boundary.AddRange(dense.Where(d => d.Along >= begin - 1e-9 && d.Along <= end + 1e-9).Select(d => (d.Nominal, d.Actual)));
    }

    private KeyPoint OnCorner(int before, int behind, int feature)
    {
        var (vertex, n1, n2) = (_elements[before].End, _elements[before].NormalAt(_elements[before].Length), _elements[behind].NormalAt(0));
        var share = Draw.Between(_random, 0.25, 0.75);
        var normal = ((n1 * (1 - share)) + (n2 * share)).Unit();
        var place = vertex - (normal * ToolRadius);
        return new(feature, "", _elements[behind].Offset, place + ChordsAt(place, normal), normal, share);
    }

    // The tool goes round the outside of the turn.
    // From the boundary beside the smooth path to that beside the program's chords in whole micrometers.
    private Flat ChordsAt(Flat place, Flat normal) => normal * (SmoothMatch.DistanceTo(_nominal, place) - ToolRadius);

    private static Flat NearestOf(List<(Flat From, Flat To)> path, Flat place) => path.Select(p =>
    {
        var way = p.To - p.From;
        return p.From + (way * Math.Clamp((place - p.From).Dot(way) / way.Dot(way), 0, 1));
    }).MinBy(p => (p - place).Length);

    private bool IsRound(int before, int behind) => Turn(before, behind) * _side > 0.1;

    // How much of both elements a sharp corner takes away, with what its deviation may take besides.
    private double Trim(int before, int behind) =>
        IsRound(before, behind) ? 0 : (ToolRadius * Math.Tan(Math.Abs(Turn(before, behind)) / 2)) + 0.5;

    private double Turn(int before, int behind) => Normalized(_elements[behind].HeadingIn - _elements[before].HeadingOut);

    private static double Normalized(double angle) => Math.Atan2(Math.Sin(angle), Math.Cos(angle));

    private double Gauss() =>
        Math.Sqrt(-2 * Math.Log(1 - _random.NextDouble())) * Math.Cos(2 * Math.PI * _random.NextDouble());

    // The boundary of the named elements, densely: nominal and actual, with the length along the path.
    private List<(double Along, Flat Nominal, Flat Actual)> Dense(List<Element> named)
    {
        var dense = new List<(double Along, Flat Nominal, Flat Actual)>();
        foreach (var element in named)
        {
            var index = _elements.IndexOf(element);
            var (from, to) = (Trim(index - 1, index), element.Length - Trim(index, index + 1));
            var steps = (int)((to - from) / 0.15);
            for (var k = 0; k <= steps; k++)
            {
                var length = from + ((to - from) * k / steps);
                var nominal = element.At(length) - (element.NormalAt(length) * ToolRadius);
                dense.Add((element.Offset + length, nominal, ActualAt(element, length)));
            }

            if (index + 1 < _elements.Count - 1 && IsRound(index, index + 1))
            {
                var vertex = element.End;
                var actual = MeetingOf(element, _elements[index + 1], e => e.Actual).Place;
                var (n1, n2) = (element.NormalAt(element.Length), _elements[index + 1].NormalAt(0));
                for (var k = 1; k < 20; k++)
                {
                    var normal = ((n1 * (1 - (k / 20.0))) + (n2 * (k / 20.0))).Unit();
                    dense.Add((element.Offset + element.Length, vertex - (normal * ToolRadius), actual - (normal * ToolRadius)));
                }
            }
        }

        // Beside a sharp corner, the other element takes some of it away.
        var path = PathOf(e => e.Actual, e => e.Pieces(0.25));
        dense.RemoveAll(d => SmoothMatch.DistanceTo(path, d.Actual) < ToolRadius - 0.001);
        return [.. dense.Select(d => (d.Along, Normal: (NearestOf(_nominal, d.Nominal) - d.Nominal).Unit(), d))
            .Select(d => (d.Along, d.d.Nominal + ChordsAt(d.d.Nominal, d.Normal), d.d.Actual + ChordsAt(d.d.Nominal, d.Normal)))];
    }

    // The boundary a radius beside the displaced path.
    private Flat ActualAt(Element element, double length)
    {
        const double Step = 1e-4;
        Flat Path(double at) => element.At(at) + (element.NormalAt(at) * element.Actual(at));
        var tangent = (Path(length + Step) - Path(length - Step)).Unit();
        return Path(length) - (tangent.Left * (_side * ToolRadius));
    }

    // Where the displaced paths of two elements meet: Newton's method from their common end.
    private static (Flat Place, double Before, double Behind) MeetingOf(
        Element before, Element behind, Func<Element, Func<double, double>> course)
    {
        var (s, t) = (before.Length, 0.0);
        for (var i = 0; i < 20; i++)
        {
            var (p, q) = (before.Displaced(s, course(before)), behind.Displaced(t, course(behind)));
            var (dp, dq) = (
                (before.Displaced(s + 1e-4, course(before)) - before.Displaced(s - 1e-4, course(before))) * 5000,
                (behind.Displaced(t + 1e-4, course(behind)) - behind.Displaced(t - 1e-4, course(behind))) * 5000);
            var off = q - p;
            var det = dp.Cross(dq);
            s += off.Cross(dq) / det;
            t += off.Cross(dp) / det;
        }

        return (before.Displaced(s, course(before)), s, t);
    }

    private static double Probe(List<(double Along, Flat Nominal, Flat Actual)> dense, KeyPoint point)
    {
        var best = double.PositiveInfinity;
        for (var i = 1; i < dense.Count; i++)
        {
            var (a, b) = (dense[i - 1].Actual - point.Place, dense[i].Actual - point.Place);
            var (u, v) = (a.Cross(point.Normal), b.Cross(point.Normal));
            if (u * v <= 0 && u != v)
            {
                var at = a + ((b - a) * (u / (u - v)));
                var along = at.Dot(point.Normal);
                best = Math.Abs(along) < Math.Abs(best) ? along : best;
            }
        }

        return double.IsFinite(best) ? best : dense.Min(d => (d.Actual - point.Place).Length);
    }

    private List<(Flat From, Flat To)> PathOf(
        Func<Element, Func<double, double>> course, Func<Element, IEnumerable<(Flat From, Flat To, double At)>>? pieces = null)
    {
        var path = new List<(Flat From, Flat To)>();
        for (var i = 0; i < _elements.Count; i++)
        {
            var element = _elements[i];
            var (start, from) = (element.Start, 0.0);
            var (end, to) = (element.End, element.Length);
            if (i > 0)
            {
                (start, _, from) = MeetingOf(_elements[i - 1], element, course);
            }

            if (i < _elements.Count - 1)
            {
                (end, to, _) = MeetingOf(element, _elements[i + 1], course);
            }

            foreach (var (_, _, at) in (pieces?.Invoke(element) ?? element.Blocks).Where(b => b.At > from && b.At < to))
            {
                var place = element.Displaced(at, course(element));
                path.Add((start, place));
                start = place;
            }

            path.Add((start, end));
        }

        return path;
    }

    /// <summary>A feature of the job.</summary>
    public sealed record Feature(string Name, string Kind, string Blocks)
    {
        public List<string> Points { get; } = [];
    }

    /// <summary>A key point: where it should be, and how far off it is along its normal (toward the tool).</summary>
    public sealed class KeyPoint(int feature, string label, double along, Flat place, Flat normal, double? fraction)
    {
        public int Feature { get; } = feature;

        public string Label { get; set; } = label;

        public double Along { get; } = along;

        public Flat Place { get; } = place;

        public Flat Normal { get; } = normal;

        /// <summary>Its place in the round of a corner; null beside an element.</summary>
        public double? Fraction { get; } = fraction;

        public double True { get; set; }

        public double Measured { get; set; }

        public Flat Actual => Place + (Normal * Measured);
    }

    /// <summary>A line or a wave of the tool's path.</summary>
    private sealed class Element(double heading, double length, int feature, double bend, double period, double phase, double side)
    {
        private const int Steps = 2000;
        private readonly Flat[] _table = new Flat[Steps + 1];
        private double _shift;
        private double _tilt;
        private (double Amplitude, double Frequency, double Phase)[] _waves = [];
        private Func<double, double>? _best;

        public double Length => length;

        public int Feature => feature;

        public bool IsWave => bend > 0;

        public double Offset { get; private set; }

        public double HeadingIn => HeadingAt(0);

        public double HeadingOut => HeadingAt(length);

        public Flat Start { get; private set; }

        public Flat End => At(length);

        public Func<double, double> Nominal => _ => 0;

        public Func<double, double> Actual => s => feature < 0 ? 0
            : _shift + (_tilt * ((2 * s / length) - 1)) + _waves.Sum(w => w.Amplitude * Math.Sin((w.Frequency * s) + w.Phase));

        // The line nearest to the actual one, by least squares; a wave can follow.
        public Func<double, double> Best => _best ??= IsWave ? Actual : BestLine();

        public IEnumerable<(Flat From, Flat To, double At)> Blocks => Pieces(IsWave ? Chord : length);

        public IEnumerable<(Flat From, Flat To, double At)> Pieces(double size)
        {
            var count = Math.Max(1, (int)(length / size));
            for (var k = 1; k <= count; k++)
            {
                yield return (At(length * (k - 1) / count), At(length * k / count), length * k / count);
            }
        }

        public void Deviate(Random random, bool wave)
        {
            _shift = Draw.Between(random, -0.13, 0.13);
            _tilt = Draw.Between(random, -0.04, 0.04);
            var count = random.Next(1, 3);
            _waves = [.. Enumerable.Range(0, count).Select(_ => (
                wave ? Draw.Between(random, 0, 0.05) : Draw.Between(random, 0.002, 0.016),
                2 * Math.PI / Draw.Between(random, 20, 60),
                Draw.Between(random, 0, 2 * Math.PI)))];
        }

        public void Put(Flat start, double offset)
        {
            (Start, Offset) = (start, offset);
            _table[0] = start;
            var step = length / Steps;
            for (var k = 0; k < Steps; k++)
            {
                // Simpson's rule for the integral of the heading.
                var (a, b, c) = (
                    Flat.Toward(HeadingAt(k * step)), Flat.Toward(HeadingAt((k + 0.5) * step)), Flat.Toward(HeadingAt((k + 1) * step)));
                _table[k + 1] = _table[k] + ((a + (b * 4) + c) * (step / 6));
            }
        }

        public Flat At(double s)
        {
            if (s < 0 || s > length)
            {
                var end = s < 0 ? 0 : length;
                return _table[s < 0 ? 0 : Steps] + (Flat.Toward(HeadingAt(end)) * (s - end));
            }

            var k = Math.Min(Steps - 1, (int)(s / length * Steps));
            var rest = s - (k * length / Steps);
            return _table[k] + (Flat.Toward(HeadingAt((k * length / Steps) + (rest / 2))) * rest);
        }

        public Flat NormalAt(double s) => Flat.Toward(HeadingAt(Math.Clamp(s, 0, length))).Left * side;

        public Flat Displaced(double s, Func<double, double> course) => At(s) + (NormalAt(s) * course(s));

        private double HeadingAt(double s) => heading + (bend * (Math.Sin((2 * Math.PI * s / period) + phase) - Math.Sin(phase)));

        private Func<double, double> BestLine()
        {
            double[] places = [.. Enumerable.Range(0, 201).Select(k => length * k / 200.0)];
            var mean = places.Average(p => Actual(p));
            var tilt = places.Sum(p => Actual(p) * (p - (length / 2))) / places.Sum(p => (p - (length / 2)) * (p - (length / 2)));
            return s => mean + (tilt * (s - (length / 2)));
        }
    }
}
