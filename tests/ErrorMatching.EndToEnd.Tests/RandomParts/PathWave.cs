namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// A sine wave as the boundary, written as a dense polyline of the tool's path (a CAM's chords: 0.3 um of chord error).
/// Its deviation is a parabola over the length along the boundary.
/// </summary>
internal sealed class PathWave : IPathElement
{
    private const double ChordError = 0.0003;

    private readonly Flat _origin;
    private readonly Flat _axis;
    private readonly double _extent;
    private readonly double _amplitude;
    private readonly double _frequency;
    private readonly double _phase;
    private readonly double _offset;
    private readonly double[] _lengths;

    /// <param name="start">Start of the path.</param>
    /// <param name="axis">Heading of the wave's axis, radians.</param>
    /// <param name="extent">Length along the axis.</param>
    /// <param name="wavelength">Wavelength; the amplitude follows, so that slopes stay under 27 degrees and the tool fits.</param>
    /// <param name="phase">Phase at the start, radians.</param>
    /// <param name="offset">From the path to the boundary.</param>
    public PathWave(Flat start, double axis, double extent, double wavelength, double phase, double offset)
    {
        _axis = Flat.Toward(axis);
        _extent = extent;
        _frequency = 2 * Math.PI / wavelength;
        _amplitude = Math.Min(0.5 / _frequency, 0.4 / ((offset + 3) * _frequency * _frequency));
        _phase = phase;
        _offset = offset;
        _lengths = Lengths(4000);
        _origin = start - Boundary(0) - (Normal(0) * offset);
    }

    public Flat Start => Path(0);

    public Flat End => Path(_extent);

    public double HeadingIn => Normal(0).Left.Heading;

    public double HeadingOut => Normal(_extent).Left.Heading;

    public double BoundaryLength => _lengths[^1];

    public (Flat Place, Flat Normal) BoundaryAt(double length)
    {
        var after = Math.Clamp(Array.FindIndex(_lengths, l => l >= length), 1, _lengths.Length - 1);
        var between = (length - _lengths[after - 1]) / (_lengths[after] - _lengths[after - 1]);
        var abscissa = _extent * (after - 1 + between) / (_lengths.Length - 1);
        return (_origin + Boundary(abscissa), Normal(abscissa));
    }

    public IEnumerable<PathMove> Moves()
    {
        var sharpest = 1 / ((1 / (_amplitude * _frequency * _frequency)) - _offset);
        var count = (int)Math.Ceiling(_extent * 1.15 / Math.Sqrt(8 * ChordError / sharpest));
        return Enumerable.Range(1, count).Select(k => new PathMove(Path(_extent * k / count)));
    }

    public Func<double, double> DrawDeviation(Random random)
    {
        var shift = Draw.Signed(random, 0.06, 0.25);
        var tilt = Draw.Between(random, -0.08, 0.08);
        var bend = Draw.Between(random, -0.06, 0.06);
        return length =>
        {
            var at = (2 * length / BoundaryLength) - 1;
            return shift + (tilt * at) + (bend * at * at);
        };
    }

    private Flat Path(double abscissa) => _origin + Boundary(abscissa) + (Normal(abscissa) * _offset);

    private Flat Boundary(double abscissa) => (_axis * abscissa) + (_axis.Left * (_amplitude * Math.Sin((_frequency * abscissa) + _phase)));

    private double Slope(double abscissa) => _amplitude * _frequency * Math.Cos((_frequency * abscissa) + _phase);

    /// <summary>Right of the travel, where the tool is.</summary>
    private Flat Normal(double abscissa) => -(_axis + (_axis.Left * Slope(abscissa))).Unit().Left;

    /// <summary>Length along the boundary at equidistant places, by Simpson's rule on each.</summary>
    private double[] Lengths(int steps)
    {
        double Speed(double abscissa) => Math.Sqrt(1 + (Slope(abscissa) * Slope(abscissa)));
        var lengths = new double[steps + 1];
        var step = _extent / steps;
        for (var k = 0; k < steps; k++)
        {
            lengths[k + 1] = lengths[k] + (step / 6 * (Speed(k * step) + (4 * Speed((k + 0.5) * step)) + Speed((k + 1) * step)));
        }

        return lengths;
    }
}
