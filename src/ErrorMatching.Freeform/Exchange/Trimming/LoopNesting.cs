using System.Runtime.InteropServices;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Checks that loops bound a piece in the usual CAD sense: one outer loop with holes in it, none crossing itself or another.
/// Other loops would include unintended areas.</summary>
/// <remarks>Loops are written inexactly and may touch. So only those stretches of a loop are decisive that are further than
/// <see cref="RegionTracer.GapMm"/> from anything they might cross. The winding numbers are constant along such a stretch, so one place
/// represents it: the same loops enclose it, and the loop itself winds once around one of its two sides.</remarks>
internal sealed class LoopNesting
{
    private const double NearMm = RegionTracer.GapMm;

    /// <summary>Sides of a loop closer than this along the loop meet at a corner.</summary>
    private const double CornerMm = 2 * NearMm;

    /// <summary>A stretch no longer than this, such as the tip of a spike, is due to inexact writing.</summary>
    private const double ShortMm = 2.5 * NearMm;

    private const int MostSides = 4 * ExchangeLimits.MaxLoopPoints;
    private const long MostLooks = 20_000_000;

    private readonly SplineSurface _surface;
    private readonly IReadOnlyList<IReadOnlyList<Point2>> _loops;
    private readonly Func<string, string, InputException> _fail;
    private readonly List<LoopSide> _sides = [];
    private readonly double[] _lengths;
    private readonly int[] _firsts;
    private readonly int _outer;

    /// <summary>Prepares the check of loops.</summary>
    /// <param name="surface">The surface.</param>
    /// <param name="loops">Polygons in its parameters, at least one.</param>
    /// <param name="fail">Creates an error from a code and a problem.</param>
    /// <exception cref="InputException">The loops are too long.</exception>
    public LoopNesting(SplineSurface surface, IReadOnlyList<IReadOnlyList<Point2>> loops, Func<string, string, InputException> fail)
    {
        (_surface, _loops, _fail) = (surface, loops, fail);
        (_lengths, _firsts) = (new double[loops.Count], new int[loops.Count + 1]);
        for (var loop = 0; loop < loops.Count; loop++)
        {
            for (var i = 0; i < loops[loop].Count; i++)
            {
                Divide(loop, i);
            }

            _firsts[loop + 1] = _sides.Count;
        }

        var areas = loops.Select(l => Math.Abs(RegionLoop.Area(l))).ToList();
        _outer = areas.IndexOf(areas.Max());
    }

    /// <summary>Throws if the loops are invalid.</summary>
    /// <exception cref="InputException">A loop crosses itself or another one, or they are not one outer loop with holes.</exception>
    public void Check()
    {
        var (tree, bands) = (new LoopSideTree(_sides), new RegionBands(_loops));
        var (near, turns) = (new List<int>(), new Dictionary<int, int>());
        var sides = CollectionsMarshal.AsSpan(_sides);
        var (own, others) = (new List<(double From, double To)>(), new List<(double From, double To)>());
        for (var loop = 0; loop < _loops.Count; loop++)
        {
            var (alone, apart) = (new LoopStretches(), new LoopStretches());
            for (var i = _firsts[loop]; i < _firsts[loop + 1]; i++)
            {
                tree.Near(i, NearMm, near);
                if (tree.Looks > MostLooks)
                {
                    throw _fail(
                        "too-large",
                        "the curves that limit the surface lie too close to one another, too many of them, to be told apart. Export the "
                            + "part that is cut as a surface of its own");
                }

                own.Clear();
                others.Clear();
                foreach (var k in near)
                {
                    ref readonly var side = ref sides[k];
                    if (side.Loop != loop && sides[i].Near(side.Start, side.End, NearMm) is { } other)
                    {
                        others.Add(other);
                    }
                    else if (side.Loop == loop && k != i && NearOwn(i, k) is { } at)
                    {
                        own.Add(at);
                    }
                }

                alone.Add(i, _sides[i].LengthMm, own);
                apart.Add(i, _sides[i].LengthMm, others);
            }

            Itself(loop, alone, bands, turns);
            Others(loop, apart, bands, turns);
        }
    }

    private void Divide(int loop, int index)
    {
        var polygon = _loops[loop];
        var places = LoopOnSurface.Side(_surface, polygon[index], polygon[(index + 1) % polygon.Count]);
        var start = _surface.PointAt(places[0].X, places[0].Y);
        for (var k = 1; k < places.Count; k++)
        {
            var end = _surface.PointAt(places[k].X, places[k].Y);
            _sides.Add(new(loop, index, places[k - 1], places[k], start, end, _lengths[loop]));
            _lengths[loop] += (end - start).Length;
            start = end;
        }

        if (_sides.Count > MostSides)
        {
            throw _fail("too-large", $"the limits of the surface take more than {MostSides} points");
        }
    }

