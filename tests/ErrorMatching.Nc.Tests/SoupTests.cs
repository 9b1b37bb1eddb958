using ErrorMatching.Refusals;
using ErrorMatching.Testing;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Nc.Tests;

/// <summary>Programs that no CAM would post: whatever stands in them, they are displaced with a proof, or refused, or the proof fails.
/// Nothing throws.</summary>
public sealed class SoupTests
{
    private static readonly string[] Words =
    [
        "G0", "G1", "G2", "G3", "G17", "G18", "G19", "G20", "G21", "G28", "G40", "G41", "G42", "G43 H1", "G4", "G52", "G53", "G54", "G55",
        "G68", "G69", "G80", "G81", "G90", "G91", "G92", "G98", "G90.1", "G91.1", "G38.2", "G33",
        "X0", "X1.", "X-2.5", "X10.", "Y0", "Y3.", "Y-4.25", "Y10", "Z0", "Z5.", "Z-1.", "I0", "I1.", "I-5.", "J0", "J2.5", "J5.", "K1.",
        "K-5", "R5.", "R-5.", "R.5", "F100", "S500", "T1", "M3", "M98 P1", "M30", "P2",
        "#100=1", "X#100", "Y[1+2]", "A5.", "E1", ",R2.", "(c)", ";c", "/", "%", "$", "O100", "GOTO10", "X=5", "CR=5",
    ];

    private static readonly Gen<string> Line = Gen.Frequency(
        (3, Gen.Elements(Words).ListOf(3).Select(w => string.Join(' ', w))),
        (2, Gen.Elements(Words).ListOf(6).Select(w => string.Concat(w))),
        (
            4,
            Gen.Elements(
                "G1 X{0} Y{1}",
                "X{0}",
                "Y{1}",
                "G2 X{0} Y{1} R9.",
                "G3 X{0} Y{1} I{1} J{0}",
                "G0 X{0} Y{1} Z5.",
                "G1 Z-1.",
                "G3 I{0}",
                "G91 G1 X{0}",
                "G90").Zip(Gen.Choose(-9, 9).Two())
            .Select(
                p => p.Item1.Replace("{0}", p.Item2.Item1 + ".", StringComparison.Ordinal).Replace(
                    "{1}", p.Item2.Item2 + ".5", StringComparison.Ordinal))));

    private static readonly Gen<string> Program = Line.ArrayOf().Select(
        lines => "G90 G17 G21 G40 G0 X0 Y0 Z0\n" + string.Join('\n', lines) + "\n");

    [Fact]
    public void Nothing_throws_and_what_is_rewritten_reads_as_the_same_blocks() =>
        Check.One(
            Config.QuickThrowOnFailure.WithMaxTest(Depth.Of(4000, 20_000)).WithEndSize(40),
            Prop.ForAll(Program.Zip(Gen.Choose(0, NcDialects.Names.Count - 1).Zip(Gen.Choose(-30, 30))).ToArbitrary(), p =>
        {
            var path = Bench.Read(p.Item1, NcDialects.All[p.Item2.Item1]);
            var blocks = Enumerable.Range(1, path.Program.BlockCount - 1).Where(b => b % 3 != p.Item2.Item1).ToArray();
            var d = p.Item2.Item2 / 100.0;
            foreach (var wish in (Outcome<DisplacementWish>[])[
                DisplacementWish.Normal(path, blocks, d), DisplacementWish.EndsBy(path, blocks, new(d, -d, d / 2))])
            {
                if (wish.IsUsable && Rewriter.Apply(path, wish.Result) is { IsUsable: true, Result: var rewrite })
                {
                    Prover.Check(path, rewrite.Program, wish.Result, rewrite.LeastIncrementMm);
                    Assert.Equal(path.Program.BlockCount, rewrite.Program.BlockCount);
                }
            }

            return true;
        }));

    [Fact]
    public void Any_bytes_are_interpreted_in_every_dialect() =>
        Check.One(
            Config.QuickThrowOnFailure.WithMaxTest(Depth.Of(1000, 5000)),
            Prop.ForAll(Gen.Choose(0, 255).Select(n => (byte)n).ArrayOf().ToArbitrary(), bytes =>
        {
            foreach (var dialect in NcDialects.All)
            {
                NcInterpreter.Run(NcProgram.Read(bytes), dialect);
            }

            return true;
        }));
}
