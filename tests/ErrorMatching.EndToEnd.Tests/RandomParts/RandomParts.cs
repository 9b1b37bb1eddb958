using System.Globalization;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// Random counterparts by number: a shape, the program that cuts it, and a part that deviates from it as its features can represent.
/// Everything comes from one seeded <see cref="Random"/>, whose numbers are the same on every platform.
/// </summary>
internal sealed class RandomParts
{
    private readonly Random _random;
    private readonly Flavor _flavor;
    private readonly double _toolRadius;
    private readonly Contour _contour;
    private readonly Placement _placement;
    private readonly RandomFrame _frame;
    private readonly ProgramWriter _writer;
    private int _labels;

    private RandomParts(int seed)
    {
        _random = new Random(seed);
        _flavor = Flavor.Draw(_random);
        _toolRadius = _random.Next(2, 11) * 0.5;
        var offset = _flavor.Compensated ? 0 : _toolRadius;
        _contour = _flavor.Contour == ContourKind.Open
            ? OpenContour.DrawOne(_random, _toolRadius, offset)
            : ClosedContour.DrawOne(_random, _toolRadius, offset, _flavor.Contour == ContourKind.Pocket);
        _placement = new(
            !_flavor.MaterialLeft,
            Draw.Between(_random, -Math.PI, Math.PI),
            new(Draw.Between(_random, -100, 100), Draw.Between(_random, -100, 100)));
        _frame = new(
            new[] { "none", "x", "y" }[_random.Next(3)],
            _random.Next(3) == 0 ? 0 : Math.Round(Draw.Between(_random, -180, 180), 3),
            new(Math.Round(Draw.Between(_random, -120, 120), 3), Math.Round(Draw.Between(_random, -120, 120), 3)));
        _writer = new(_flavor.RadiusArcs);
    }

    /// <summary>The part of a number, zero or more.</summary>
    public static RandomPart Generate(int seed)
    {
        var parts = new RandomParts(seed);
        var groups = parts._contour.Features.Select(_ => new List<IReadOnlyList<RandomKeyPoint>>()).ToList();
        var blocks = parts.Write(seed);
        foreach (var piece in parts._contour.Pieces.Where(p => p.Group >= 0))
        {
            groups[piece.Feature].Add(parts.KeyPoints(piece));
        }

        var features = parts._contour.Features.Select((f, i) => new RandomFeature($"F{i + 1}", f.Kind, f.Shape, blocks[i], groups[i]));
        return new(seed, parts._flavor, parts._writer.Text, parts._flavor.ToolOf(parts._toolRadius), parts._frame, [.. features]);
    }

    /// <summary>Writes the program; answers the blocks of each feature.</summary>
    private string[] Write(int seed)
    {
        var blocks = new string[_contour.Features.Count];
        var start = _placement.Place(_contour.LeadIn);
        _writer.Raw("%");
        _writer.Raw($"O{(seed % 9000) + 1:0000}");
        _writer.Raw($"(RANDOM PART {seed.ToString(CultureInfo.InvariantCulture)})");
        _writer.Words("G21 G17 G40 G90");
        _writer.Words("G54");
        _writer.Words("T1 M6");
        _writer.Words("S6000 M3");
        _writer.Line(start, motion: 0);
        _writer.Words("G43 H1 Z5.");
        _writer.Plunge();
        if (_flavor.Incremental)
        {
            _writer.Words("G91");
            _writer.Incremental = true;
        }

        // Material left of the travel means the tool right of it.
        _writer.Line(
            _placement.Place(_contour.Pieces[0].Element.Start),
            before: !_flavor.Compensated ? "" : _flavor.MaterialLeft ? "G42 D1" : "G41 D1",
            after: "F500.");
        foreach (var piece in _contour.Pieces)
        {
            WritePiece(piece, blocks);
        }

        _writer.Line(_placement.Place(_contour.LeadOut), before: _flavor.Compensated ? "G40" : "");
        _writer.Words("G90 G0 Z50.");
        _writer.Words("M5");
        _writer.Words("M30");
        _writer.Raw("%");
        return blocks;
    }

    private void WritePiece(ContourPiece piece, string[] blocks)
    {
        foreach (var move in piece.Element.Moves().Select(_placement.Place))
        {
            if (move.Center is null)
            {
                _writer.Line(move.To);
            }
            else
            {
                _writer.Arc(move);
            }

            if (piece.Feature >= 0)
            {
                var named = blocks[piece.Feature];
                blocks[piece.Feature] = named is null ? _writer.Block : $"{named.Split("..")[0]}..{_writer.Block}";
            }
        }
    }

    private List<RandomKeyPoint> KeyPoints(ContourPiece piece)
    {
        var feature = _contour.Features[piece.Feature];
        var count = feature.Shape switch
        {
            "arc" => _random.Next(5, 10),
            "wave" => _random.Next(7, 15),
            _ => feature.Kind == "triangle" ? 2 : _random.Next(2, 5),
        };
        var deviation = piece.Element.DrawDeviation(_random);
        var first = piece.TrimIn + ContourPiece.Margin;
        var last = piece.Element.BoundaryLength - piece.TrimOut - ContourPiece.Margin;
        return [.. Enumerable.Range(0, count).Select(k => KeyPoint(piece.Element, first + ((last - first) * k / (count - 1)), deviation))];
    }

    private RandomKeyPoint KeyPoint(IPathElement element, double length, Func<double, double> deviation)
    {
        var (ownPlace, ownNormal) = element.BoundaryAt(length);
        var place = _placement.Place(ownPlace);
        var normal = _placement.Vector(ownNormal);
        var deviated = deviation(length);
        _labels++;
        return new(
            _labels.ToString(CultureInfo.InvariantCulture),
            place,
            normal,
            deviated,
            _frame.ToPart(place),
            _frame.ToPart(place + (normal * deviated)));
    }
}