    // Where a side is near another side of its loop, except at the corner between them.
    private (double From, double To)? NearOwn(int side, int other)
    {
        ref readonly var a = ref CollectionsMarshal.AsSpan(_sides)[side];
        ref readonly var b = ref CollectionsMarshal.AsSpan(_sides)[other];
        ref readonly var first = ref side < other ? ref a : ref b;
        ref readonly var second = ref side < other ? ref b : ref a;
        var between = second.AtMm - first.AtMm - first.LengthMm < CornerMm;
        var around = _lengths[a.Loop] - second.AtMm - second.LengthMm + first.AtMm < CornerMm;
        var (from, to) = Shares(a, side < other ? around : between, side < other ? between : around);
        var (otherFrom, otherTo) = Shares(b, side < other ? between : around, side < other ? around : between);
        return from <= to
            && otherFrom <= otherTo
            && a.Near(b.At(otherFrom), b.At(otherTo), NearMm) is { } at
            && Math.Max(at.From, from) is var least
            && Math.Min(at.To, to) is var most
            && least <= most
            ? (least, most)
            : null;

        static (double From, double To) Shares(in LoopSide side, bool cornerBefore, bool cornerBehind)
        {
            var share = side.LengthMm > NearMm ? NearMm / side.LengthMm : 1;
            return (cornerBefore ? share : 0, cornerBehind ? 1 - share : 1);
        }
    }

    // A loop winds once more around the left of a side than around its right, and never around the outside.
    private void Itself(int loop, LoopStretches stretches, RegionBands bands, Dictionary<int, int> turns)
    {
        var sense = Math.Sign(RegionLoop.Area(_loops[loop]));
        foreach (var (side, share) in stretches.Of(ShortMm))
        {
            Look(side, share, bands, turns);
            var (a, b) = (_loops[loop][_sides[side].Index], _loops[loop][(_sides[side].Index + 1) % _loops[loop].Count]);
            var beside = turns.GetValueOrDefault(loop);
            var beyond = beside + (b.Y != a.Y ? Math.Sign(b.Y - a.Y) : Math.Sign(a.X - b.X));
            if ((beside != 0 && beside != sense) || (beyond != 0 && beyond != sense))
            {
                throw _fail(
                    "bad-loop",
                    $"one of the limits crosses itself: at {Place(side, share)} it goes round the wrong way, or a second time. A loop "
                        + $"that goes round once is expected");
            }
        }
    }

    private void Others(int loop, LoopStretches stretches, RegionBands bands, Dictionary<int, int> turns)
    {
        var places = stretches.Of(0);
        if (_loops.Count == 1)
        {
            return;
        }

        if (places.Count == 0)
        {
            throw _fail("bad-loop", $"one of the limits, at {Place(_firsts[loop], 0)}, lies on others all the way. Each is expected once");
        }

        var inside = new Dictionary<int, List<int>>();
        for (var k = 0; k < places.Count; k++)
        {
            Look(places[k].Side, places[k].Share, bands, turns);
            foreach (var other in turns.Where(t => t.Value != 0 && t.Key != loop).Select(t => t.Key))
            {
                (CollectionsMarshal.GetValueRefOrAddDefault(inside, other, out _) ??= []).Add(k);
            }
        }

        foreach (var (other, which) in inside)
        {
            if (which.Count < places.Count)
            {
                var outside = places[Enumerable.Range(0, places.Count).First(k => k == which.Count || which[k] != k)];
                throw _fail(
                    "bad-loop",
                    $"the limits cross each other: one of them goes through {Place(places[which[0]].Side, places[which[0]].Share)} "
                        + $"inside of another one, and through {Place(outside.Side, outside.Share)} outside of it. An outer limit and "
                            + $"holes in it "
                        + $"are expected");
            }
        }

        if (loop != _outer && !inside.ContainsKey(_outer))
        {
            throw _fail(
                "bad-loop",
                $"one of the limits, through {Place(places[0].Side, places[0].Share)}, lies outside of the largest one. An outer limit "
                    + $"and holes in it are expected: export the part that is cut as a surface of its own");
        }

        if (inside.Keys.Any(o => o != _outer))
        {
            throw _fail(
                "bad-loop",
                $"one of the limits, through {Place(places[0].Side, places[0].Share)}, lies inside of a hole. An outer limit and holes "
                    + $"in it are expected: export the part that is cut as a surface of its own");
        }
    }

    private void Look(int side, double share, RegionBands bands, Dictionary<int, int> turns)
    {
        var at = _sides[side];
        bands.Turns(at.From.Lerp(at.To, share), at.Loop, at.Index, turns);
    }

    private string Place(int side, double share) => PlaceText.Triple(_sides[side].At(share));
}
