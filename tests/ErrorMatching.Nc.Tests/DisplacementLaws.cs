using System.Globalization;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>What holds for every displacement of every contour; seeded, so that a failure names its case.</summary>
public sealed class DisplacementLaws
{
    private const int Cases = 300;

    [Fact]
    public void Displacement_by_nothing_is_the_same_bytes() => ForAll((contour, seed) =>
    {
        var path = Bench.Read(contour.Spell(seed % 2 == 0, byRadius: seed % 3 == 0));
        Assert.Same(path.Program, Bench.Rewritten(path, DisplacementWish.Normal(path, Named(path, contour), 0).Result!).Program);
        Assert.Same(path.Program, Bench.Rewritten(path, DisplacementWish.EndsBy(path, Named(path, contour), Vector3.Zero).Result!).Program);
    });

    [Theory]
    [InlineData("G17", false)]
    [InlineData("G18", false)]
    [InlineData("G19", false)]
    [InlineData("G17", true)]
    public void Result_is_proved_or_refused(string plane, bool byRadius)
    {
        var refused = 0;
        ForAll((contour, seed) =>
        {
            var path = Bench.Read(contour.Spell(seed % 2 == 0, plane, byRadius));
            refused += TryDisplace(path, DisplacementWish.Normal(path, Named(path, contour), Distance(contour)).Result!) is null ? 1 : 0;
        });
        Assert.InRange(refused, 0, Cases / 20);
    }

