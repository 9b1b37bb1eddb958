using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Plans one path. Each pass is made, measured, and refined until it is within tolerance.</summary>
internal sealed partial class PathPlanning
{
    /// <summary>Most points of a path: beyond it a tolerance or a unit is wrong.</summary>
    private const int MostPoints = 50_000_000;

    /// <summary>After so many passes it is told how many points come of all of them, and given up if these are far too many: a surface in
    /// meters that are millimeters is not followed for minutes.</summary>
    private const int FirstPasses = 50;
    private const double FarTooMany = 10.0 * MostPoints;

    /// <summary>So many points are kept as they are; those of a longer path are made again when they are written.</summary>
    private const int MostKept = 100_000;

    /// <summary>How often something is made finer before it is refused.</summary>
    private const int Tries = 24;

    private readonly OffsetSurface _offset;
    private readonly CenterRounding _rounding;
    private readonly JobToolpath _toolpath;
    private readonly int _decimals;
    private readonly PassBuilder _builder;
    private readonly PatchTree _tree;
    private readonly RollingBall _rolling;
    private readonly List<CenterLine> _edges = [];
    private readonly List<CutPiece> _edgePieces = [];
    private readonly StripHeight _strip;
    private readonly List<CutChain> _chains = [];
    private (Point2 From, Point2 To)? _free;
    private Refusal? _refusal;
    private int _passes;
    private int _points;
    private double _length;
    private (double Mm, Point2 At) _chord;
    private (double Mm, Point2 At) _scallop = (double.NegativeInfinity, default);
    private int _raisedPoints;
    private (double Mm, Point2 At) _raised;

    public PathPlanning(OffsetSurface offset, CenterRounding rounding, JobToolpath toolpath, int decimals)
    {
        (_offset, _rounding, _toolpath, _decimals) = (offset, rounding, toolpath, decimals);
        _builder = new(offset, rounding, toolpath.ChordMm, PassBuilder.LiftShare * toolpath.ScallopMm);
        _tree = new(offset.Surface);
        _rolling = new(offset.Surface.Spline, offset.DistanceMm);
        _strip = new(offset, _edges, toolpath.ScallopMm);
    }

    // A part of the planning that runs concurrently with another, with its own state.
    private PathPlanning(PathPlanning whole)
        : this(
            new(whole._offset.Surface, whole._offset.RadiusMm, whole._offset.StockMm), whole._rounding, whole._toolpath, whole._decimals) =>
            _edges.AddRange(whole._edges);

    // The polyline is within the chordal error of the exact offset. A center nearer than twice that touches elsewhere.
    private double GougeMm => 2 * _toolpath.ChordMm;

    private double NearestMm => _offset.DistanceMm - GougeMm;

    private double TravelCenterZ => _rounding.Nearest(new(0, 0, _tree.HighestMm + _offset.DistanceMm + _toolpath.ClearanceMm)).Z;

    public ToolPathResult Run()
    {
        if (EdgeInSurface() is { } edge)
        {
            return edge;
        }

        MakeEdges();
        if (_refusal is null)
        {
            MakePasses();
        }

        foreach (var piece in _edgePieces)
        {
            AddChain([piece]);
        }

        if (_refusal is { } refusal)
        {
            return refusal;
        }

        // If chords cut in by more than the height of the ridge, nothing is left over the surface. The height is then 0, not negative.
        var certificate = new ToolPathCertificate(
            _chord.Mm,
            PlaceOf(_chord.At),
            Math.Max(0, _scallop.Mm),
            PlaceOf(_scallop.At),
            GougeMm,
            _raisedPoints,
            _raised.Mm,
            PlaceOf(_raised.At));
        return new ToolPath(
            () => new(_offset, _rounding, _toolpath.ChordMm, PassBuilder.LiftShare * _toolpath.ScallopMm),
            _offset,
            _rounding,
            _chains,
            new(_passes, _points, _length, TravelCenterZ, certificate, _decimals));
    }

    private Point3 PlaceOf(Point2 at) => _offset.Left(at.X, at.Y).Place;

