using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Creates pieces of the path: within the chordal error, and free of gouges.</summary>
/// <param name="context">What the path is planned with.</param>
/// <param name="gouges">Tests for gouges.</param>
internal sealed class PieceBuilder(PlanningContext context, GougeTest gouges)
{
    /// <summary>How often something is made finer before it is refused.</summary>
    public const int Tries = 24;

    private readonly PassBuilder _builder = context.Builder();
    private readonly SurfaceFaults _faults = new(context);
    private readonly BallLift _lift = new(context, gouges);
    private readonly Stack<CenterLine> _spare = new();

    /// <summary>Creates a piece within the chordal error, without gouges.</summary>
    public CutPiece? Make(IReadOnlyList<Point2> guide, CenterLine line) =>
        Follow(guide, line) is not { } piece ? null : gouges.Gouges(line) ? _lift.Raise(piece, line) : piece;

    /// <summary>Creates the pass on a line. It may still gouge.</summary>
    public CutPass MakePass(RegionLines lines, double v)
    {
        var pass = new CutPass(v);
        foreach (var (from, to) in lines.On(v))
        {
            var line = _spare.TryPop(out var spare) ? spare : new();
            if (Follow([new(from, v), new(to, v)], line) is not { } piece)
            {
                break;
            }

            pass.Pieces.Add(piece);
            pass.Lines.Add(line);
        }

        return pass;
    }

    /// <summary>Takes back the lines of a pass that nothing is measured against any more. Other passes reuse their memory.</summary>
    public void TakeBack(CutPass pass)
    {
        foreach (var line in pass.Lines)
        {
            _spare.Push(line);
        }

        pass.Lines.Clear();
    }

    /// <summary>Raises a pass where it gouges.</summary>
    public void LiftOutOfGouges(CutPass pass)
    {
        for (var i = 0; i < pass.Pieces.Count && context.Refusal is null; i++)
        {
            if (gouges.Gouges(pass.Lines[i]) && _lift.Raise(pass.Pieces[i], pass.Lines[i]) is { } raised)
            {
                pass.Pieces[i] = raised;
                pass.IsRaised = true;
            }
        }
    }

    // A piece within the chordal error.
    private CutPiece? Follow(IReadOnlyList<Point2> guide, CenterLine line)
    {
        var piece = new CutPiece(guide, 1, 0.25);
        for (var attempt = 0; ; attempt++)
        {
            _builder.Build(piece, line);
            if (_faults.Impossible(line) is { } refusal)
            {
                context.Refusal = refusal;
                return null;
            }

            var (chord, at) = line.MeasureChord(context.Offset);
            if (chord <= context.Toolpath.ChordMm)
            {
                break;
            }

            if (attempt == Tries || !double.IsFinite(chord))
            {
                context.Refusal = context.NotReached("chordal error", chord, context.Toolpath.ChordMm, at);
                return null;
            }

            piece = piece with { Finer = 1.15 * piece.Finer, LongestStep = Math.Max(0.7 * piece.LongestStep, 1e-3) };
        }

        return piece;
    }
}
