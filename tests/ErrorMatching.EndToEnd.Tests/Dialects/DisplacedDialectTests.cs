using System.Text;
using ErrorMatching.Nc;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>Random programs of each dialect, displaced and proved, and then judged by the referee's interpreter, which shares nothing with
/// the product: the named blocks are displaced as wished, and all others cut as before.</summary>
public sealed class DisplacedDialectTests
{
    private const int Programs = 200;

    // Whole micrometers of end points, centers and radii.
    private const double Rounding = 0.0025;

    public static TheoryData<string> Names => [.. DialectSpelling.All.Select(s => s.Name)];

    [Theory]
    [MemberData(nameof(Names))]
    public void Displaced_programs_are_what_was_wished(string name)
    {
        var spelling = DialectSpelling.All.Single(s => s.Name == name);
        var (dialect, worst) = (NcDialects.Named(name), 0.0);
        for (var seed = 1; seed <= Programs; seed++)
        {
            var program = new DialectProgram(spelling, seed);
            var path = NcInterpreter.Run(NcProgram.FromText(program.Text, dialect.Syntax), dialect);
            Assert.True(path.Refusal is null, $"seed {seed}: {path.Refusal}\n{program.Text}");
            Assert.Empty(path.Problems);
            var first = 100 * program.Displaced;
            var blocks = BlockSelector.Parse($"N{first + 1}..N{first + program.Blocks[program.Displaced]}");
            var named = BlockSelector.Select(path.Program, [blocks]);
            var wish = DisplacementWish.Normal(path, named.Result!, program.Left);
            Assert.True(wish.IsUsable, $"seed {seed}: {wish.Refusal}\n{program.Text}");
            var rewrite = Rewriter.Apply(path, wish.Result);
            Assert.True(rewrite.IsUsable, $"seed {seed}: {rewrite.Refusal}\n{program.Text}");
            var proof = Prover.Check(path, rewrite.Result.Program, wish.Result, rewrite.Result.LeastIncrementMm);
            Assert.True(proof.Holds, $"seed {seed}: {string.Join("\n", proof.Failures)}");
            worst = Math.Max(worst, Judge(spelling, program, Encoding.Latin1.GetString(rewrite.Result.Program.Bytes.Span), seed));
        }

        Assert.InRange(worst, 0, Rounding);
    }

    // The largest distance from what was wished, mm.
    private static double Judge(DialectSpelling spelling, DialectProgram program, string result, int seed)
    {
        var before = RefereeInterpreter.Run(spelling.ForReferee(program.Text));
        var after = RefereeInterpreter.Run(spelling.ForReferee(result));
        Assert.Equal(before.Select(m => (m.Block, m.Rapid, m.IsArc)), after.Select(m => (m.Block, m.Rapid, m.IsArc)));
        var (worst, judged) = (0.0, 0);
        var ring = $"N{program.Displaced}";
        for (var i = 0; i < before.Count; i++)
        {
            var (b, a) = (before[i], after[i]);
            if (b.Block.Length == 4 && b.Block.StartsWith(ring, StringComparison.Ordinal))
            {
                judged++;
                worst = Math.Max(worst, b.IsArc ? OffCircle(b, a, program.Left) : OffLine(b, a, program.Left));
            }
            else if (b.Block.Length == 4)
            {
                worst = Math.Max(worst, (b.To.In(b.Plane) - a.To.In(a.Plane)).Length + (b.From.In(b.Plane) - a.From.In(a.Plane)).Length);
            }
        }

        Assert.Equal(program.Blocks[program.Displaced], judged);
        Assert.True(worst <= Rounding, $"seed {seed}: {worst} mm off\n{program.Text}\n{result}");
        return worst;
    }

    private static double OffLine(RefereeMove b, RefereeMove a, double left)
    {
        var along = (b.To.In(b.Plane) - b.From.In(b.Plane)).Unit();
        return new[] { a.From, a.To }.Max(p => Math.Abs(along.Cross(p.In(b.Plane) - b.From.In(b.Plane)) - left));
    }

    private static double OffCircle(RefereeMove b, RefereeMove a, double left)
    {
        var radius = b.Radius - (Math.Sign(b.Sweep) * left);
        return new[] { a.From, a.To }.Max(p => Math.Abs((p.In(b.Plane) - b.Center).Length - radius))
            + (Math.Sign(a.Sweep) == Math.Sign(b.Sweep) ? Math.Abs(a.Radius - radius) : double.PositiveInfinity);
    }
}
