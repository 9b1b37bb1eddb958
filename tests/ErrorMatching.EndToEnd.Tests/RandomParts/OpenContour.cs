namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// Draws an open run of one to four features, some with connecting lines between them.
/// Headings stay within 69 degrees of the main direction, so that the run cannot cut itself.
/// </summary>
internal sealed class OpenContour
{
    private const double SteepestHeading = 1.2;

    private readonly Random _random;
    private readonly double _toolRadius;
    private readonly double _offset;
    private readonly List<Spec> _specs = [];
    private readonly List<(string Kind, string Shape)> _features = [];
    private double _heading;

    private OpenContour(Random random, double toolRadius, double offset)
    {
        _random = random;
        _toolRadius = toolRadius;
        _offset = offset;
    }

    /// <summary>An element before its place is known: it is built once the corners around it are.</summary>
    private sealed record Spec(
        int Feature, int Group, double HeadingIn, double HeadingOut, bool Curved, Func<Flat, double, double, IPathElement> Build);

    public static Contour DrawOne(Random random, double toolRadius, double offset)
    {
        var contour = new OpenContour(random, toolRadius, offset);
        contour.AddLine(ContourPiece.Connector, -1, Draw.Between(random, -0.5, 0.5));
        for (var left = random.Next(1, 5); left > 0; left--)
        {
            contour.AddFeature();
            if (left == 1 || Draw.Chance(random, 0.6))
            {
                contour.AddLine(ContourPiece.Connector, -1, contour.Turned(0.35, 1.3));
            }
        }

        return contour.Build();
    }

    private void AddFeature()
    {
        switch (_random.Next(4))
        {
            case 0:
                AddLine(Next("line", "straight"), 0, Turned(0.35, 1.3));
                break;
            case 1:
                AddTriangle();
                break;
            case 2:
                AddArc();
                break;
            default:
                AddWave();
                break;
        }
    }

    private int Next(string kind, string shape)
    {
        _features.Add((kind, shape));
        return _features.Count - 1;
    }

    private double Turned(double least, double most)
    {
        double heading;
        do
        {
            heading = _heading + Draw.Signed(_random, least, most);
        }
        while (Math.Abs(heading) > SteepestHeading);
        return heading;
    }

    private void AddLine(int feature, int group, double heading)
    {
        var free = Draw.Between(_random, 14, 30);
        Add(new(feature, group, heading, heading, Curved: false, (start, trimIn, trimOut) =>
            new PathLine(start, start + (Flat.Toward(heading) * (free + trimIn + trimOut)), _offset)));
    }

    private void AddTriangle()
    {
        var feature = Next("triangle", "straight");
        AddLine(feature, 0, Turned(0.35, 1.3));
        var heading = Turned(0.7, 1.5);
        if (Draw.Chance(_random, 0.5))
        {
            var boundaryRadius = heading > _heading ? Draw.Between(_random, 1.5, 4) : _toolRadius + Draw.Between(_random, 0.8, 4);
            AddCircular(feature, -1, _heading, heading - _heading, boundaryRadius);
        }

        AddLine(feature, 1, heading);
    }

    private void AddArc()
    {
        var tangent = Draw.Chance(_random, 0.15);
        var heading = tangent ? _heading : Turned(0.35, 1.3);
        double sweep;
        do
        {
            sweep = Draw.Signed(_random, 0.6, 1.3);
        }
        while (Math.Abs(heading + sweep) > SteepestHeading);
        AddCircular(Next("curve", "arc"), 0, heading, sweep, Draw.Between(_random, 12, 30));
    }

    /// <summary>An arc by the radius of its boundary; one that carries key points is made larger if the corners would leave too little of
    /// it.</summary>
    private void AddCircular(int feature, int group, double heading, double sweep, double boundaryRadius) =>
        Add(new(feature, group, heading, heading + sweep, Curved: group >= 0, (start, trimIn, trimOut) =>
        {
            var needed = group < 0 ? 0 : (10 + (2 * ContourPiece.Margin) + trimIn + trimOut) / Math.Abs(sweep);
            var radius = Math.Max(boundaryRadius, needed) + (sweep > 0 ? _offset : -_offset);
            return new PathArc(start, heading, radius, sweep, _offset);
        }));

    private void AddWave()
    {
        PathWave wave;
        double axis;
        var extent = Draw.Between(_random, 40, 60);
        var wavelength = Draw.Between(_random, 20, 60);
        double phase;
        do
        {
            axis = Draw.Between(_random, -0.7, 0.7);
            phase = Draw.Between(_random, 0, 2 * Math.PI);
            wave = new PathWave(new(0, 0), axis, extent, wavelength, phase, _offset);
        }
        while (Math.Abs(wave.HeadingIn - _heading) is < 0.35 or > 1.4);
        Add(new(Next("curve", "wave"), 0, wave.HeadingIn, wave.HeadingOut, Curved: true, (start, _, _) =>
            new PathWave(start, axis, extent, wavelength, phase, _offset)));
    }

    private void Add(Spec spec)
    {
        _specs.Add(spec);
        _heading = spec.HeadingOut;
    }

    private Contour Build()
    {
        var pieces = new List<ContourPiece>();
        var at = new Flat(0, 0);
        for (var i = 0; i < _specs.Count; i++)
        {
            var spec = _specs[i];
            var trimIn = i == 0 ? 0 : Trim(_specs[i - 1], spec);
            var trimOut = i == _specs.Count - 1 ? 0 : Trim(spec, _specs[i + 1]);
            var element = spec.Build(at, trimIn, trimOut);
            pieces.Add(new(element, spec.Feature, spec.Group, trimIn, trimOut));
            at = element.End;
        }

        return new(pieces, _features, Outside(pieces[0].Element.Start, _specs[0].HeadingIn, -6), Outside(at, _specs[^1].HeadingOut, 6));
    }

    // A curved wall meets the other one further along than a straight one would: half as far again is ample at these radii.
    private double Trim(Spec before, Spec after) =>
        ContourPiece.Trim(after.HeadingIn - before.HeadingOut, _offset) * (before.Curved || after.Curved ? 1.6 : 1);

    private static Flat Outside(Flat place, double heading, double along) =>
        place + (Flat.Toward(heading) * along) - (Flat.Toward(heading).Left * 8);
}
