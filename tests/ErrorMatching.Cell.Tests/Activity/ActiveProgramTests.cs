namespace ErrorMatching.Cell.Tests;

public sealed class ActiveProgramTests
{
    [Theory]
    [InlineData("O2001.NC", "O2001.NC")]
    [InlineData("o2001.nc", "O2001.NC")]
    [InlineData("/srv/cnc/nc_files/O2001.NC", "O2001.NC")]
    [InlineData(@"C:\NC\O2001.NC", "O2001.NC")]
    [InlineData("//CNC_MEM/USER/PATH1/O2001", "O2001.NC")]
    [InlineData("O2001", "O2001.NC")]
    [InlineData("2001", "O2001.NC")]
    [InlineData("O0100", "O100")]
    [InlineData("100", "O0100")]
    [InlineData(" \"P100.MPF\" ", "P100.MPF")]
    [InlineData("/_N_MPF_DIR/_N_P100_MPF", "P100.MPF")]
    [InlineData("//NC:/MPF.DIR/P100.MPF", "P100.MPF")]
    public void Names_of_one_program_are_the_same(string reported, string file) => Assert.True(ActiveProgram.IsSame(reported, file));

    [Theory]
    [InlineData("O2002.NC", "O2001.NC")]
    [InlineData("O2001.MPF", "O2001.NC")]
    [InlineData("2002", "O2001.NC")]
    [InlineData("O2001.NC/O1.NC", "O2001.NC")]
    [InlineData("P2001", "O2001.NC")]
    public void Names_of_two_programs_are_not(string reported, string file) => Assert.False(ActiveProgram.IsSame(reported, file));

    [Theory]
    [InlineData(MachineActivity.Idle, false)]
    [InlineData(MachineActivity.Running, true)]
    [InlineData(MachineActivity.Held, true)]
    [InlineData(MachineActivity.Alarm, true)]
    [InlineData(MachineActivity.Unknown, true)]
    public void A_program_is_in_use_unless_the_machine_is_idle_or_has_another_one(MachineActivity activity, bool isUsed)
    {
        Assert.Equal(isUsed, ToldState.Of(activity, "A.NC", "P1.NC").Uses(new ProgramIdentity("P1.NC")));
        Assert.Equal(isUsed, new MachineState(activity, null, null).Uses(new ProgramIdentity("P1.NC")));
        Assert.Equal(activity == MachineActivity.Unknown, ToldState.Of(activity, "A.NC").Uses(new ProgramIdentity("P1.NC")));
        Assert.Equal(activity == MachineActivity.Unknown, ToldState.Of(activity).Uses(new ProgramIdentity("P1.NC")));
    }
}
