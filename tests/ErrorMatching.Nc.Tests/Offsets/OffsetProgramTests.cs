using System.Text;

namespace ErrorMatching.Nc.Tests;

/// <summary>The program of the offsets as a subprogram: what calls it goes on behind the call, unless it stops the run.</summary>
public sealed class OffsetProgramTests
{
    private const string FanucMain = "%\nO0001\nG90 G21 G17 G54\n#501=1\n#502=0.1\n#503={before}\n#504=1\n#505=0\n#506=0\n#508=0\n#509=0\n"
        + "#510=0\n#1=7.\nG0 X0. Y0.\n{call}\nG90 G21 G54\nG1 X#1 Y5. F100\nM30\n%\n";

    private const string SiemensMain = "G90 G17 G710 G54\nR501=1\nR502=0.1\nR503={before}\nR504=1\nR505=0\nR506=0\nR507=0\nR508=0\nR509=0\n"
        + "R510=0\nG0 X0 Y0\n{call}\nG90 G54\nG1 X7 Y5 F100\nM30\n";

    [Theory]
    [InlineData("fanuc", "OFFSETS.NC", "G65 P9001")]
    [InlineData("mazak-eia", "offsets.eia", "G65 P9001")]
    [InlineData("siemens-840d", "OFFSETS.SPF", "OFFSETS")]
    [InlineData("linuxcnc", "offsets.ngc", "o<offsets> call")]
    public void A_call_is_stated(string dialect, string file, string call) =>
        Assert.Equal(call, OffsetProgram.CallOf(NcDialects.Named(dialect), file, 9001));

    [Theory]
    [InlineData("siemens-840d", "offsets.spf", "OFFSETS.SPF")]
    [InlineData("siemens-840d", "MY-OFFSETS.MPF", "MY_OFFSETS.SPF")]
    [InlineData("linuxcnc", "OFFSETS.NGC", "offsets.ngc")]
    [InlineData("linuxcnc", "my offsets.nc", "my_offsets.ngc")]
    public void A_file_that_the_control_does_not_find_is_not_called(string dialect, string file, string wanted)
    {
        Assert.Null(OffsetProgram.CallOf(NcDialects.Named(dialect), file, 9001));
        Assert.Equal(wanted, OffsetProgram.FileToCall(NcDialects.Named(dialect), file));
        Assert.NotNull(OffsetProgram.CallOf(NcDialects.Named(dialect), wanted, 9001));
    }

    [Theory]
    [InlineData("fanuc", "boss.nc", "offsets.nc")]
    [InlineData("fanuc", "offsets.nc", "errormatch_offsets.nc")]
    [InlineData("siemens-840d", "BOSS.MPF", "OFFSETS.SPF")]
    [InlineData("linuxcnc", "boss.nc", "offsets.ngc")]
    [InlineData("linuxcnc", "offsets.ngc", "errormatch_offsets.ngc")]
    public void Its_file_has_a_name_that_the_control_finds(string dialect, string program, string file) =>
        Assert.Equal(file, OffsetProgram.FileBeside(NcDialects.Named(dialect), program));

    [Theory]
    [InlineData("fanuc", FanucMain)]
    [InlineData("siemens-840d", SiemensMain)]
    public void The_caller_goes_on_behind_the_call_with_its_own_values(string dialect, string main)
    {
        var path = Run(dialect, main, before: "0.0");
        Assert.Null(path.Refusal);
        var last = path.Motions[^1];
        Assert.Equal((MotionKind.Line, 7.0, 5.0), (last.Kind, last.End.X, last.End.Y));
    }

    // The offset is neither what the program left nor what it is about to set. On Siemens, M30 here could return to the caller.
    [Fact]
    public void A_run_that_it_stops_does_not_go_on_in_the_caller()
    {
        var path = Run("siemens-840d", SiemensMain, before: "0.05");
        Assert.NotNull(path.Refusal);
        Assert.DoesNotContain(path.Motions, m => m.Kind == MotionKind.Line);
    }

    [Fact]
    public void No_program_of_offsets_ends_the_run_of_its_caller()
    {
        foreach (var dialect in NcDialects.All.Where(OffsetProgram.CanShift))
        {
            var text = Encoding.ASCII.GetString(Program(dialect.Name));
            Assert.DoesNotContain("M30", text, StringComparison.Ordinal);

            // LinuxCNC ends there only what was started by itself: a call returns at endsub.
            var ends = text.IndexOf("\nM2\n", StringComparison.Ordinal);
            Assert.True(ends < 0 || ends > text.IndexOf("endsub", StringComparison.Ordinal), dialect.Name);
            Assert.NotNull(OffsetProgram.CallOf(dialect, OffsetProgram.FileBeside(dialect, "boss.nc"), 9001));
        }
    }

    // What the control alone knows is put in: the offset has 0.1 mm and no correction.
    private static NcPath Run(string dialect, string main, string before)
    {
        var program = Encoding.ASCII.GetString(Program(dialect));
        program = program.Replace("#[12000+1]", "0.1", StringComparison.Ordinal).Replace("#4003", "90", StringComparison.Ordinal)
            .Replace("#4006", "21", StringComparison.Ordinal).Replace("#[5201+20*1]", "0", StringComparison.Ordinal)
            .Replace("#[5202+20*1]", "0", StringComparison.Ordinal).Replace("$TC_DP15[2,1]=", "R99=", StringComparison.Ordinal)
            .Replace("$TC_DP15[2,1]", "0.1", StringComparison.Ordinal);
        foreach (var frame in new[] { "X,FI", "Y,FI", "Z,RT" })
        {
            program = program.Replace($"$P_UIFR[1,{frame}]=", "R99=", StringComparison.Ordinal)
                .Replace($"$P_UIFR[1,{frame}]", "0", StringComparison.Ordinal);
        }

        var nc = NcDialects.Named(dialect);
        var call = OffsetProgram.CallOf(nc, OffsetProgram.FileBeside(nc, "boss.nc"), 9001);
        return NcInterpreter.Run(
            NcProgram.Read(Encoding.ASCII.GetBytes(main.Replace("{call}", call, StringComparison.Ordinal)
                .Replace("{before}", before, StringComparison.Ordinal)), nc.Syntax),
            nc,
            _ => NcProgram.Read(Encoding.ASCII.GetBytes(program), nc.Syntax),
            CancellationToken.None);
    }

    private static byte[] Program(string dialect)
    {
        var nc = NcDialects.Named(dialect);
        return OffsetProgram.Write(
            nc,
            new(1, 2, 0.02m, null),
            new(1, new(0.01m, -0.02m, 0), null),
            OffsetLimits.Default,
            501,
            9001,
            OffsetProgram.FileBeside(nc, "boss.nc"));
    }
}
