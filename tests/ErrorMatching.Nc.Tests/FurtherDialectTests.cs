namespace ErrorMatching.Nc.Tests;

/// <summary>What sets Mazak, Mitsubishi and the codes of Okuma apart from Fanuc.</summary>
public sealed class FurtherDialectTests
{
    private const string Subprogram = "\nX9.\nM30\nO10\nN1 X1.\nN2 X2.\nM99\n";

    [Theory]
    [InlineData("mazak-eia", "M98 P10 Q2" + Subprogram, "R2,0,0 R9,0,0")]
    [InlineData("mazak-eia", "M98 P10" + Subprogram, "R1,0,0 R2,0,0 R9,0,0")]
    [InlineData("mitsubishi-m80", "M98 P10 H2 L2" + Subprogram, "R2,0,0 R2,0,0 R9,0,0")]
    [InlineData("mitsubishi-m80", "M98 H5\nX9.\nM30\nN5 X1.\nM99", "R1,0,0 R9,0,0")]
    [InlineData("mitsubishi-m80", "G12 I5. D1 F100.\nX1. Y2. Z3.", "C?,?,? R1,2,3")]
    [InlineData("mazak-eia", "Z5.\nG75 X1. Y2. Z-3. R1. F50.\nG80\nG0 X3.\nZ5.", "R0,0,5 C1,2,? R3,2,? R3,2,5")]
    [InlineData("mazak-eia", "Z5.\nG98 G83 X1. Z-3. R1. Q1. K2. F50.\nG80", "R0,0,5 C1,0,5")]
    [InlineData("okuma-osp", "G71 Z50.\nG81 X1. Y2. Z-3. R1. F50. M53\nX3.\nG80\nG0 X3. Z5.", "C1,2,? C3,2,? R3,2,5")]
    [InlineData("okuma-osp", "G15 H2\nX1. Y1. Z1.", "R1,1,1")]
    [InlineData("okuma-osp", "F=PF100\nX1.", "R1,0,0")]
    [InlineData("okuma-osp", "G0 G16 H0 Z0.\nX1.", "M0,0,? R1,0,?")]
    public void Motions(string dialect, string program, string moves) => Assert.Equal(moves, Moves.Of(dialect, program));

    [Theory]
    [InlineData("mazak-eia", "M98 P10 Q7" + Subprogram, "missing-label")]
    [InlineData("mitsubishi-m80", "M98 P20010" + Subprogram, "missing-program")]
    [InlineData("mazak-eia", "M96 P10", "unknown-condition")]
    public void What_is_not_followed_is_refused_by_name(string dialect, string block, string code)
    {
        var refusal = Bench.Read("G90 G17 G40 G0 X0. Y0. Z0.\n" + block, NcDialects.Named(dialect)).Refusal;
        Assert.Equal((code, 2), (refusal?.Code, refusal?.Place.Line));
    }
}
