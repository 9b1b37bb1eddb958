using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <content>Combines pieces into the tool's path: what is cut without leaving the surface, and how the tool enters and leaves.</content>
internal sealed partial class PathPlanning
{
    private void AddChain(IReadOnlyList<CutPiece> pieces)
    {
        if (_refusal is not null || pieces.Count == 0)
        {
            return;
        }

        foreach (var edge in pieces.Where(_edgePieces.Contains))
        {
            Count(_edges[_edgePieces.IndexOf(edge)]);
        }

        var (leadIn, leadOut) = (Lead(pieces[0], first: true), Lead(pieces[^1], first: false));
        if (leadIn is { } a && leadOut is { } b)
        {
            _chains.Add(new(pieces, a, b));
        }
    }

    /// <summary>From an end of a piece to a place off the surface: along the normal, or straight up if that is blocked. From there the
    /// tool can retract straight up.</summary>
    private Vector3? Lead(CutPiece piece, bool first)
    {
        var guide = first == piece.Backwards ? piece.Guide[^1] : piece.Guide[0];
        var at = _offset.At(guide.X, guide.Y);
        var length = Math.Min(_offset.RadiusMm, _toolpath.ClearanceMm);
        foreach (var direction in (Vector3[])[at.Normal, new(0, 0, 1)])
        {
            var lead = direction * length;
            if (IsFree(at.Center, at.Center + lead, at.Normal)
                && IsFree(at.Center + lead, (at.Center + lead) with { Z = TravelCenterZ }, at.Normal))
            {
                return lead;
            }
        }

        _refusal ??= new(
            "no-way-out",
            $"at {Named(guide)} the tool cannot go up without touching the surface. Trim the surface there, or turn the part.");
        return null;
    }

    // After its start, a straight move keeps the ball off the surface. Checked every quarter of a radius.
    private bool IsFree(Point3 from, Point3 to, Vector3 normal)
    {
        var way = to - from;
        var steps = (int)Math.Ceiling(4 * way.Length / _offset.RadiusMm);
        for (var i = 1; i <= steps; i++)
        {
            if (_tree.IsNearer(from + (way * ((double)i / steps)), normal, NearestMm - MostRaised))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Joins passes to chains: alternating in direction with short links along the edge, or each separately.</summary>
    private sealed class Chainer(PathPlanning planning)
    {
        private readonly CenterLine _link = new();
        private List<CutPiece> _open = [];
        private CutPass? _last;
        private bool _backwards;

        public void Add(CutPass pass)
        {
            if (planning._refusal is not null || pass.Pieces.Count == 0)
            {
                return;
            }

            planning._passes++;
            var link = Link(pass);
            if (link is null)
            {
                End();
            }
            else
            {
                planning.Count(_link);
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
                    planning.AddChain([pass.Pieces[_backwards ? ^(i + 1) : i] with { Backwards = _backwards }]);
                }
            }

            _last = pass;
            _backwards = planning._toolpath.Zigzag && !_backwards;
        }

        public void End()
        {
            planning.AddChain(_open);
            _open = [];
        }

        private CutPiece? Link(CutPass pass)
        {
            if (!planning._toolpath.Zigzag || _open.Count == 0 || pass.Pieces.Count != 1 || _last is not { Pieces.Count: 1 })
            {
                return null;
            }

            // The previous pass ended where this one starts: at low u if it ran backward.
            var (from, to) = _backwards ? (_last.Ends[0].Last, pass.Ends[0].Last) : (_last.Ends[0].First, pass.Ends[0].First);
            var region = planning._offset.Surface.Region;
            foreach (var fraction in (double[])[0.25, 0.5, 0.75])
            {
                var place = from.Lerp(to, fraction);
                if (!region.Contains(place.X, place.Y))
                {
                    return null;
                }
            }

            return planning.Make([from, to], _link);
        }
    }
}
