using System.Globalization;
using System.Text;
using System.Text.RegularExpressions;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>
/// LinuxCNC's own interpreter as the referee of displaced programs: it must accept the result, and the motions that it reads from it must
/// be the wanted ones, measured against lines and circles that this test builds from the motions it read before.
/// </summary>
public sealed partial class DisplacedProgramTests
{
    private static readonly int Seeds = Depth.Of(5, 15);

    [Theory]
    [InlineData(false, false, false, false, false)]
    [InlineData(true, false, false, false, false)]
    [InlineData(false, true, false, false, false)]
    [InlineData(true, true, false, false, false)]
    [InlineData(false, false, true, false, false)]
    [InlineData(true, false, true, false, false)]
    [InlineData(false, false, false, true, false)]
    [InlineData(true, false, false, true, false)]
    [InlineData(false, true, false, true, false)]
    [InlineData(false, false, false, false, true)]
    [InlineData(true, false, false, false, true)]
    [InlineData(false, true, false, true, true)]
    public void A_normal_displacement_is_what_rs274_cuts(
        bool incremental, bool byRadius, bool absoluteCenters, bool inch, bool computed)
    {
        Rs274.IsNeeded();
        for (var seed = 1; seed <= Seeds; seed++)
        {
            var contour = new DisplacedContour(seed, inch);
            var left = 0.05 + (0.01 * seed);
            left = seed % 2 == 0 ? left : -left;
            var spelled = contour.Spell(incremental, byRadius, absoluteCenters);
            var text = computed ? Computed(spelled) : spelled;
            var (before, after, result) = Displace(text, contour.Count, (p, blocks) => DisplacementWish.Normal(p, blocks, left));
            var worst = Tolerance(inch, byRadius);
            for (var i = 1; i < before.Count; i++)
            {
                var (b, a) = (before[i], after[i]);
                if (b.Line is not (> 100 and < 900))
                {
                    continue;
                }

                Assert.True(a.Kind == b.Kind, $"seed {seed}, N{b.Line}: {b.Kind} became {a.Kind}\n{result}");
                var off = b.Kind == MotionKind.Line
                    ? Math.Max(
                        Math.Abs(Beside(before[i - 1].End, b.End, after[i - 1].End) - left),
                        Math.Abs(Beside(before[i - 1].End, b.End, a.End) - left))
                    : OffCircle(before[i - 1], b, after[i - 1], a, left);
                Assert.True(off <= worst, $"seed {seed}, N{b.Line}: {off} mm off the wanted place\n{text}\n{result}");
            }

            Assert.True(
                (after[^1].End - before[^1].End).Length <= 0.5 * before[^1].ResolutionMm,
                $"seed {seed}: the program ends elsewhere\n{result}");
        }
    }

    [Theory]
    [InlineData(false, false, false, false)]
    [InlineData(true, false, false, false)]
    [InlineData(false, true, false, false)]
    [InlineData(false, false, true, false)]
    [InlineData(true, false, true, true)]
    [InlineData(false, true, false, true)]
    public void A_displacement_by_a_vector_is_what_rs274_cuts(bool incremental, bool byRadius, bool absoluteCenters, bool inch)
    {
        Rs274.IsNeeded();
        for (var seed = 1; seed <= Seeds; seed++)
        {
            var contour = new DisplacedContour(seed, inch);
            var by = new Vector3(0.02 * seed, -0.013 * seed, 0);
            var text = contour.Spell(incremental, byRadius, absoluteCenters);
            var (before, after, result) = Displace(text, contour.Count, (p, blocks) => DisplacementWish.EndsBy(p, blocks, by));
            foreach (var (b, a) in before.Zip(after))
            {
                var wanted = b.Line is > 100 and < 902 ? by : Vector3.Zero;
                Assert.True(
                    (a.End - b.End - wanted).Length <= Tolerance(inch, byRadius: false),
                    $"seed {seed}, N{b.Line}: ends at {a.End}, was {b.End}\n{text}\n{result}");
            }
        }
    }

    private static (
        IReadOnlyList<PeerMotion> Before,
        IReadOnlyList<PeerMotion> After,
        string Result) Displace(string text, int count, Func<NcPath, int[], Outcome<DisplacementWish>> wanted)
    {
        var path = NcInterpreter.Run(NcProgram.FromText(text, NcDialects.LinuxCnc.Syntax), NcDialects.LinuxCnc);
        var blocks = BlockSelector.Select(path.Program, [BlockSelector.Parse($"N101..N{100 + count}")]);
        Assert.True(blocks.IsUsable, blocks.Refusal?.Message);
        var wish = wanted(path, blocks.Result);
        Assert.True(wish.IsUsable, wish.Refusal?.Message);
        var rewrite = Rewriter.Apply(path, wish.Result);
        Assert.True(rewrite.IsUsable, $"{rewrite.Refusal?.Message}\n{text}");
        var result = Encoding.Latin1.GetString(rewrite.Result.Program.Bytes.Span);
        var (before, after) = (Rs274.Run(text), Rs274.Run(result));
        Assert.True(before.Refusal is null, $"rs274 refuses the original: {before.Refusal}\n{text}");
        Assert.True(after.Refusal is null, $"rs274 refuses the result: {after.Refusal}\n{result}");
        Assert.Equal(before.Motions.Count, after.Motions.Count);
        return (before.Motions, after.Motions, result);
    }

    // The written digits, and those that the peer prints of both programs.
    private static double Tolerance(bool inch, bool byRadius) => (inch ? 0.0040 : 0.0005) + (byRadius ? 0.002 : 0);

    // Distance of a point to the left of the line through two others.
    private static double Beside(Point3 from, Point3 to, Point3 point) =>
        Cross(Plane(to) - Plane(from), Plane(point) - Plane(from)) / (Plane(to) - Plane(from)).Length;

    // A displaced arc lies on the circle about the old center whose radius grew or shrank.
    private static double OffCircle(PeerMotion beforeStart, PeerMotion before, PeerMotion afterStart, PeerMotion after, double left)
    {
        var radius = Plane(beforeStart.End).DistanceTo(before.Center) + (before.Kind == MotionKind.ArcCounterClockwise ? -left : left);
        return Math.Max(
            Math.Abs(Plane(afterStart.End).DistanceTo(before.Center) - radius),
            Math.Abs(Plane(after.End).DistanceTo(before.Center) - radius));
    }

    private static Point2 Plane(Point3 p) => new(p.X, p.Y);

    private static double Cross(Vector2 a, Vector2 b) => (a.X * b.Y) - (a.Y * b.X);

    // The same places, which the control computes: as sums, differences and products with variables.
    private static string Computed(string program) =>
        "#1=7.25 #<half>=0.5\n" + Coordinate().Replace(program, m =>
        {
            var value = decimal.Parse(m.Groups["number"].Value, CultureInfo.InvariantCulture);
            var term = (m.Index % 4) switch
            {
                0 => string.Create(CultureInfo.InvariantCulture, $"[#1+{value - 7.25m}]"),
                1 => string.Create(CultureInfo.InvariantCulture, $"[{value + 7.25m}-#1]"),
                2 => string.Create(CultureInfo.InvariantCulture, $"[#<half>*{2 * value}]"),
                _ => string.Create(CultureInfo.InvariantCulture, $"[[#1 GT 8]+{value}]"),
            };
            return m.Groups["letter"].Value + term;
        });

    [GeneratedRegex(
        @"(?<=^N[1-8][0-9][0-9] .*)(?<letter>[XY])(?<number>-?[0-9.]+)", RegexOptions.Multiline | RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Coordinate();
}
