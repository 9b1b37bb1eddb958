using System.Globalization;

namespace ErrorMatching.Freeform;

/// <summary>Plans consecutive passes on one core, each as far from the previous one as the ridge between them allows. Each pass is made,
/// measured, and refined until it is within tolerance.</summary>
internal sealed class PassSeries
{
    /// <summary>After so many passes it is told how many points come of all of them, and given up if these are far too many: a surface in
    /// meters that are millimeters is not followed for minutes.</summary>
    private const int FirstPasses = 50;
    private const double FarTooMany = 10.0 * PathTotals.MostPoints;

    /// <summary>So many points are kept as they are; those of a longer path are made again when they are written.</summary>
    private const int MostKept = 400_000;

    private readonly PieceBuilder _pieces;
    private readonly StripHeight _strip;

    /// <summary>Prepares a series.</summary>
    /// <param name="context">What the path is planned with, for this series alone.</param>
    /// <param name="edges">The passes along the edges of the region.</param>
    public PassSeries(PlanningContext context, IReadOnlyList<CenterLine> edges)
    {
        (Context, Totals) = (context, new(context));
        _pieces = new(context, new(context));
        _strip = new(context.Offset, edges, context.Toolpath.ScallopMm);
    }

    public PlanningContext Context { get; }

    /// <summary>The totals of the passes so far.</summary>
    public PathTotals Totals { get; }

    /// <summary>The passes from one line to another. The first one is included only if it is the region's first line.</summary>
    public List<CutPass> Passes(RegionLines lines, double first, double last)
    {
        var spacing = new PassSpacing(Context.Offset, Context.Toolpath.ScallopMm);
        var passes = new List<CutPass>();
        var v = first;
        var pass = _pieces.MakePass(lines, v);
        _pieces.LiftOutOfGouges(pass);
        if (first == lines.First)
        {
            Keep(passes, pass);
        }

        while (Context.Refusal is null && v < last)
        {
            if (Next(lines, spacing, pass, last) is not { } next)
            {
                break;
            }

            Context.Progress.Add((next.V - v) / (lines.Last - lines.First));
            _pieces.TakeBack(pass);
            (pass, v) = (next, next.V);
            Keep(passes, pass);
            if (passes.Count == FirstPasses && Totals.Points * ((last - first) / (v - first)) is > FarTooMany and var all)
            {
                Context.Refusal = PathTotals.TooLong($"about {all.ToString("0.#E+0", CultureInfo.InvariantCulture)}");
            }
        }

        return passes;
    }

    private void Keep(List<CutPass> passes, CutPass kept)
    {
        passes.Add(kept);
        for (var i = 0; i < kept.Lines.Count; i++)
        {
            var line = kept.Lines[i];
            kept.Ends.Add((line.Places[0], line.Places[^1]));
            Totals.Count(line);
            if (Totals.Points <= MostKept / 2)
            {
                kept.Pieces[i] = kept.Pieces[i] with { Centers = kept.Pieces[i].Centers ?? line.Centers.ToArray() };
            }
        }
    }

    // The next pass, as far away as the ridge between allows.
    private CutPass? Next(RegionLines lines, PassSpacing spacing, CutPass pass, double last)
    {
        var (v, scallop) = (pass.V, Context.Toolpath.ScallopMm);
        var width = spacing.From(pass);
        for (var attempt = 0; ; attempt++)
        {
            var to = width >= last - v ? last : width > (last - v) / 2 ? (v + last) / 2 : v + width;
            var candidate = _pieces.MakePass(lines, to);

            // The gouge test is the slowest. If the pass will probably be remade, it comes last, except where balls are raised.
            var isFreed = pass.IsRaised || attempt > 0;
            if (isFreed)
            {
                _pieces.LiftOutOfGouges(candidate);
            }

            if (Context.Refusal is not null)
            {
                return null;
            }

            var (height, at) = _strip.Measure(pass.Lines, v, candidate.Lines, to);
            if (height <= scallop && !isFreed)
            {
                _pieces.LiftOutOfGouges(candidate);
                if (Context.Refusal is not null)
                {
                    return null;
                }

                (height, at) = candidate.IsRaised ? _strip.Measure(pass.Lines, v, candidate.Lines, to) : (height, at);
            }

            if (height <= scallop)
            {
                spacing.Learn(to - v, height);
                Totals.Count(height, at);
                return candidate;
            }

            if (attempt == PieceBuilder.Tries || to <= v)
            {
                Context.Refusal = Context.NotReached("scallop", height, scallop, at);
                return null;
            }

            _pieces.TakeBack(candidate);
            width = (to - v) * Math.Clamp(Math.Sqrt(0.93 * scallop / height), 0.3, 0.97);
        }
    }
}
