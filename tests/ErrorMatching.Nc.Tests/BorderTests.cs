using System.Globalization;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Nc.Tests;

/// <summary>
/// A result is interpreted only where it is not what the original was; it must come out as if every block were. Borders between stretches
/// lie every 512 blocks, motions in pieces of 8192.
/// </summary>
public sealed class BorderTests
{
    private const int Border = 1024;

    private static readonly string[] Cuts =
    [
        "G1 X{0}.5 Y{1}.25", "G1 X{0}.5 Y{1}.25", "G1 X{1}.5", "G1 Y{0}.125 Z-{1}.5", "G0 X{0}. Y{1}. Z5.", "G1 X{0}. F{1}00.", "F{0}5.",
        "G2 X{0}. Y{1}. R90.", "G3 I{1}.5 J1.", "G1 X{0} Y{1}", "N{0}{1} G1 Z-{1}.",
    ];

    // What a control goes on from with plain cuts, and what it mostly does not.
    private static readonly string[] Others =
    [
        "(A COMMENT)", "", "X{0}. Y{1}.", "G91", "G90 X{0}. Y{1}. Z{1}.", "G18", "G17", "G20", "G21", "G54", "G55", "G92 X{0}. Y0. Z1.",
        "G52 X{1}.", "G10 L2 P1 X{0}.", "M6 T1", "#1=#1+1", "G93", "G94", "G4 P1", "G4 X2", "G64", "G90.1", "G91.1",
        "G3 X{0}. Y{1}. I{1}. J1.", "G40 G90 G17 G21 G80 G69 G94",
    ];

    private static readonly string[] Odd =
    [
        "G41 D1", "G40", "G92.1", "G68 X0. Y0. R3{1}.", "G69", "G81 X{0}. Y{1}. Z-1. R1.", "G80", "G28 X0. Y0.", "G43 H1", "G49", "M98 P77",
        "M30", "X#1", "G1 X{0}. ,R1.", "G1 Q{0}", "G777", "/G91", "G1 X{0}. Y{1}. A3.",
        "GOTO 9", "WHILE [#1 LT 3] DO1", "END1",
    ];

    [Fact]
    public void A_result_comes_out_as_if_every_block_were_interpreted() =>
        Check.One(Config.QuickThrowOnFailure.WithMaxTest(200), Prop.ForAll(Gen.Choose(1, 1_000_000).ToArbitrary(), seed =>
        {
            var random = new Sequence(seed);
            var dialect = random.Next(3) == 0 ? NcDialects.LinuxCnc : NcDialects.FanucMill;
            var lines = Program(random, 512 * (2 + random.Next(5)) + random.Next(3) - 1, othersAt: random.Next(4) == 0 ? 50 : 900);
            var path = NcInterpreter.Run(NcProgram.FromText(string.Join('\n', lines)), dialect);
            for (var i = random.Next(4); i >= 0; i--)
            {
                var at = Math.Clamp(
                    random.Next(3) == 0 ? random.Next(lines.Count) : (512 * random.Next(7)) + random.Next(5) - 2, 0, lines.Count - 1);
                lines[at] = random.Line(random.Next(2) == 0 ? Cuts : random.Next(4) == 0 ? Odd : Others);
                if (random.Next(12) == 0)
                {
                    lines.Insert(at, "(A MARKER)");
                }
            }

            AssertSame(NcProgram.FromText(string.Join('\n', lines)), path);
        }));