    [Fact]
    public void Elements_lie_where_they_were_wanted()
    {
        // The judge is the distance of points of the new path from the old one: every named element is |d| away, on the wished side.
        ForAll((contour, seed) =>
        {
            var (path, d) = (Bench.Read(contour.Spell(seed % 2 == 0)), Distance(contour));
            var named = Named(path, contour);
            if (TryDisplace(path, DisplacementWish.Normal(path, named, d).Result!) is not { } rewrite)
            {
                return;
            }

            var now = NcInterpreter.Run(rewrite.Program, path.Dialect);
            foreach (var block in named)
            {
                var (was, moved) = (path.Motions[path.MotionOf(block)], now.Motions[path.MotionOf(block)]);
                foreach (var fraction in (double[])[0, 0.25, 0.5, 0.75, 1])
                {
                    var p = moved.PlaneAt(fraction);
                    var left = was.IsArc
                        ? (was.Kind == MotionKind.ArcCounterClockwise ? -1 : 1) * was.Arc.Circle.SignedDistance(p)
                        : was.Segment.Line.SignedDistance(p);
                    Assert.Equal(d, left, 0.0022);
                }
            }
        });
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Spelling_of_a_contour_makes_no_difference_to_where_it_goes(bool byRadius) => ForAll((contour, seed) =>
    {
        var (iso, siemens, d) = (
            Bench.Read(contour.Spell(seed % 2 == 0, byRadius: byRadius)),
            Bench.Read(contour.SpellSiemens(byRadius), NcDialects.Siemens840D),
            Distance(contour));
        var (a, b) = (
            TryDisplace(iso, DisplacementWish.Normal(iso, Named(iso, contour), d).Result!),
            TryDisplace(siemens, DisplacementWish.Normal(siemens, Named(siemens, contour), d).Result!));
        Assert.Equal(a is null, b is null);
        if (a is null || b is null)
        {
            return;
        }

        var (one, other) = (NcInterpreter.Run(a.Program, iso.Dialect).Motions, NcInterpreter.Run(b.Program, siemens.Dialect).Motions);
        for (var i = 0; i < contour.Count + 3; i++)
        {
            Assert.Equal(one[i].Kind, other[i].Kind);
            Assert.InRange((one[i].End - other[i].End).Length, 0, 1e-9);
            Assert.InRange(one[i].IsArc ? one[i].Arc.Middle.DistanceTo(other[i].Arc.Middle) : 0, 0, 0.001);
        }
    });

    [Fact]
    public void Displacement_there_and_back_restores_the_motions() => ForAll((contour, _) =>
    {
        var (path, d) = (Bench.Read(contour.Spell()), Distance(contour));
        if (TryDisplace(path, DisplacementWish.Normal(path, Named(path, contour), d).Result!) is not { } there)
        {
            return;
        }

        var moved = NcInterpreter.Run(there.Program, path.Dialect);
        if (TryDisplace(moved, DisplacementWish.Normal(moved, Named(path, contour), -d).Result!) is not { } back)
        {
            return;
        }

        var restored = NcInterpreter.Run(back.Program, path.Dialect);
        for (var i = 0; i < path.Motions.Length; i++)
        {
            Assert.InRange((restored.Motions[i].End - path.Motions[i].End).Length, 0, 0.002 * Math.Sqrt(2));
        }
    });

    [Fact]
    public void Increments_and_positions_of_one_path_are_displaced_to_the_same_motions() => ForAll((contour, seed) =>
    {
        var d = Distance(contour);
        var results = new[] { false, true }.Select(incremental =>
        {
            var path = Bench.Read(contour.Spell(incremental));
            var wish = seed % 2 == 0
                ? DisplacementWish.Normal(path, Named(path, contour), d).Result!
                : DisplacementWish.EndsBy(path, Named(path, contour), new(d, -d / 2, d / 4)).Result!;
            return TryDisplace(path, wish) is { } rewrite ? NcInterpreter.Run(rewrite.Program, path.Dialect) : null;
        }).ToArray();
        Assert.Equal(results[0] is null, results[1] is null);
        for (var i = 0; i < (results[0]?.Motions.Length ?? 0); i++)
        {
            var (a, b) = (results[0]!.Motions[i], results[1]!.Motions[i]);
            Assert.Equal((a.Kind, 0.0, 0.0), (b.Kind, Math.Round((a.End - b.End).Length, 9), Math.Round(a.Center.DistanceTo(b.Center), 9)));
        }
    });

    [Fact]
    public void Moved_end_points_are_proved_or_refused_and_go_back()
    {
        var refused = 0;
        for (var seed = 1; seed <= Cases; seed++)
        {
            var contour = new RandomContour(seed, onlyLines: seed % 2 == 0);
            var path = Bench.Read(contour.Spell(seed % 4 < 2));
            var by = new Vector3(contour.Uniform(-0.3, 0.3), contour.Uniform(-0.3, 0.3), contour.Uniform(-0.1, 0.1));
            var named = Named(path, contour);
            if (TryDisplace(path, DisplacementWish.EndsBy(path, named, by).Result!) is not { } there)
            {
                refused++;
                continue;
            }

            var moved = NcInterpreter.Run(there.Program, path.Dialect);
            if (TryDisplace(moved, DisplacementWish.EndsBy(moved, named, by * -1).Result!) is { } back)
            {
                var restored = NcInterpreter.Run(back.Program, path.Dialect);
                for (var i = 0; i < path.Motions.Length; i++)
                {
                    Assert.Equal(0, (restored.Motions[i].End - path.Motions[i].End).Length, 1e-9);
                }
            }
        }

        Assert.InRange(refused, 0, Cases / 20);
    }

    [Fact]
    public void Any_choice_of_blocks_is_proved_or_refused()
    {
        var refused = 0;
        ForAll((contour, seed) =>
        {
            var path = Bench.Read(contour.Spell(seed % 2 == 0, byRadius: seed % 3 == 0));
            var named = Enumerable.Range(1, contour.Count)
                .Where(_ => contour.Uniform(0, 1) < 0.5)
                .DefaultIfEmpty(1)
                .SelectMany(n => Bench.Blocks(path, "N" + n.ToString(CultureInfo.InvariantCulture)))
                .ToArray();
            refused += TryDisplace(path, DisplacementWish.Normal(path, named, Distance(contour)).Result!) is null ? 1 : 0;
            TryDisplace(path, DisplacementWish.EndsBy(path, named, new(Distance(contour), Distance(contour), 0)).Result!);
        });
        Assert.InRange(refused, 0, Cases / 20);
    }

    [Fact]
    public void Corners_of_every_angle_are_proved_or_refused()
    {
        var refused = 0;
        for (var seed = 1; seed <= 3 * Cases; seed++)
        {
            var contour = new RandomContour(seed, anyCorner: true);
            var path = Bench.Read(contour.Spell(seed % 2 == 0, byRadius: seed % 3 == 0));
            refused += TryDisplace(path, DisplacementWish.Normal(path, Named(path, contour), Distance(contour)).Result!) is null ? 1 : 0;
        }

        Assert.InRange(refused, 1, Cases);
    }

    [Fact]
    public void Any_part_of_a_closed_polygon_leaves_it_closed()
    {
        for (var seed = 1; seed <= Cases; seed++)
        {
            var random = new RandomContour(seed);
            var corners = 3 + (int)random.Uniform(0, 6);
            var turn = random.Uniform(0, 2 * Math.PI);
            var places = Enumerable.Range(0, corners + 1)
                .Select(
                    i => Vector2.FromDirection(Angle.FromRadians(turn + (i % corners * 2 * Math.PI / corners))) * random.Uniform(19, 21))
                .ToArray();
            places[^1] = places[0];
            var text = "G90 G17 G21\n"
                + string.Concat(places.Select(
                    (p, i) => string.Create(
                        CultureInfo.InvariantCulture, $"N{i} {(i == 0 ? "G0" : "G1")} X{p.X:0.0##} Y{p.Y:0.0##} Z0. F100\n")))
                + "G0 Z50.\nM30\n";
            var path = Bench.Read(text);
            var first = 1 + (int)random.Uniform(0, corners);
            var last = first + (int)random.Uniform(0, corners - first + 1);
            var named = Bench.Blocks(path, string.Create(CultureInfo.InvariantCulture, $"N{first}..N{Math.Min(last, corners)}"));
            var rewrite = Bench.Rewritten(path, DisplacementWish.Normal(path, named, Distance(random)).Result!);
            var now = NcInterpreter.Run(rewrite.Program, path.Dialect).Motions;
            Assert.Equal(0, (now[0].End - now[corners].End).Length, 1e-9);
            Assert.Equal(50, now[^1].End.Z);
        }
    }

    private static void ForAll(Action<RandomContour, int> law)
    {
        for (var seed = 1; seed <= Cases; seed++)
        {
            try
            {
                law(new(seed), seed);
            }
            catch (Exception e)
            {
                throw new InvalidOperationException($"Contour {seed}:\n{new RandomContour(seed).Spell()}", e);
            }
        }
    }

    private static double Distance(RandomContour contour) => Math.Round(contour.Uniform(-0.3, 0.3), 4);

    private static int[] Named(NcPath path, RandomContour contour)
    {
        var first = 1 + (contour.Count / 4);
        return Bench.Blocks(path, string.Create(CultureInfo.InvariantCulture, $"N{first}..N{Math.Max(first, contour.Count - 1)}"));
    }

    private static Rewrite? TryDisplace(NcPath path, DisplacementWish wish)
    {
        var rewrite = Rewriter.Apply(path, wish);
        return rewrite.IsUsable ? Bench.Rewritten(path, wish) : null;
    }
}