    // A pass along the edge of a trimmed region. Where it is nearly parallel to the passes, the area between would otherwise have none.
    private void MakeEdges()
    {
        foreach (var loop in _offset.Surface.Region.Loops)
        {
            var line = new CenterLine();
            if (_refusal is null && Make([.. loop, loop[0]], line) is { } piece)
            {
                _edges.Add(line);
                _edgePieces.Add(piece);
            }
        }
    }

    // Half of the passes run on a second core. Both halves calculate the middle pass, with identical results.
    private void MakePasses()
    {
        var lines = new RegionLines(_offset.Surface);
        var middle = (lines.First + lines.Last) / 2;
        var (before, behind) = (new PathPlanning(this), new PathPlanning(this));
        var second = Task.Run(() => behind.Passes(lines, middle, lines.Last));
        var passes = before.Passes(lines, lines.First, middle);
        passes.AddRange(second.GetAwaiter().GetResult());
        Take(before);
        Take(behind);
        var chainer = new Chainer(this);
        foreach (var pass in passes)
        {
            chainer.Add(pass);
        }

        chainer.End();
    }

    private void Take(PathPlanning part)
    {
        _refusal ??= part._refusal;
        _points += part._points;
        _length += part._length;
        _raisedPoints += part._raisedPoints;
        _chord = part._chord.Mm > _chord.Mm ? part._chord : _chord;
        _scallop = part._scallop.Mm > _scallop.Mm ? part._scallop : _scallop;
        _raised = part._raised.Mm > _raised.Mm ? part._raised : _raised;
    }

