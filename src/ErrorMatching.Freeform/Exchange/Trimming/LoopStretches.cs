namespace ErrorMatching.Freeform;

/// <summary>The stretches of a loop between the parts that are near something.</summary>
internal sealed class LoopStretches
{
    // Rounding may leave a gap between two adjoining near parts of a side.
    private const double NothingMm = 1e-9;

    private readonly List<(double LengthMm, int Side, double Share, double LongestMm)> _stretches = [];
    private bool _open;

    /// <summary>Appends a side to the loop.</summary>
    /// <param name="side">Number of the next side.</param>
    /// <param name="lengthMm">Its length.</param>
    /// <param name="near">The shares of its length between which it is near something, in any order; sorted by this call.</param>
    public void Add(int side, double lengthMm, List<(double From, double To)> near)
    {
        var at = 0.0;
        near.Sort();
        foreach (var (from, to) in near)
        {
            if (from > at)
            {
                Far(side, lengthMm, at, from);
            }

            (at, _open) = (Math.Max(at, to), false);
        }

        if (at < 1)
        {
            Far(side, lengthMm, at, 1);
        }
    }

    /// <summary>Returns a place on each stretch longer than a length: the middle of its longest straight part.</summary>
    public IReadOnlyList<(int Side, double Share)> Of(double lengthMm) =>
        [.. _stretches.Where(s => s.LengthMm > Math.Max(lengthMm, NothingMm)).Select(s => (s.Side, s.Share))];

    private void Far(int side, double lengthMm, double from, double to)
    {
        var length = (to - from) * lengthMm;
        var part = (LengthMm: length, Side: side, Share: (from + to) / 2, LongestMm: length);
        if (!_open)
        {
            _stretches.Add(part);
            _open = true;
            return;
        }

        var whole = _stretches[^1];
        _stretches[^1] = length > whole.LongestMm
            ? part with { LengthMm = whole.LengthMm + length }
            : whole with { LengthMm = whole.LengthMm + length };
    }
}
