using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Nc.Tests;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>LinuxCNC's own interpreter as the referee of contours to which upright arcs lead (G18, G19): where the contour moves, each arc
/// goes along with its start, its end and its center, in all three coordinates, and is still an arc of its radius in its plane.</summary>
public sealed class DisplacedLeadTests
{
    private static readonly int Seeds = Depth.Of(4, 8);

    // The words' rounding, and the digits that the peer prints of both programs.
    private const double Tolerance = 0.0007;

    [Theory]
    [InlineData(false, "", false)]
    [InlineData(true, "", false)]
    [InlineData(false, "R", false)]
    [InlineData(false, "", true)]
    [InlineData(true, "R", true)]
    public void A_lead_goes_along_as_rs274_cuts_it(bool incremental, string radius, bool byVector)
    {
        Rs274.IsNeeded();
        for (var seed = 1; seed <= Seeds; seed++)
        {
            var contour = new LedContour(seed);
            var text = contour.Spell(incremental, radius);
            var left = (seed % 2 == 0 ? 1 : -1) * (0.03 + (0.01 * seed));
            var (before, after, result) = Displace(text, p => byVector
                ? DisplacementWish.EndsBy(p, Named(p, "N5..N201"), new(left, -left / 3, left / 4))
                : DisplacementWish.Normal(p, Named(p, $"N101..N{100 + contour.Count}"), left));
            for (var i = 1; i < before.Count; i++)
            {
                var (was, now, why) = (before[i], after[i], $"seed {seed}, N{before[i].Line}\n{text}\n{result}");
                Assert.True((was.Kind, was.Plane, was.Turns) == (now.Kind, now.Plane, now.Turns), why);
                if (was.Line is 5 or 201)
                {
                    var moved = now.End - was.End;
                    Assert.True((after[i - 1].End - before[i - 1].End - moved).Length <= Tolerance, why);
                    Assert.True(
                        (now.Plane.Project(default(Point3) + moved) - Point2.Origin - (now.Center - was.Center)).Length <= Tolerance, why);
                    Assert.True(moved.Length >= Math.Abs(left) / 2, why);
                    Assert.True(byVector || Math.Abs(moved.Z) <= Tolerance, why);
                }
                else if (was.Line is > 100 and < 200 && !byVector)
                {
                    Assert.True(Math.Abs(Beside(before[i - 1].End, was.End, after[i - 1].End) - left) <= Tolerance, why);
                    Assert.True(Math.Abs(Beside(before[i - 1].End, was.End, now.End) - left) <= Tolerance, why);
                }
                else if (was.Line is > 100 and < 200)
                {
                    Assert.True((now.End - was.End - new Vector3(left, -left / 3, left / 4)).Length <= Tolerance, why);
                }
            }

            Assert.True((after[^1].End - before[^1].End).Length <= Tolerance, $"seed {seed}: it ends elsewhere\n{result}");
        }
    }

    private static int[] Named(NcPath path, string blocks) =>
        BlockSelector.Select(path.Program, [BlockSelector.Parse(blocks)]).Result ?? throw new InvalidOperationException(blocks);

    private static (IReadOnlyList<PeerMotion> Before, IReadOnlyList<PeerMotion> After, string Result) Displace(
        string text, Func<NcPath, Outcome<DisplacementWish>> wanted)
    {
        var path = NcInterpreter.Run(NcProgram.FromText(text, NcDialects.LinuxCnc.Syntax), NcDialects.LinuxCnc);
        var wish = wanted(path);
        Assert.True(wish.IsUsable, wish.Refusal?.Message);
        var rewrite = Rewriter.Apply(path, wish.Result);
        Assert.True(rewrite.IsUsable, $"{rewrite.Refusal?.Message}\n{text}");
        Assert.Empty(Prover.Check(path, rewrite.Result.Program, wish.Result, rewrite.Result.LeastIncrementMm).Failures);
        var result = Encoding.Latin1.GetString(rewrite.Result.Program.Bytes.Span);
        var (before, after) = (Rs274.Run(text), Rs274.Run(result));
        Assert.True(before.Refusal is null, $"rs274 refuses the original: {before.Refusal}\n{text}");
        Assert.True(after.Refusal is null, $"rs274 refuses the result: {after.Refusal}\n{result}");
        Assert.Equal(before.Motions.Count, after.Motions.Count);
        return (before.Motions, after.Motions, result);
    }

    private static double Beside(Point3 from, Point3 to, Point3 point)
    {
        var (x, y) = (to.X - from.X, to.Y - from.Y);
        return ((x * (point.Y - from.Y)) - (y * (point.X - from.X))) / Math.Sqrt((x * x) + (y * y));
    }
}
