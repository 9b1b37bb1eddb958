using System.Diagnostics;
using System.Text;
using ErrorMatching.Testing;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Nc.Tests;

/// <summary>ISO and LinuxCNC spelling, comments in any encoding, and what stands at the beginning and end of files.</summary>
public sealed class IsoSpellingTests
{
    public static TheoryData<string> Syntaxes => [.. Enum.GetNames<NcSyntax>()];

    [Theory]
    [InlineData("(a (b) c) X1", "c (a (b) c) | X=1")]
    [InlineData("(a)(b) X1 (c)", "c (a) | c (b) | X=1 | c (c)")]
    [InlineData("X1 (open", "X=1 | ! (open")]
    [InlineData("(open (a) X1", "c (open (a) | X=1")]
    [InlineData("X1 ) Y2", "X=1 | ! ) | Y=2")]
    [InlineData("X10. ,R2.5 Y3 , C1", "X=10 | ,R=2.5 | Y=3 | ,C=1")]
    [InlineData("X10. ,R#1 ,C[#2/2]", "X=10 | ,R?#1 | ,C?[#2/2]")]
    [InlineData(":1234 (PART)", "O=1234 | c (PART)")]
    [InlineData("/1 N10 X1", "/ /1 | N=10 | X=1")]
    [InlineData("/9N10X1", "/ /9 | N=10 | X=1")]
    [InlineData("N10 /2 X1", "N=10 | / /2 | X=1")]
    [InlineData("X1 /2", "X=1 | ! / | ! 2")]
    [InlineData("#100=#101+1 (c)", ":= #100=#101+1  | c (c)")]
    [InlineData("X#100 Y-[#1+2] Z=5", "X?#100 | Y?-[#1+2] | Z?=5")]
    [InlineData("GOTO100", "# GOTO100")]
    [InlineData("G65 P9810 X#1 (a) Y2", "G=65 | P=9810 | X?#1 | c (a) | Y=2")]
    [InlineData("X123456789.012345 Y-0.123456789012345", "X=123456789.012345 | Y=-0.123456789012345")]
    [InlineData("X-0 Y+3. Z5. I.5 J-.25", "X=0 | Y=3 | Z=5 | I=0.5 | J=-0.25")]
    [InlineData("X 5 Y\t6", "X=5 | Y=6")]
    [InlineData("X5 6", "X=5 | ! 6")]
    public void Iso_tokens_are_these(string line, string tokens) => Assert.Equal(tokens, Spelled.Tokens(line, NcSyntax.Iso));

    [Theory]
    [InlineData("g 0 x +0. 12 34 y 7", "G=0 | X=0.1234 | Y=7")]
    [InlineData("X 1 0 Y - 5", "X=10 | Y=-5")]
    [InlineData("#1=5 X#1", ":= #1=5 | X?#1")]
    [InlineData("#1=5 #<depth>=[#1+2] X1", ":= #1=5 | := #<depth>=[#1+2] | X=1")]
    [InlineData("x sin[30] y atan[1]/[2] z-#<depth>", "X?sin[30] | Y?atan[1]/[2] | Z?-#<depth>")]
    [InlineData("o100 sub", "O=100 | # sub")]
    [InlineData("O<pocket> call [1] [2]", "O?O<pocket> | # call | [] [1] | [] [2]")]
    [InlineData("G1 X1 ; (open", "G=1 | X=1 | c ; (open")]
    public void LinuxCnc_tokens_are_these(string line, string tokens) => Assert.Equal(tokens, Spelled.Tokens(line, NcSyntax.LinuxCnc));

    [Fact]
    public void Any_bytes_are_covered_by_tokens_in_every_syntax()
    {
        var some = Encoding.ASCII.GetBytes("GXYZNIJKRFOACE0123456789.-+ \t()[]%/#;,=\"<>:_$\0\u001a");
        var bytes = Gen.Frequency((4, Gen.Elements(some)), (1, Gen.Choose(0, 255).Select(n => (byte)n)));
        var tries = Config.QuickThrowOnFailure.WithMaxTest(Depth.Of(1000, 3000)).WithEndSize(80);
        Check.One(tries, Prop.ForAll(bytes.ArrayOf().ToArbitrary(), b =>
        {
            foreach (var syntax in Enum.GetValues<NcSyntax>())
            {
                var program = NcProgram.Read(b, syntax);
                Assert.True(NcCensus.Of(program).RoundTrips);
                for (var i = 0; i < program.BlockCount; i++)
                {
                    foreach (var token in program.Tokens(program[i]))
                    {
                        Assert.True(
                            token.Length > 0 && token.ValueStart >= token.Start && token.ValueStart + token.ValueLength <= token.End);
                    }
                }
            }

            return true;
        }));
    }

