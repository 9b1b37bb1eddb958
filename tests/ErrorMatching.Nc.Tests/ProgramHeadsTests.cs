using System.Text;

namespace ErrorMatching.Nc.Tests;

/// <summary>What a control will call the programs of a file.</summary>
public sealed class ProgramHeadsTests
{
    [Theory]
    [InlineData("fanuc", "%\nO0240\n(KEY)\nG0 X0\nM30\n%\n", "O0240")]
    [InlineData("fanuc", "%\nO240(KEY)\nM30\n%\n", "O0240")]
    [InlineData("delta-nc300", "O00240 (KEY)\nM30\n", "O0240")]
    [InlineData("fanuc", "%\n:0240\nM30\n%\n", "O0240")]
    [InlineData("fanuc", "KEY\n%\n/O 240\nM30\n%\n", "O0240")]
    [InlineData("fanuc", "%\nO12345678\nM30\n%\n", "O12345678")]
    [InlineData("fanuc", "%\n<KEY_1>\nM30\n%\n", "KEY_1")]
    [InlineData("haas", "%\nO1\nM97 P10\nM30\nO2\nM99\nO1\nM99\n%\n", "O0001 O0002")]
    [InlineData("fanuc", "%\n(O0240)\nN10 G0 X0\nM30\n%\n", "")]
    [InlineData("siemens-840d", "%_N_P100_MPF\n;$PATH=/_N_MPF_DIR\nN10 G0 X0\nM30\n", "_N_P100_MPF")]
    [InlineData("siemens-840d", "%MPF123\nN10 G0 X0\nM30\n", "MPF123")]
    [InlineData("siemens-840d", "; KEY\nN10 G0 X0\nM30\n", "")]
    [InlineData("heidenhain-klartext", "0 BEGIN PGM KEY-1 MM\n1 L X+0 R0 FMAX\n2 END PGM KEY-1 MM\n", "KEY-1")]
    [InlineData("heidenhain-klartext", "0  BEGIN  PGM  240  INCH ; A KEY\n1 END PGM 240 INCH\n", "240")]
    [InlineData("okuma-osp", "$KEY.MIN%\nOKEY (KEY)\nG0 X0\nM02\nO100\nRTS\n", "OKEY O100")]
    [InlineData("linuxcnc", "O0240\nG0 X0\nM2\n", "")]
    [InlineData("grbl", "O0240\nG0 X0\nM2\n", "")]
    public void The_names_at_the_heads_are_what_the_control_calls_the_programs(string dialect, string text, string names)
    {
        var control = NcDialects.Named(dialect);
        Assert.Equal(names, string.Join(' ', ProgramHeads.Of(NcProgram.Read(Encoding.ASCII.GetBytes(text), control.Syntax), control)));
    }
}