    /// <summary>The passes from one line to another. The first one is included only if it is the region's first line.</summary>
    private List<CutPass> Passes(RegionLines lines, double first, double last)
    {
        var spacing = new PassSpacing(_offset, _toolpath.ScallopMm);
        var passes = new List<CutPass>();
        var v = first;
        var pass = MakePass(lines, v);
        Free(pass);
        if (first == lines.First)
        {
            Keep(pass);
        }

        while (_refusal is null && v < last)
        {
            if (Next(lines, spacing, pass, last) is not { } next)
            {
                break;
            }

            pass.Lines.Clear();
            (pass, v) = (next, next.V);
            Keep(pass);
            if (passes.Count == FirstPasses && _points * ((last - first) / (v - first)) is > FarTooMany and var all)
            {
                _refusal = TooLong($"about {all.ToString("0.#E+0", CultureInfo.InvariantCulture)}");
            }
        }

        return passes;

        void Keep(CutPass kept)
        {
            passes.Add(kept);
            for (var i = 0; i < kept.Lines.Count; i++)
            {
                var line = kept.Lines[i];
                kept.Ends.Add((line.Places[0], line.Places[^1]));
                Count(line);
                if (_points <= MostKept / 2)
                {
                    kept.Pieces[i] = kept.Pieces[i] with { Centers = kept.Pieces[i].Centers ?? line.Centers.ToArray() };
                }
            }
        }
    }

    // The next pass, as far away as the ridge between allows.
    private CutPass? Next(RegionLines lines, PassSpacing spacing, CutPass pass, double last)
    {
        var v = pass.V;
        var width = spacing.From(pass);
        for (var attempt = 0; ; attempt++)
        {
            var to = width >= last - v ? last : width > (last - v) / 2 ? (v + last) / 2 : v + width;
            var candidate = MakePass(lines, to);
            // The gouge test is the slowest. If the pass will probably be remade, it comes last, except where balls are raised.
            var isFreed = pass.IsRaised || attempt > 0;
            if (isFreed)
            {
                Free(candidate);
            }

            if (_refusal is not null)
            {
                return null;
            }

            var (height, at) = _strip.Measure(pass.Lines, v, candidate.Lines, to);
            if (height <= _toolpath.ScallopMm && !isFreed)
            {
                Free(candidate);
                if (_refusal is not null)
                {
                    return null;
                }

                (height, at) = candidate.IsRaised ? _strip.Measure(pass.Lines, v, candidate.Lines, to) : (height, at);
            }

            if (height <= _toolpath.ScallopMm)
            {
                spacing.Learn(to - v, height);
                _scallop = height > _scallop.Mm ? (height, at) : _scallop;
                return candidate;
            }

            if (attempt == Tries || to <= v)
            {
                _refusal = NotReached("scallop", height, _toolpath.ScallopMm, at);
                return null;
            }

            width = (to - v) * Math.Clamp(Math.Sqrt(0.93 * _toolpath.ScallopMm / height), 0.3, 0.97);
        }
    }

    private CutPass MakePass(RegionLines lines, double v)
    {
        var pass = new CutPass(v);
        foreach (var (from, to) in lines.On(v))
        {
            var line = new CenterLine();
            if (Follow([new(from, v), new(to, v)], line) is not { } piece)
            {
                break;
            }

            pass.Pieces.Add(piece);
            pass.Lines.Add(line);
        }

        return pass;
    }

    private void Free(CutPass pass)
    {
        for (var i = 0; i < pass.Pieces.Count && _refusal is null; i++)
        {
            if (Gouges(pass.Lines[i]) && Raise(pass.Pieces[i], pass.Lines[i]) is { } raised)
            {
                pass.Pieces[i] = raised;
                pass.IsRaised = true;
            }
        }
    }

    /// <summary>Creates a piece within the chordal error, without gouges.</summary>
    private CutPiece? Make(IReadOnlyList<Point2> guide, CenterLine line) =>
        Follow(guide, line) is not { } piece ? null : Gouges(line) ? Raise(piece, line) : piece;

    /// <summary>Creates a piece within the chordal error.</summary>
    private CutPiece? Follow(IReadOnlyList<Point2> guide, CenterLine line)
    {
        var piece = new CutPiece(guide, 1, 0.25);
        for (var attempt = 0; ; attempt++)
        {
            _builder.Build(piece, line);
            if (Impossible(line) is { } refusal)
            {
                _refusal = refusal;
                return null;
            }

            var (chord, at) = line.MeasureChord(_offset);
            if (chord <= _toolpath.ChordMm)
            {
                break;
            }

            if (attempt == Tries || !double.IsFinite(chord))
            {
                _refusal = NotReached("chordal error", chord, _toolpath.ChordMm, at);
                return null;
            }

            piece = piece with { Finer = 1.15 * piece.Finer, LongestStep = Math.Max(0.7 * piece.LongestStep, 1e-3) };
        }

        return piece;
    }

    // Adds a piece to the totals of the path.
    private void Count(CenterLine line)
    {
        _points += line.Count;
        if (_points > MostPoints)
        {
            _refusal ??= TooLong("more");
        }

        var (chord, at) = line.Chord;
        _chord = chord > _chord.Mm ? (chord, at) : _chord;
        for (var i = 0; i < line.Count; i++)
        {
            if (line.Raised[i] > 0)
            {
                _raisedPoints++;
                _raised = line.Raised[i] > _raised.Mm ? (line.Raised[i], line.Places[i]) : _raised;
            }

            _length += i > 0 ? (line.Centers[i] - line.Centers[i - 1]).Length : 0;
        }
    }

    private static Refusal TooLong(string points) =>
        new(
            "path-too-long",
            string.Create(
                CultureInfo.InvariantCulture,
                $"the path would have {points} points; at most {MostPoints} are made. Check the units of the surface, and scallopMm and "
                    + $"chordMm."));

    private Refusal NotReached(string what, double found, double wanted, Point2 at) => new(
        "tolerance-not-reached",
        string.Create(
            CultureInfo.InvariantCulture,
            $"at {Named(at)} the {what} is {found:0.000000} mm, more than {wanted} mm, however close the points are laid. Allow more, or "
                + $"use a dialect with a finer increment than {_rounding.IncrementMm} mm."));

    /// <summary>A place in the surface's own parameters and in millimeters.</summary>
    private string Named(Point2 at)
    {
        var (u, v) = _toolpath.AlongU ? (at.X, at.Y) : (at.Y, at.X);
        return string.Create(CultureInfo.InvariantCulture, $"u {u:0.####}, v {v:0.####} ({PlaceText.Words(PlaceOf(at))})");
    }
}
