using ErrorMatching.Geometry;

namespace ErrorMatching.Jobs;

/// <summary>Curves of a drawing that follow one another, each from where the last one ends.</summary>
/// <param name="Curves">The curves, turned so that they follow one another.</param>
/// <param name="IsClosed">True if the last one ends where the first one starts.</param>
internal sealed record OutlineChain(IReadOnlyList<DrawnCurve> Curves, bool IsClosed)
{
    /// <summary>Ends that are nearer to each other are one, mm: drawings are rounded.</summary>
    public const double JoinMm = 0.01;

    /// <summary>Joins curves by their ends. Where three or more ends meet, it cannot be told which ones follow one another, and the chains
    /// end there.</summary>
    /// <param name="curves">The curves.</param>
    public static IReadOnlyList<OutlineChain> Join(IReadOnlyList<DrawnCurve> curves)
    {
        var ends = new EndGrid(curves);
        var (used, chains) = (new bool[curves.Count], new List<OutlineChain>());
        for (var c = 0; c < curves.Count; c++)
        {
            if (used[c])
            {
                continue;
            }

            used[c] = true;
            if (curves[c] is DrawnArc { IsCircle: true })
            {
                chains.Add(new([curves[c]], IsClosed: true));
                continue;
            }

            var chain = new List<DrawnCurve> { curves[c] };
            Follow(2 * c + 1, chain.Add);
            var closed = chain.Count > 1 && chain[^1].To.DistanceTo(chain[0].From) <= JoinMm
                || chain.Count == 1 && chain[0].From.DistanceTo(chain[0].To) <= JoinMm;
            if (!closed)
            {
                Follow(2 * c, curve => chain.Insert(0, curve.Reversed()));
            }

            chains.Add(new(chain, closed));
        }

        return chains;

        void Follow(int end, Action<DrawnCurve> add)
        {
            while (ends.Partner(end) is { } next && !used[next / 2])
            {
                used[next / 2] = true;
                add(next % 2 == 0 ? curves[next / 2] : curves[next / 2].Reversed());
                end = next ^ 1;
            }
        }
    }

    // The ends of all curves by their places: the start of curve c is end 2 c, its end 2 c + 1.
    private sealed class EndGrid
    {
        private readonly IReadOnlyList<DrawnCurve> _curves;
        private readonly Dictionary<(long X, long Y), List<int>> _cells = [];

        public EndGrid(IReadOnlyList<DrawnCurve> curves)
        {
            _curves = curves;
            for (var end = 0; end < 2 * curves.Count; end++)
            {
                if (curves[end / 2] is DrawnArc { IsCircle: true })
                {
                    continue;
                }

                var cell = CellOf(At(end));
                if (!_cells.TryGetValue(cell, out var list))
                {
                    _cells[cell] = list = [];
                }

                list.Add(end);
            }
        }

        /// <summary>The only other end at the place of an end; null if there is none, or several.</summary>
        public int? Partner(int end)
        {
            var (at, partner) = (At(end), -1);
            var (x, y) = CellOf(at);
            for (var i = x - 1; i <= x + 1; i++)
            {
                for (var j = y - 1; j <= y + 1; j++)
                {
                    foreach (var other in _cells.GetValueOrDefault((i, j)) ?? [])
                    {
                        if (other == end || At(other).DistanceTo(at) > JoinMm)
                        {
                            continue;
                        }

                        if (partner >= 0)
                        {
                            return null;
                        }

                        partner = other;
                    }
                }
            }

            return partner < 0 ? null : partner;
        }

        private Point2 At(int end) => end % 2 == 0 ? _curves[end / 2].From : _curves[end / 2].To;

        private static (long X, long Y) CellOf(Point2 at) => ((long)Math.Floor(at.X / JoinMm), (long)Math.Floor(at.Y / JoinMm));
    }
}
