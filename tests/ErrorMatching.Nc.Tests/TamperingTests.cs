using System.Text;

namespace ErrorMatching.Nc.Tests;

/// <summary>Whatever is done to a proved result, in whatever spelling and by whatever wish it came about, the proof finds it.</summary>
public sealed class TamperingTests
{
    private const string Absolute = """
        %
        O0001 (COUNTERPART)
        N1 G21 G17 G40 G90 G54
        N2 T1 M6
        N3 S3000 M3
        N4 G43 H1 G0 Z50.
        N10 G0 X-20. Y-5. Z5.
        N20 G1 Z-2. F200
        N100 G1 X0. Y0. F500 (lead in)
        N110 X10. Y0.
        N120 G3 X15. Y5. I0. J5.
        N130 G1 X15. Y15.
        N140 X25. Y20.
        N150 G2 X35. Y10. I0. J-10.
        N160 G1 X36.
        /N165 G4 P100
        N170 Y1.
        N180 G0 Z50.
        N190 M30
        %
        """;

    private const string Incremental = """
        %
        O0001 (COUNTERPART)
        N1 G21 G17 G40 G90 G54
        N2 T1 M6
        N3 S3000 M3
        N4 G43 H1 G0 Z50.
        N10 G0 X-20. Y-5. Z5.
        N20 G91 G1 Z-7. F200
        N100 G1 X20. Y5. F500 (lead in)
        N110 X10. Y0.
        N120 G3 X5. Y5. I0. J5.
        N130 G1 X0. Y10.
        N140 X10. Y5.
        N150 G2 X10. Y-10. I0. J-10.
        N160 G1 X1.
        /N165 G4 P100
        N170 Y-9.
        N180 G0 Z52.
        N190 M30
        %
        """;

    private static readonly Dictionary<string, string> Programs = new(StringComparer.Ordinal)
    {
        ["absolute"] = Absolute,
        ["incremental"] = Incremental,
        ["radius"] = Absolute.Replace("I0. J5.", "R5.", StringComparison.Ordinal).Replace("I0. J-10.", "R10.", StringComparison.Ordinal),
        ["helix"] = Absolute.Replace("I0. J5.", "Z-3. I0. J5.", StringComparison.Ordinal).Replace(
            "I0. J-10.", "Z-4. I0. J-10.", StringComparison.Ordinal),
        ["no spaces"] = Absolute.Replace(" ", "", StringComparison.Ordinal).ToLowerInvariant(),
        ["latin-1"] = Absolute.Replace(
            "lead in",
            "LEAD IN \u00e4\u00df\u00b0",
            StringComparison.Ordinal).Replace("Y0.\n", "Y0. (\u00fcber)\n", StringComparison.Ordinal),
    };

    public static TheoryData<string, bool> Cases => [.. Programs.Keys.SelectMany(p => new[] { (p, true), (p, false) })];

    [Theory]
    [MemberData(nameof(Cases))]
    public void Whatever_is_done_to_a_result_the_proof_finds_it(string program, bool isElements)
    {
        var path = NcInterpreter.Run(NcProgram.Read(Bytes(Programs[program].ReplaceLineEndings("\r\n"))), NcDialects.Generic);
        var blocks = Bench.Blocks(path, "N110..N130");
        var wish = Bench.Usable(
            isElements ? DisplacementWish.Normal(path, blocks, 0.1) : DisplacementWish.EndsBy(path, blocks, new(0.1, 0.2, 0)));
        var good = Bench.Rewritten(path, wish).Program;
        var lines = Bench.Text(good).Split("\r\n");
        var (done, missed) = (0, new List<string>());
        foreach (var tampering in Tampering.All)
        {
            if (tampering.Apply(lines) is not { } changed)
            {
                continue;
            }

            var bytes = Bytes(string.Join("\r\n", changed));
            Assert.False(bytes.AsSpan().SequenceEqual(good.Bytes.Span), $"{tampering.Name} changes nothing.");
            done++;
            if (Prover.Check(path, NcProgram.Read(bytes), wish, 0.001).Holds)
            {
                missed.Add(tampering.Name);
            }
        }

        Assert.Empty(missed);
        Assert.InRange(done, 100, Tampering.All.Count);
    }

    private static byte[] Bytes(string text) => Encoding.Latin1.GetBytes(text);
}