    /// <summary>Blocks of the original by their positions, and what is done to the result, which reaches past the border at 1024.</summary>
    public static TheoryData<string, string> Reaches => new()
    {
        { "700=G52 X1. (SHIFT)", "600=G1 X0.001" },
        { "700=G52 X1.", "600=G1 X0.001" },
        { "700=M6 T1", "600=G1 X0.001" },
        { "1022=G1 X5. F500.;1023=F500.", "1022=G1 X5. F600." },
        { "1022=G1 X0. Y0. Z0.;1023=G92 X0. Y0. Z0.", "1022=G1 X5. Y0. Z0." },
        { "1022=G1 X5. Y0. Z0.;1023=G92 X0. Y0. Z0.", "600=G1 X0.001" },
        { "1010=F500.", "1010=G1 X0.001" },
        { "2000=G1 X5 Y5.", "600=G1 X0.001" },
        { "600=G1 X6 Y5.;2000=G1 X5 Y5.", "600=G1 X6. Y5." },
        { "1023=G1 X9. Y9.", "1023=G1 X9. Y9. ,R0.001" },
        { "700=#1=0;701=WHILE [#1 LT 3] DO1;2200=#1=#1+1;2201=END1", "600=G1 X0.001" },
        { "700=#1=0;701=WHILE [#1 LT 3] DO1;2200=#1=#1+1;2201=END1", "2100=G1 X0.001" },
        { "700=GOTO 2000;2000=N2000 G1 X1.", "600=G1 X0.001" },
        { "100=F500.;1100=F700.;2048=G1 X1. F500.", "2100=G1 X0.001" },
        { "1100=G2 X9. Y9. R900.;2600=G3 X9. Y9. R900.", "600=G2 X9. Y9. R900." },
        { "1100=G2 X9. Y9. R900.;2600=G3 X9. Y9. R900.", "600=G1 X9. Y9." },
        { "1100=G2 X9. Y9. R0.1", "600=G1 X9. Y9." },
    };

    [Theory]
    [MemberData(nameof(Reaches))]
    public void What_reaches_past_a_border_is_seen_behind_it(string original, string damage)
    {
        var lines = Enumerable.Range(0, 3_000)
            .Select(i => i == 0 ? "G21 G17 G40 G90 G54" : Text($"G1 X{i % 2}.25 Y{i % 3}.25 Z-1."))
            .ToArray();
        Set(lines, original);
        var path = Bench.Read(string.Join('\n', lines), NcDialects.FanucMill);
        Set(lines, damage);
        AssertSame(NcProgram.FromText(string.Join('\n', lines)), path);
    }

    private static void Set(string[] lines, string blocks)
    {
        foreach (var (at, text) in blocks.Split(';')
            .Select(b => b.Split('=', 2))
            .Select(b => (int.Parse(b[0], CultureInfo.InvariantCulture), b[1])))
        {
            lines[at] = text;
        }
    }

    [Theory]
    [InlineData("")]
    [InlineData("G91")]
    [InlineData("G18")]
    [InlineData("G20")]
    [InlineData("G55")]
    [InlineData("G41 D1")]
    [InlineData("G92 X0. Y1.")]
    [InlineData("F777.")]
    [InlineData("G2 X9. Y9. I1. J1.")]
    [InlineData("G10 L2 P1 X3.")]
    [InlineData("X12345.678")]
    public void In_long_programs_too(string text)
    {
        // 20,500 blocks are two pieces of motions and more, with arcs, feeds and pieces of contours that begin elsewhere.
        var lines = Program(new(7), 20_500, othersAt: 4_000);
        var path = Bench.Read(string.Join('\n', lines), NcDialects.FanucMill);
        foreach (var at in new[] { 5, 511, 512, 513, 8_190, 8_192, 8_194, 12_000, 20_480, 20_499 })
        {
            var damaged = lines.ToList();
            damaged[at] = text;
            AssertSame(NcProgram.FromText(string.Join('\n', damaged)), path);
        }
    }

    [Theory]
    [InlineData(50_176)]
    [InlineData(50_170)]
    [InlineData(50_180)]
    [InlineData(100_100)]
    [InlineData(30)]
    public void And_where_the_original_was_begun_in_its_middle_as_well(int at)
    {
        var lines = Enumerable.Range(0, 100_352)
            .Select(i => i % 700 == 0 ? Text($"G2 X{i % 17}.5 Y{i % 29} R500. F{i % 300}") : Text($"G1 X{i % 17}.5 Y{i % 29}"))
            .ToList();
        var path = Bench.Read(string.Join('\n', lines), NcDialects.FanucMill);
        foreach (var text in new[] { "G1 X0.001", "G91", "(A COMMENT)", "G3 X1. Y1. R90." })
        {
            var damaged = lines.ToList();
            damaged[at] = text;
            AssertSame(NcProgram.FromText(string.Join('\n', damaged)), path);
        }
    }

    public static TheoryData<string> Effects => [.. new[]
    {
        "another digit", "G91", "G18", "G20", "G55", "G41", "G0", "F777.", "M0", "G92 X0. Y0.", "G52 X0.001", "G68 X0. Y0. R0.001",
        "G43 H2", "(a comment)", "another line end", "gone", "twice",
    }];

