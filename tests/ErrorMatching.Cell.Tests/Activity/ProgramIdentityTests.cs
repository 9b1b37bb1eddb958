using System.Text;

namespace ErrorMatching.Cell.Tests;

/// <summary>A program is in use by any of the names that the control may have for it, and by a name that says too little.</summary>
public sealed class ProgramIdentityTests
{
    [Theory]
    [InlineData("delta-nc300", "O2001.NC", "O0240", "O0240")]
    [InlineData("delta-nc300", "O2001.NC", "O0240", "240")]
    [InlineData("delta-nc300", "O2001.NC", "O0240", "//CNC_MEM/USER/PATH1/O0240")]
    [InlineData("delta-nc300", "O2001.NC", "O0240", "//CNC_MEM/USER/PATH1/o240")]
    [InlineData("delta-nc300", "O2001.NC", "O0240", "O0240(KEY A/B)")]
    [InlineData("delta-nc300", "O2001.NC", "O0240", "O0240 (KEY)")]
    [InlineData("delta-nc300", "O2001.NC", "O0240", "O00240.MPF")]
    [InlineData("delta-nc300", "O2001.NC", "O0240", "O2001")]
    [InlineData("delta-nc300", "FINISH.NC", "O0240\nM30\nO0241", "O241")]
    [InlineData("delta-nc300", "FINISH.NC", "<KEY>", @"\MEM\key")]
    [InlineData("siemens-840d", "FINISH.MPF", "%_N_P100_MPF", "/_N_WKS_DIR/_N_KEY_WPD/_N_P100_MPF")]
    [InlineData("siemens-840d", "FINISH.MPF", "%_N_P100_MPF", "//NC:/WKS.DIR/P100.MPF")]
    [InlineData("heidenhain-klartext", "FINISH.H", "0 BEGIN PGM KEY MM", @"TNC:\NC\KEY.H")]
    [InlineData("linuxcnc", "FINISH.NGC", "O0240", "/nc/files/finish.ngc")]
    public void A_program_is_each_that_the_control_calls_so(string dialect, string file, string text, string reported) =>
        Assert.True(Running(reported).Uses(Identity(dialect, file, text)));

    [Theory]
    [InlineData("delta-nc300", "O2001.NC", "O2001", "O0240")]
    [InlineData("delta-nc300", "FINISH.NC", "O0240", "O0101")]
    [InlineData("delta-nc300", "O2001.NC", "(NO NUMBER)", "O0240")]
    [InlineData("delta-nc300", "FINISH.NC", "(NO NUMBER)", "/nc/MAIN.NC")]
    [InlineData("linuxcnc", "FINISH.NGC", "O0240", "O0240")]
    [InlineData("siemens-840d", "P100.MPF", "G0 X0", "P240.MPF")]
    public void Another_program_is_not_this_one(string dialect, string file, string text, string reported) =>
        Assert.False(Running(reported).Uses(Identity(dialect, file, text)));

    // The control calls programs by numbers, and nobody knows the number of this one; or it says something that is no name.
    [Theory]
    [InlineData("delta-nc300", "FINISH.NC", "(NO NUMBER)", "O0240")]
    [InlineData("delta-nc300", "FINISH.NC", "", "240")]
    [InlineData("no-such-dialect", "FINISH.NC", "O0001", "O0240")]
    [InlineData("linuxcnc", "FINISH.NGC", "G0", "")]
    [InlineData("linuxcnc", "FINISH.NGC", "G0", "/nc/")]
    [InlineData("siemens-840d", "LONG_NAME.MPF", "G0", @"C:\NC\LONG_N~1.MPF")]
    [InlineData("siemens-840d", "P100.MPF", "G0", "P\uFFFD00.MPF")]
    public void What_cannot_be_compared_may_be_this_one(string dialect, string file, string text, string reported) =>
        Assert.True(Running(reported).Uses(Identity(dialect, file, text)));

    [Theory]
    [InlineData("delta-nc300", "O2001.NC", "O0240", "O0240")]
    [InlineData("delta-nc300", "2001", "O0240", "O0240")]
    [InlineData("delta-nc300", "O2001.NC", "O02001 (KEY)", null)]
    [InlineData("delta-nc300", "FINISH.NC", "O0240", null)]
    [InlineData("delta-nc300", "O2001.NC", "(NO NUMBER)", null)]
    [InlineData("delta-nc300", "O2001.NC", "O0001\nM30\nO2001", null)]
    [InlineData("siemens-840d", "P100.MPF", "%_N_P200_MPF", "_N_P200_MPF")]
    [InlineData("siemens-840d", "P100.MPF", "%_N_P100_MPF", null)]
    [InlineData("siemens-840d", "P100.MPF", "%P100", null)]
    [InlineData("heidenhain-klartext", "FINISH.H", "0 BEGIN PGM KEY MM", "KEY")]
    [InlineData("heidenhain-klartext", "KEY.H", "0 BEGIN PGM key MM", null)]
    [InlineData("linuxcnc", "O2001.NGC", "O0240", null)]
    public void A_file_and_the_head_of_its_program_agree_or_not(string dialect, string file, string text, string? other) =>
        Assert.Equal(other, Identity(dialect, file, text).OtherHead);

    [Theory]
    [InlineData("delta-nc300", "O2001.NC", "O2001", "FINISH.NC", "O2001", true)]
    [InlineData("delta-nc300", "FINISH.NC", "O0240", "0240.TXT", "", true)]
    [InlineData("delta-nc300", "FINISH.NC", "O0240", "O0241.NC", "O0241", false)]
    [InlineData("siemens-840d", "P100.MPF", "", "_N_P100_MPF", "", true)]
    [InlineData("siemens-840d", "P100.MPF", "", "P100.SPF", "", false)]
    [InlineData("linuxcnc", "KEY.NGC", "O0240", "O0240.NGC", "O0240", false)]
    public void Two_programs_of_a_machine_share_a_name_or_not(
        string dialect, string file, string text, string otherFile, string otherText, bool isShared)
    {
        var (one, other) = (Identity(dialect, file, text), Identity(dialect, otherFile, otherText));
        Assert.Equal((isShared, isShared), (one.SharedWith(other) is not null, other.SharedWith(one) is not null));
    }

    // A long path is kept by its end, for there the program's name is.
    [Fact]
    public async Task A_program_in_a_deep_folder_is_in_use()
    {
        using var folder = new Testing.TemporaryFolder();
        var deep = string.Concat(Enumerable.Repeat("/a-folder-with-a-name", 20));
        var file = folder.File("plc.txt", $"STATE=RUNNING\nPROGRAM={deep}/FINISH.NGC\nEND\n");
        var source = new StateFileSettings(file, TimeSpan.FromDays(1)).Open(TimeProvider.System);
        var state = await source.AskAsync(TestContext.Current.CancellationToken);
        Assert.True(state.Uses(new("FINISH.NGC")));
        Assert.False(state.Uses(new("OTHER.NGC")));
    }

    private static MachineState Running(string reported) => ToldState.Of(MachineActivity.Running, reported);

    private static ProgramIdentity Identity(string dialect, string file, string text) => MachinePrograms.Identify(
        new()
        {
            Name = "mill",
            Dialect = dialect,
            Transport = new FolderSettings("nowhere"),
            Slots = [],
            Timeout = TimeSpan.FromSeconds(1),
            Attempts = 1,
        },
        file,
        [Encoding.ASCII.GetBytes(text + "\nG0 X0\nM30\n")]);
}
