namespace ErrorMatching.Nc.Tests;

/// <summary>Tokens of Okuma programs.</summary>
public sealed class OkumaSpellingTests
{
    [Theory]
    [InlineData("N100 G1 X-5.5 Y+2", "N=100 | G=1 | X=-5.5 | Y=2")]
    [InlineData("N1G1X1", "N=1 | G=1 | X=1")]
    [InlineData("G0 X=XPOS-45 Y=[YPOS+[1-VC2]]*2 Z=-5.", "G=0 | X?XPOS-45 | Y?[YPOS+[1-VC2]]*2 | Z=-5")]
    [InlineData("X=VC1 + 5 Y= 3", "X?VC1 + 5 | Y=3")]
    [InlineData("X=VC[VC1+1]*2 M8", "X?VC[VC1+1]*2 | M=8")]
    [InlineData("NT1 (100MM FACE MILL)", "@ NT1 | c (100MM FACE MILL)")]
    [InlineData("NWF80 VC32=1", "@ NWF80 | := VC32=1")]
    [InlineData("/1 NA G0 X1", "/ /1 | @ NA | G=0 | X=1")]
    [InlineData("OTC  (G116)", "@ OTC | c (G116)")]
    [InlineData("O1000", "O=1000")]
    [InlineData("O10A", "@ O10A")]
    [InlineData("XSRT=[XPOS-[VTOFD[1]]] (START)", ":= XSRT=[XPOS-[VTOFD[1]]] | c (START)")]
    [InlineData("VZOFX[1]=VC1 VC2=3", ":= VZOFX[1]=VC1 | := VC2=3")]
    [InlineData("VUACM[1]='TOO (LOW)' S=#81H", ":= VUACM[1]='TOO (LOW)' | S?#81H")]
    [InlineData("IF [VC1 EQ 5] NDTM (NEXT)", "# IF [VC1 EQ 5] NDTM  | c (NEXT)")]
    [InlineData("NCTL IF[VTLCN EQ 1] NXT2", "@ NCTL | # IF[VTLCN EQ 1] NXT2")]
    [InlineData("CALL O100 Q2 PA=1 PB=[2+3]", "# CALL O100 Q2 PA=1 PB=[2+3]")]
    [InlineData("NCYL G81 Z=ZPOS-2.6", "# NCYL | G=81 | Z?ZPOS-2.6")]
    [InlineData("BHC X10 Y=YPOS I35", "# BHC | X=10 | Y?YPOS | I=35")]
    [InlineData("G15 H=VC32", "G=15 | H?VC32")]
    [InlineData("F=PF100", "F?PF100")]
    [InlineData("$PART.MIN%", "% $PART.MIN%")]
    [InlineData("X", "! X")]
    [InlineData("X=", "X?")]
    [InlineData("X1 NA", "X=1 | # NA")]
    [InlineData("(NO END", "! (NO END")]
    public void Tokens_are_these(string line, string tokens) =>
        Assert.Equal(tokens, Spelled.Tokens(line, NcSyntax.Okuma));

    [Fact]
    public void Blocks_are_found_by_their_numbers()
    {
        var program = NcProgram.FromText("$A.MIN%\nO1\nN10 G0 X1\nNA N11 X2\nN12 X=VC1\n", NcSyntax.Okuma);
        var blocks = BlockSelector.Select(program, [BlockSelector.Parse("N10..N12")]);
        Assert.Equal([2, 3, 4], blocks.Result!);
    }
}
