using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Combines pieces into the tool's path: what is cut without leaving the surface, and how the tool enters and leaves. Joins passes
/// to chains: alternating in direction with short links along the edge, or each separately.</summary>
/// <param name="context">What the path is planned with.</param>
/// <param name="pieces">Creates the links.</param>
/// <param name="gouges">Tests the ways in and out.</param>
/// <param name="totals">The totals of the path.</param>
internal sealed class ChainBuilder(PlanningContext context, PieceBuilder pieces, GougeTest gouges, PathTotals totals)
{
    private readonly CenterLine _link = new();
    private readonly List<CutChain> _chains = [];
    private List<CutPiece> _open = [];
    private CutPass? _last;
    private bool _backwards;

    public IReadOnlyList<CutChain> Chains => _chains;

    /// <summary>Number of passes with pieces.</summary>
    public int Passes { get; private set; }

    /// <summary>Z of the ball's center on the way from chain to chain. Rounding never takes it into the material.</summary>
    public double TravelCenterZ { get; } = Math.Max(
        context.Rounding.Nearest(new(0, 0, gouges.HighestMm + context.Offset.DistanceMm + context.Toolpath.ClearanceMm)).Z,
        context.Rounding.Up(gouges.HighestMm + context.FreeMm));

    /// <summary>Adds a pass to the open chain, or starts another.</summary>
    public void Add(CutPass pass)
    {
        if (context.Refusal is not null || pass.Pieces.Count == 0)
        {
            return;
        }

        Passes++;
        var link = Link(pass);
        if (link is null)
        {
            End();
        }
        else
        {
            totals.Count(_link);
            _open.Add(link);
        }

        if (pass.Pieces.Count == 1)
        {
            _open.Add(pass.Pieces[0] with { Backwards = _backwards });
        }
        else
        {
            for (var i = 0; i < pass.Pieces.Count; i++)
            {
                AddChain([pass.Pieces[_backwards ? ^(i + 1) : i] with { Backwards = _backwards }]);
            }
        }

        _last = pass;
        _backwards = context.Toolpath.Zigzag && !_backwards;
    }

    /// <summary>Ends the open chain.</summary>
    public void End()
    {
        AddChain(_open);
        _open = [];
    }

    /// <summary>Adds a pass along an edge as a chain of its own.</summary>
    public void AddEdge(CutPiece piece, CenterLine line)
    {
        if (context.Refusal is null)
        {
            totals.Count(line);
            AddChain([piece]);
        }
    }

    private void AddChain(List<CutPiece> chain)
    {
        if (context.Refusal is not null || chain.Count == 0)
        {
            return;
        }

        var (leadIn, leadOut) = (Lead(chain[0], first: true), Lead(chain[^1], first: false));
        if (leadIn is { } a && leadOut is { } b)
        {
            _chains.Add(new(chain, a, b));
        }
    }

    private CutPiece? Link(CutPass pass)
    {
        if (!context.Toolpath.Zigzag || _open.Count == 0 || pass.Pieces.Count != 1 || _last is not { Pieces.Count: 1 })
        {
            return null;
        }

        // The previous pass ended where this one starts: at low u if it ran backward.
        var (from, to) = _backwards ? (_last.Ends[0].Last, pass.Ends[0].Last) : (_last.Ends[0].First, pass.Ends[0].First);
        var region = context.Offset.Surface.Region;
        foreach (var fraction in (double[])[0.25, 0.5, 0.75])
        {
            var place = from.Lerp(to, fraction);
            if (!region.Contains(place.X, place.Y))
            {
                return null;
            }
        }

        return pieces.Make([from, to], _link);
    }

    /// <summary>From an end of a piece to a place off the surface and its material, from which a rapid move goes straight up: along the
    /// normal, or straight up if that is blocked.</summary>
    private Vector3? Lead(CutPiece piece, bool first)
    {
        var guide = first == piece.Backwards ? piece.Guide[^1] : piece.Guide[0];
        var at = context.Offset.At(guide.X, guide.Y);
        var center = piece.Centers is not { } centers ? at.Center : first == piece.Backwards ? centers[^1] : centers[0];
        foreach (var lead in Leads(at.Normal, TravelCenterZ - center.Z))
        {
            var end = center + lead;
            if (!gouges.Blocks(center, end, at.Normal)
                && (end.Z >= TravelCenterZ || !gouges.MeetsMaterial(end, end with { Z = TravelCenterZ }, at.Normal)))
            {
                return lead;
            }
        }

        context.Refusal ??= new(
            "no-way-out",
            $"at {context.Named(guide)} the tool cannot go up without touching the surface. Trim the surface there, or turn the part.");
        return null;
    }

    // One radius is enough where no more material lies around. In a hollow, the ball is clear of its walls only higher up. At the height
    // of travel it always is.
    private IEnumerable<Vector3> Leads(Vector3 normal, double upMm)
    {
        var length = Math.Min(
            Math.Max(context.Offset.RadiusMm, context.LeastClearanceMm + (3 * context.Rounding.IncrementMm)), context.Toolpath.ClearanceMm);
        yield return normal * length;
        for (; length < upMm; length *= 2)
        {
            yield return new(0, 0, length);
        }

        yield return new(0, 0, upMm);
    }
}
