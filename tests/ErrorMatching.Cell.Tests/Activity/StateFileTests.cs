using System.Text;

namespace ErrorMatching.Cell.Tests;

public sealed class StateFileTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("errormatch-state-").FullName;

    private string StatePath => Path.Combine(_folder, "vmc1.txt");

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Theory]
    [InlineData("STATE=IDLE\nEND\n", MachineActivity.Idle, null)]
    [InlineData("STATE=IDLE\r\nPROGRAM=O1.NC\r\nEND\r\n", MachineActivity.Idle, "O1.NC")]
    [InlineData("PROGRAM=O1.NC\nPROGRAM=O2.NC\nSTATE=RUNNING\nEND", MachineActivity.Running, "O1.NC, O2.NC")]
    [InlineData("STATE=HELD\nPROGRAM=\nEND\n", MachineActivity.Held, "")]
    [InlineData("STATE=ALARM\n\nPROGRAM= O1.NC \nEND\n\n", MachineActivity.Alarm, "O1.NC")]
    public async Task A_file_says_what_the_machine_is_doing(string text, MachineActivity activity, string? programs)
    {
        var state = await AskAsync(text);
        Assert.Equal((activity, programs, null), (state.Activity, state.Programs is { } p ? string.Join(", ", p) : null, state.Code));
    }

    [Fact]
    public async Task A_file_may_say_since_when() => Assert.Equal(
        new DateTimeOffset(2026, 11, 26, 8, 0, 0, TimeSpan.Zero), (await AskAsync("STATE=IDLE\nSINCE=2026-11-26T08:00:00Z\nEND\n")).Since);

    [Theory]
    [InlineData("")]
    [InlineData("END\n")]
    [InlineData("STATE=IDLE\n")]
    [InlineData("STATE=IDLE\nEN")]
    [InlineData("STATE=READY\nEND\n")]
    [InlineData("STATE=idle\nEND\n")]
    [InlineData("STATE=IDLE\nSTATE=RUNNING\nEND\n")]
    [InlineData("STATE=IDLE\nSPINDLE=0\nEND\n")]
    [InlineData("STATE=IDLE\nSINCE=yesterday\nEND\n")]
    [InlineData("STATE=IDLE\nEND\nSTATE=RUNNING\n")]
    [InlineData("\0\0\0\0")]
    public async Task Half_a_file_and_any_other_text_say_nothing(string text)
    {
        var state = await AskAsync(text);
        Assert.Equal((MachineActivity.Unknown, "state-wrong"), (state.Activity, state.Code));
        Assert.Contains(StatePath, state.Why!.Sentence, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_file_that_is_just_being_rewritten_is_read_again()
    {
        File.WriteAllText(StatePath, "STATE=ID");
        var asking = Source().AskAsync(TestContext.Current.CancellationToken);
        File.WriteAllText(StatePath, "STATE=IDLE\nEND\n");
        Assert.Equal(MachineActivity.Idle, (await asking).Activity);
    }

    [Theory]
    [InlineData(9, null)]
    [InlineData(11, "state-stale")]
    [InlineData(-9, null)]
    [InlineData(-11, "state-stale")]
    public async Task A_file_that_is_too_old_or_from_the_future_says_nothing(int age, string? code)
    {
        File.WriteAllText(StatePath, "STATE=IDLE\nEND\n");
        File.SetLastWriteTimeUtc(StatePath, TimeProvider.System.GetUtcNow().UtcDateTime.AddSeconds(-age));
        var state = await Source().AskAsync(TestContext.Current.CancellationToken);
        Assert.Equal((code is null ? MachineActivity.Idle : MachineActivity.Unknown, code), (state.Activity, state.Code));
    }

    [Fact]
    public async Task A_file_that_is_missing_too_long_a_link_or_a_folder_says_nothing()
    {
        var source = Source();
        Assert.Equal("state-away", (await source.AskAsync(TestContext.Current.CancellationToken)).Code);
        Assert.Equal("state-wrong", (await AskAsync("STATE=IDLE\n" + new string(' ', 4096) + "\nEND\n")).Code);
        File.Delete(StatePath);
        File.WriteAllText(StatePath + ".elsewhere", "STATE=IDLE\nEND\n");
        File.CreateSymbolicLink(StatePath, StatePath + ".elsewhere");
        Assert.Equal("state-away", (await source.AskAsync(TestContext.Current.CancellationToken)).Code);
        File.Delete(StatePath);
        Directory.CreateDirectory(StatePath);
        Assert.Equal("state-away", (await source.AskAsync(TestContext.Current.CancellationToken)).Code);
    }

    [Fact]
    public async Task What_is_quoted_is_short_and_cannot_steer_a_screen()
    {
        var why = (await AskAsync("STATE=\u202E\u0007" + new string('x', 3000) + "\nEND\n")).Why!.Sentence;
        Assert.InRange(why.Length, 100, 500);
        Assert.DoesNotContain(why, c => char.IsControl(c) || c == '\u202E');
    }

    private Task<MachineState> AskAsync(string text)
    {
        File.WriteAllBytes(StatePath, Encoding.UTF8.GetBytes(text));
        return Source().AskAsync(TestContext.Current.CancellationToken);
    }

    private MachineStateSource Source() => new StateFileSettings(StatePath, TimeSpan.FromSeconds(10)).Open(TimeProvider.System);
}