    [Fact]
    public void Comments_in_encodings_of_two_bytes_end_where_they_end()
    {
        // Second bytes of Big5 and GBK begin at 0x40, of Shift JIS too:
        // brackets, backslashes and bars, but never a parenthesis, a semicolon or a line end.
        for (var lead = 0x81; lead <= 0xFE; lead++)
        {
            for (var trail = 0x40; trail <= 0xFE; trail++)
            {
                byte[] text = [.. "G1 ("u8, (byte)lead, (byte)trail, .. ") X5."u8];
                foreach (var syntax in (NcSyntax[])[NcSyntax.Iso, NcSyntax.LinuxCnc])
                {
                    Assert.EndsWith(") | X=5", Spelled.Tokens(NcProgram.Read(text, syntax)), StringComparison.Ordinal);
                }
            }
        }
    }

    [Theory]
    [InlineData("\u0000\u0000\u0000")]
    [InlineData("\u001a")]
    [InlineData("\u001a\u0000\u0000")]
    [InlineData("\n\u001a")]
    [InlineData("\n\u001a\r\n\u0000")]
    public void Zero_bytes_and_end_of_file_signs_at_the_end_are_passed_over(string tail)
    {
        var path = Bench.Read("G90 G0 X1 Y2 Z3\nG1 X5" + tail);
        Assert.Empty(path.Problems);
        Assert.Equal(5, path.Motions[^1].End.X);
    }

    [Fact]
    public void End_of_file_sign_with_a_program_behind_it_is_reported()
    {
        // Some controls stop reading there, others do not.
        Assert.Equal("unknown-word", Assert.Single(Bench.Read("G0 X1\u001a\nX2\n").Problems).Code);
        Assert.Equal("unknown-word", Assert.Single(Bench.Read("G0 X\u00001\n").Problems).Code);
    }

    [Theory]
    [MemberData(nameof(Syntaxes))]
    public void First_block_behind_a_mark_is_read(string syntax)
    {
        var program = NcProgram.FromText("\uFEFFN10 G1 X5\nX6\n", Spelled.Of(syntax));
        Assert.Equal(syntax == "Klartext" ? "N=10 | # G1 | X=5" : "N=10 | G=1 | X=5", Spelled.Tokens(program));
        Assert.Equal(("N10", "N10 G1 X5"), (program.NumberOf(program[0]), program.TextOf(program[0])));
        Assert.Equal([0], BlockSelector.Select(program, [BlockSelector.Parse("/^N10\\b/")]).Result!);
        Assert.Empty(Bench.Read("\uFEFFN10 G1 X5\nX6\n").Problems);
        Assert.Equal("! \u00EF | ! \u00BB | ! \u00BF | X=1", Spelled.Tokens("X1\n\uFEFFX1", Spelled.Of(syntax), 1));
    }

    [Theory]
    [InlineData("(")]
    [InlineData("(a)(")]
    [InlineData("((a)")]
    [InlineData("[")]
    [InlineData("\"")]
    [InlineData("X[")]
    [InlineData("#")]
    [InlineData(",")]
    [InlineData("\0X")]
    [InlineData("\0")]
    [InlineData("\u001a\n")]
    [InlineData("NOT ")]
    [InlineData("X=NOT ")]
    [InlineData("X=(")]
    [InlineData("A[1] ")]
    [InlineData("O<")]
    [InlineData("X0 ")]
    [InlineData("X1")]
    [InlineData("- ")]
    [InlineData("=")]
    public void Lines_of_a_megabyte_take_no_longer_than_their_length(string piece)
    {
        var text = "X1" + string.Concat(Enumerable.Repeat(piece, (1 << 20) / piece.Length)) + "X2";
        var watch = Stopwatch.StartNew();
        foreach (var dialect in new[] { NcDialects.FanucMill, NcDialects.LinuxCnc, NcDialects.Siemens840D }.Take(Depth.Of(1, 3)))
        {
            var program = NcProgram.FromText(text, dialect.Syntax);
            Assert.True(NcCensus.Of(program).RoundTrips);
            NcInterpreter.Run(program, dialect);
        }

        // A tenth of a second each where nothing else runs; a quadratic way takes minutes.
        Assert.InRange(watch.Elapsed.TotalSeconds, 0, 120);
    }
}
