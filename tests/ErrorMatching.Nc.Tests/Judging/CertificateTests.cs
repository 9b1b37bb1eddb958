using System.Security.Cryptography;
using System.Text;
using System.Text.Json;

namespace ErrorMatching.Nc.Tests;

/// <summary>What a certificate says about a displacement whose numbers are known.</summary>
public sealed class CertificateTests
{
    // A lead-in along X, a line along Y and an arc about (0, 10), all of them met at right angles.
    private const string Text = "G21 G17 G90\nG0 X-20. Y0. Z5.\nG1 Z-1. F100.\nN1 X10. Y0.\nN2 X10. Y10.\nN3 G3 X0. Y20. I-10. J0.\n"
        + "N4 G1 X0. Y40.\nG0 Z5.\nM30\n";

    [Fact]
    public void Wish_rest_and_carrier_of_a_line_and_an_arc_are_stated()
    {
        using var document = Of(Text, 0.1, "N2..N3");
        var root = document.RootElement;
        var moved = root.GetProperty("moved").EnumerateArray().ToArray();
        Assert.Equal(["N1", "N2", "N3", "N4"], moved.Select(m => m.GetProperty("block").GetString()));
        Assert.Equal(["slides", "line", "arc", "slides"], moved.Select(m => m.GetProperty("as").GetString()));
        Assert.Equal((0.1, 0), (moved[1].GetProperty("shift").GetDouble(), moved[1].GetProperty("tilt").GetDouble()));

        // A counter-clockwise arc moves to the left, toward its center.
        Assert.Equal(-0.1, moved[2].GetProperty("growth").GetDouble());
        Assert.Equal("[0,0]", moved[2].GetProperty("center").GetRawText());
        Assert.All(moved[1..3], m => Assert.Equal("wish", m.GetProperty("startBy").GetString()));
        Assert.All(moved[1..3], m => Assert.Equal("wish", m.GetProperty("endBy").GetString()));
        Assert.Equal([-0.1, 0, 0], moved[0].GetProperty("moved").GetProperty("end").EnumerateArray().Select(v => v.GetDouble()));
        Assert.Equal("[[2,3],[8,8]]", root.GetProperty("fixed").GetRawText());
        Assert.Equal(7, root.GetProperty("motions").GetInt32());
        Assert.Equal("arc-counter-clockwise", root.GetProperty("codes").GetProperty("G3").GetString());
        Assert.Equal("program-end", root.GetProperty("functions").GetProperty("M30").GetString());
    }

    [Fact]
    public void Inches_keep_their_increment()
    {
        using var document = Of(Text.Replace("G21", "G20", StringComparison.Ordinal), 0.254, "N2..N3");
        Assert.Equal("inch", document.RootElement.GetProperty("unit").GetString());
        Assert.Equal("0.00254", document.RootElement.GetProperty("leastIncrementMm").GetRawText());
    }

    [Fact]
    public void Seal_is_the_hash_of_all_bytes_before_it()
    {
        var bytes = BytesOf(Text, 0.1, "N2");
        var at = bytes.AsSpan().LastIndexOf("  \"seal\": "u8);
        var hash = Convert.ToHexStringLower(SHA256.HashData(bytes.AsSpan(0, at)));
        Assert.Equal($"  \"seal\": \"{hash}\"\n}}\n", Encoding.ASCII.GetString(bytes[at..]));
    }

    [Fact]
    public void Only_a_proof_that_holds_is_certified()
    {
        var path = Bench.Read(Text);
        var wish = DisplacementWish.Normal(path, Bench.Blocks(path, "N2"), 0.1).Result!;
        var proof = Prover.Check(path, path.Program, wish, 0.001);
        Assert.False(proof.Holds);
        Assert.Throws<ArgumentException>(() => Certificate.Of(path, path.Program, wish, 0.001, proof));
    }

    private static JsonDocument Of(string text, double left, string blocks) => JsonDocument.Parse(BytesOf(text, left, blocks));

    private static byte[] BytesOf(string text, double left, string blocks)
    {
        var path = Bench.Read(text);
        var wish = DisplacementWish.Normal(path, Bench.Blocks(path, blocks), left).Result!;
        var rewrite = Bench.Usable(Rewriter.Apply(path, wish));
        var proof = Prover.Check(path, rewrite.Program, wish, rewrite.LeastIncrementMm);
        return Certificate.Of(path, rewrite.Program, wish, rewrite.LeastIncrementMm, proof).ToBytes();
    }
}
