namespace ErrorMatching.EndToEnd.Tests;

public sealed class RandomPartsTests
{
    /// <summary>What whole micrometers in end points, centers and radii and the chords of a wave can add up to, mm.</summary>
    private const double Rounding = 0.0015;

    private static readonly IReadOnlyList<RandomPart> Parts = [.. Enumerable.Range(0, 600).Select(RandomParts.Generate)];

    [Fact]
    public void Undisplaced_program_leaves_every_key_point_on_the_boundary() =>
        Assert.Empty(Beyond(Rounding, part => Cut(part, part.ToolRadius), _ => 0));

    // Which side the material is on, for every feature: more tool takes more of it.
    [Fact]
    public void Larger_tool_takes_its_growth_off_every_key_point() =>
        Assert.Empty(Beyond(Rounding, part => Cut(part, part.ToolRadius + 0.1), part => part.Flavor.Compensated ? 0 : -0.1));

    [Fact]
    public void Same_number_gives_the_same_part()
    {
        var (once, again) = (RandomParts.Generate(7), RandomParts.Generate(7));

        Assert.Equal(once.Program, again.Program);
        Assert.Equal(once.KeyPoints, again.KeyPoints);
        Assert.NotEqual(once.Program, RandomParts.Generate(8).Program);
    }

    [Fact]
    public void Every_flavor_meets_every_feature_it_can_have()
    {
        // Three contours, material left or right, G90 or G91, center or radius, compensated or not.
        Assert.Equal(3 * 2 * 2 * 2 * 2, Parts.Select(p => p.Flavor).Distinct().Count());
        var met = Parts.SelectMany(p => p.Features.Select(
            f => (p.Flavor.Contour, p.Flavor.MaterialLeft, p.Flavor.Compensated, f.Kind, f.Shape))).Distinct();
        Assert.Equal((4 + 3 + 3) * 2 * 2, met.Count());
        Assert.Equal(["none", "x", "y"], Parts.Select(p => p.Frame.Mirror).Distinct().Order(StringComparer.Ordinal));
    }

    [Fact]
    public void Programs_use_the_words_of_their_flavor()
    {
        foreach (var part in Parts)
        {
            var moves = RefereeInterpreter.Run(part.Program);
            var side = part.Flavor.MaterialLeft ? CutterSide.Right : CutterSide.Left;

            Assert.Equal(part.Flavor.Incremental, part.Program.Contains("G91", StringComparison.Ordinal));
            Assert.Equal(part.Flavor.Compensated ? [CutterSide.None, side] : [CutterSide.None], moves.Select(m => m.Side).Distinct());
        }
    }

    [Fact]
    public void Features_name_their_blocks_and_share_none()
    {
        foreach (var part in Parts)
        {
            var order = RefereeInterpreter.Run(part.Program).Select(m => m.Block).ToList();
            var last = -1;
            foreach (var (first, end) in part.Features.Select(f => f.Blocks.Split("..")).Select(
                b => (order.IndexOf(b[0]), order.IndexOf(b[^1]))))
            {
                Assert.True(first > last && end >= first, $"part {part.Seed}");
                last = end;
            }
        }
    }

    [Fact]
    public void Actual_points_lie_off_the_nominal_ones_by_the_deviation_in_the_part_frame()
    {
        foreach (var (part, point) in Parts.SelectMany(part => part.KeyPoints.Select(p => (part, p))))
        {
            Assert.InRange((part.Frame.ToProgram(point.Theoretical) - point.Place).Length, 0, 1e-9);
            Assert.InRange((part.Frame.ToProgram(point.Actual) - point.Place - (point.Normal * point.Deviation)).Length, 0, 1e-9);
            Assert.InRange((point.Actual - point.Theoretical).Length, 0, 0.45);
            Assert.Equal(1, point.Normal.Length, 9);
        }
    }

    // Frames written out by hand: (3, 4) mirrored, then turned by 90 degrees, then moved by (10, 20).
    [Theory]
    [InlineData("none", 6, 23)]
    [InlineData("x", 6, 17)]
    [InlineData("y", 14, 23)]
    public void Frame_mirrors_then_turns_then_moves(string mirror, double u, double v)
    {
        var there = new RandomFrame(mirror, 90, new(10, 20)).ToProgram(new(3, 4));

        Assert.Equal(u, there.U, 12);
        Assert.Equal(v, there.V, 12);
    }

    [Fact]
    public void Straight_features_stay_straight()
    {
        foreach (var group in Groups("straight"))
        {
            var axis = (group[^1].Actual - group[0].Actual).Unit();
            Assert.All(group, p => Assert.InRange(Math.Abs(axis.Cross(p.Actual - group[0].Actual)), 0, 1e-9));
        }
    }

    [Fact]
    public void Arcs_stay_arcs()
    {
        foreach (var group in Groups("arc"))
        {
            var center = Circumcenter(group[0].Actual, group[group.Count / 2].Actual, group[^1].Actual);
            var radius = (group[0].Actual - center).Length;
            Assert.All(group, p => Assert.InRange(Math.Abs((p.Actual - center).Length - radius), 0, 1e-9));
        }
    }

    private static IEnumerable<IReadOnlyList<RandomKeyPoint>> Groups(string shape) =>
        Parts.SelectMany(p => p.Features).Where(f => f.Shape == shape).SelectMany(f => f.Groups);

    private static Flat Circumcenter(Flat a, Flat b, Flat c)
    {
        var (p, q) = (b - a, c - a);
        var twice = 2 * p.Cross(q);
        return a + new Flat(((q.V * p.Dot(p)) - (p.V * q.Dot(q))) / twice, ((p.U * q.Dot(q)) - (q.U * p.Dot(p))) / twice);
    }

    private static List<string> Beyond(double limit, Func<RandomPart, VirtualCut> cut, Func<RandomPart, double> wanted) =>
    [
        .. from part in Parts
           let piece = cut(part)
           from feature in part.Features
           from point in feature.KeyPoints
           let found = piece.Probe(point.Place, point.Normal)
           where !(Math.Abs(found - wanted(part)) <= limit)
           select FormattableString.Invariant(
               $"part {part.Seed}, {part.Flavor}, {feature.Kind} {feature.Shape}, point {point.Label}: {found:R}"),
    ];

    private static VirtualCut Cut(RandomPart part, double toolRadius) => new(RefereeInterpreter.Run(part.Program), toolRadius);
}
