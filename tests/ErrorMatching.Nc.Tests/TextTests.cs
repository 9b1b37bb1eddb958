using System.Text;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Nc.Tests;

/// <summary>Bytes in, the same bytes out, and every byte in exactly one token.</summary>
public sealed class TextTests
{
    public static TheoryData<string> Programs => new(
        "",
        "\n",
        "\r",
        "\r\n",
        "G1 X1",
        "G1 X1\r\nX2\r\n",
        "G1 X1\nX2\n",
        "G1 X1\rX2\r",
        "G1\r\nX1\nX2\rX3",
        "\n\n\r\r\n\n",
        "%\nO0001 (PART)\nN10 G1X1Y2\n%\n",
        "G1 X1\0\0\u001a",
        "\tG1\tX1\t\n",
        "(\u00a4\u00a4\u00a4\u00e5) x.5 y5. z+3. a-0 b007.500",
        "N10 (one) G1 (two) X1 ; three",
        "(outer (inner) outer) G1 X1",
        "(never closed G1 X1",
        "(a (b) c\nX1",
        "/1 N10 G1 X1\n/N20 X2\nN30 /X3",
        "X123456789012.345 Y-123456789012345678 Z1234567890123456789",
        "#100=#101+[2*3] (note)\nX#100 Y-[#1+1] Z=R1+5\nIF [#1 EQ 1] GOTO 100\nCYCLE81(1,2,(3)) CR=5\no<name> call [1]\n\"text\" ,R5. ,C "
            + ",\n");

    [Theory]
    [MemberData(nameof(Programs))]
    public void Programs_survive_as_they_are(string text) => AssertLossless(Encoding.Latin1.GetBytes(text));

    [Fact]
    public void Any_bytes_survive_as_they_are()
    {
        var bytes = Gen.Frequency(
            (3, Gen.Elements(Encoding.ASCII.GetBytes("GXYZNIJKRF0123456789.-+ \t\r\n()[]%/#;,=\""))),
            (1, Gen.Choose(0, 255).Select(n => (byte)n)));
        Check.One(Config.QuickThrowOnFailure.WithMaxTest(2000), Prop.ForAll(bytes.ArrayOf().ToArbitrary(), b =>
        {
            AssertLossless(b);
            return true;
        }));
    }

    [Fact]
    public void Big5_comments_survive_and_are_shown_as_single_bytes()
    {
        byte[] bytes = [.. "N10 ("u8, 0xA4, 0xA4, 0xA4, 0xE5, .. ")\n"u8];
        AssertLossless(bytes);
        var program = NcProgram.Read(bytes);
        Assert.Equal("N10 (\u00a4\u00a4\u00a4\u00e5)", program.TextOf(program[0]));
    }

    [Theory]
    [InlineData("G1\r\nX1\nX2\rX3", 4)]
    [InlineData("", 0)]
    [InlineData("\n", 1)]
    [InlineData("X1", 1)]
    [InlineData("X1\n\r\n", 2)]
    [InlineData("X1\r\r\nX2", 3)]
    public void Line_ends_of_every_kind_part_blocks(string text, int blocks) => Assert.Equal(blocks, NcProgram.FromText(text).BlockCount);

    [Theory]
    [InlineData("N10G1X1Y2", "N=10 G=1 X=1 Y=2")]
    [InlineData("n010 g01 x.5 y5. z+3.", "N=10 G=1 X=0.5 Y=5. Z=3.")]
    [InlineData("X-0 Y-0.0 Z007.500", "X=0 Y=0.0 Z=7.500")]
    [InlineData("X 5.5 Y - 3", "X=5.5")]
    [InlineData("X123456789012.345 Y-123456789012345", "X=123456789012.345 Y=-123456789012345")]
    [InlineData("/1 N10 X1", "N=10 X=1")]
    [InlineData("(X9) X1 (X8) Y2 ; X7", "X=1 Y=2")]
    [InlineData("(a (X9) b) X1", "X=1")]
    [InlineData("% X1", "")]
    [InlineData("\tX1\tY2", "X=1 Y=2")]
    public void Words_have_exact_values(string line, string words)
    {
        var program = NcProgram.FromText(line);
        var found = new List<string>();
        foreach (var token in program.Tokens(program[0]))
        {
            if (token.Kind == NcTokenKind.Word)
            {
                found.Add((char)token.Letter + "=" + token.Number);
            }
        }

        Assert.Equal(words.Replace(". ", " ", StringComparison.Ordinal).TrimEnd('.'), string.Join(' ', found));
    }

    [Theory]
    [InlineData("X1234567890123456789")]
    [InlineData("X1.2.3")]
    [InlineData("X--1")]
    [InlineData("X.")]
    public void Numbers_that_are_none_are_kept_as_invalid(string line)
    {
        var program = NcProgram.FromText(line);
        var invalid = false;
        foreach (var token in program.Tokens(program[0]))
        {
            invalid |= token.Kind == NcTokenKind.Invalid;
        }

        Assert.True(invalid);
    }

    [Fact]
    public void Patches_replace_their_ranges_and_copy_the_rest()
    {
        NcPatch[] patches = [new(0, 2, "G0"u8.ToArray()), new(4, 0, "-"u8.ToArray()), new(5, 1, ReadOnlyMemory<byte>.Empty)];
        Assert.Equal("G0 X-1", Encoding.ASCII.GetString(NcPatch.Apply("G1 X12"u8, patches)));
    }

    [Fact]
    public void Patches_that_overlap_or_run_over_the_end_are_an_error()
    {
        Assert.Throws<ArgumentException>(() => NcPatch.Apply("G1 X12"u8, [new(0, 3, default), new(2, 1, default)]));
        Assert.Throws<ArgumentException>(() => NcPatch.Apply("G1"u8, [new(1, 2, default)]));
    }

    private static void AssertLossless(byte[] bytes)
    {
        var program = NcProgram.Read(bytes);
        Assert.Equal(bytes, NcPatch.Apply(program.Bytes.Span, []));
        var at = 0;
        for (var i = 0; i < program.BlockCount; i++)
        {
            var block = program[i];
            Assert.Equal(at, block.Start);
            foreach (var token in program.Tokens(block))
            {
                Assert.Equal(at, token.Start);
                Assert.InRange(token.Length, 1, block.End - token.Start);
                Assert.InRange(token.ValueStart, token.Start, token.End);
                at = token.End;
            }

            Assert.Equal(block.End, at);
            Assert.InRange(block.FullLength - block.Length, 0, 2);
            Assert.True(program.BytesOf(block).IndexOfAny((byte)'\r', (byte)'\n') < 0);
            at = block.Start + block.FullLength;
        }

        Assert.Equal(bytes.Length, at);
    }
}