    [Theory]
    [MemberData(nameof(Effects))]
    public void Whatever_is_done_beside_a_border_the_proof_finds_it(string what)
    {
        // Blocks on both sides of the borders at 1024 and 8192, where a piece of motions ends as well, and at the ends of what was named.
        var lines = Enumerable.Range(0, 9_000)
            .Select(
                i => i switch
                {
                    0 => "G21 G17 G40 G90 G54 G94",
                    1 => "G0 X0. Y0. Z5.",
                    2 => "G1 Z-2. F500.",
                    _ => Text($"N{i} G1 X{0.2 * i:0.000} Y{20 * Math.Sin(0.01 * i):0.000}")
                })
            .ToArray();
        var path = Bench.Read(string.Join('\n', lines) + "\n");
        var wish = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N4000..N4200"), 0.02));
        var good = Bench.Text(Bench.Rewritten(path, wish).Program).Split('\n');
        foreach (var at in new[]
        {
            3,
            Border - 2,
            Border - 1,
            Border,
            Border + 1,
            3_998,
            3_999,
            4_000,
            4_095,
            4_096,
            4_097,
            4_200,
            4_201,
            4_202,
            4_607,
            4_608,
            8_191,
            8_192,
            8_193,
            8_194,
            8_195,
            8_704,
            8_999
        })
        {
            string[] damaged = what switch
            {
                "another digit" => [.. good[..at], Changed(good[at]), .. good[(at + 1)..]],
                "another line end" => [.. good[..at], good[at] + "\r", .. good[(at + 1)..]],
                "gone" => [.. good[..at], .. good[(at + 1)..]],
                "twice" => [.. good[..at], good[at], .. good[at..]],
                _ => [.. good[..at], good[at] + " " + what, .. good[(at + 1)..]],
            };
            var result = NcProgram.FromText(string.Join('\n', damaged));
            Assert.False(Prover.Check(path, result, wish, 0.001).Holds, Text($"{what} in line {at + 1}"));
            AssertSame(result, path);
        }
    }

    // The last digit of Y.
    private static string Changed(string line) => line[..^1] + (line[^1] == '0' ? '1' : '0');

    private static void AssertSame(NcProgram program, NcPath like)
    {
        var (whole, passed) = (NcInterpreter.Run(program, like.Dialect), NcInterpreter.Run(program, like));
        Assert.Equal(whole.Problems, passed.Problems);
        Assert.Equal(whole.Notes, passed.Notes);
        Assert.Equal(whole.Frames, passed.Frames);
        Assert.Equal(whole.PlaceDependents, passed.PlaceDependents);
        Assert.Equal(whole.Refusal, passed.Refusal);
        Assert.Equal((whole.Motions.Length, whole.Motions.FollowBlocks), (passed.Motions.Length, passed.Motions.FollowBlocks));
        for (var i = 0; i < whole.Motions.Length; i++)
        {
            if (!whole.Motions.SameAt(passed.Motions, i, 0) || whole.Motions[i] != passed.Motions[i])
            {
                Assert.Fail(Text($"Motion {i}: {passed.Motions[i]} is {whole.Motions[i]}"));
            }
        }
    }

    private static List<string> Program(Sequence random, int blocks, int othersAt)
    {
        var lines = new List<string>(blocks) { "G21 G17 G40 G90 G54", "G0 X0. Y0. Z5.", "G1 X1. Y1. Z-1. F500." };
        while (lines.Count < blocks)
        {
            lines.Add(random.Line(
                random.Next(othersAt) == 0 ? random.Next(10) == 0 ? Odd : Others : random.Next(5) == 0 ? Cuts : Cuts[..3]));
        }

        return lines;
    }

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);

    /// <summary>Numbers that look random, the same for the same seed.</summary>
    private sealed class Sequence(int seed)
    {
        private ulong _state = ((ulong)seed * 0x9E3779B97F4A7C15UL) | 1;

        public int Next(int behind)
        {
            _state ^= _state << 13;
            _state ^= _state >> 7;
            _state ^= _state << 17;
            return (int)((_state >> 16) % (ulong)behind);
        }

        public string Line(string[] from) => string.Format(CultureInfo.InvariantCulture, from[Next(from.Length)], Next(90), Next(9));
    }
}
