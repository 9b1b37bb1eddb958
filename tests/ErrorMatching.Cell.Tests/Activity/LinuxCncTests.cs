namespace ErrorMatching.Cell.Tests;

/// <summary>The line protocol, with answers as linuxcncrsh 2.9 gives them. A real control is asked in the tests with peers.</summary>
public sealed class LinuxCncTests
{
    private const string Path = "/srv/cnc/nc_files/O1.NC";

    [Theory]
    [InlineData("OFF", "IDLE", "NONE", MachineActivity.Idle, "")]
    [InlineData("OFF", "IDLE", Path, MachineActivity.Idle, Path)]
    [InlineData("OFF", "RUNNING", Path, MachineActivity.Running, Path)]
    [InlineData("OFF", "PAUSED", Path, MachineActivity.Held, Path)]
    [InlineData("ON", "IDLE", Path, MachineActivity.Alarm, Path)]
    [InlineData("ON", "IDLE", "NONE", MachineActivity.Alarm, "")]
    public async Task The_control_says_what_it_is_doing(
        string estop, string status, string program, MachineActivity activity, string programs)
    {
        var state = await AskAsync(q => Answer(q, estop, status, program));
        Assert.Equal((activity, programs, null), (state.Activity, string.Join(",", state.Programs!), state.Code));
    }

    [Fact]
    public async Task Only_questions_are_sent()
    {
        await using var server = new LineServer(q => Answer(q, "OFF", "IDLE", "NONE"));
        await new LinuxCncSettings("127.0.0.1", server.Port).Open(TimeProvider.System).AskAsync(TestContext.Current.CancellationToken);
        Assert.All(server.Heard.Skip(1), l => Assert.StartsWith("get ", l, StringComparison.Ordinal));
        Assert.Equal("get program_status", server.Heard.Last());
    }

    [Fact]
    public async Task A_refused_password_does_not_matter_for_reading() => Assert.Equal(
        MachineActivity.Running,
        (await AskAsync(
            q => q.StartsWith("hello", StringComparison.Ordinal) ? "HELLO NAK\r\n" : Answer(q, "OFF", "RUNNING", Path))).Activity);

    [Fact]
    public async Task A_program_that_starts_while_the_control_is_asked_is_asked_for_again()
    {
        var asked = 0;
        var state = await AskAsync(q => q == "get program_status" && Interlocked.Increment(ref asked) == 1
            ? "PROGRAM_STATUS IDLE\r\n"
            : Answer(q, "OFF", "RUNNING", Path));
        Assert.Equal((MachineActivity.Running, 4), (state.Activity, asked));
    }

    [Theory]
    [InlineData("PROGRAM_STATUS BUSY\r\n", "state-wrong")]
    [InlineData("GET PROGRAM_STATUS NAK\r\n", "state-wrong")]
    [InlineData("\u202E\u0007\r\n", "state-wrong")]
    [InlineData("\r\n\r\n\r\n\r\n\r\n\r\n\r\n", "state-wrong")]
    [InlineData(null, "state-away")]
    [InlineData("", "state-slow")]
    [InlineData("PROGRAM_STATUS IDLE", "state-slow")]
    public async Task Anything_else_is_unknown(string? answer, string code)
    {
        var state = await AskAsync(
            q => q == "get program_status" ? answer : Answer(q, "OFF", "IDLE", "NONE"), code == "state-slow" ? 0.3 : 20);
        Assert.Equal((MachineActivity.Unknown, code), (state.Activity, state.Code));
        Assert.DoesNotContain(state.Why!.Sentence, char.IsControl);
    }

    [Fact]
    public async Task An_answer_without_end_is_not_read_to_its_end() =>
        Assert.Equal("state-wrong", (await AskAsync(_ => new string('x', 100_000))).Code);

    [Fact]
    public async Task A_control_that_is_not_there_is_unknown()
    {
        int port;
        await using (var server = new LineServer(_ => null))
            port = server.Port;
        Assert.Equal(
            "state-away",
            (await new LinuxCncSettings("127.0.0.1", port).Open(TimeProvider.System).AskAsync(TestContext.Current.CancellationToken)).Code);
    }

    private static string? Answer(string question, string estop, string status, string program) => question switch
    {
        "get estop" => $"{question}\r\nESTOP {estop}\r\n",
        "get program_status" => $"{question}\r\nPROGRAM_STATUS {status}\r\n",
        "get program" => $"{question}\r\nPROGRAM {program}\r\n",
        _ when question.StartsWith("hello EMC ", StringComparison.Ordinal) => "HELLO ACK EMCNETSVR 1.1\r\n",
        _ => null,
    };

    private static async Task<MachineState> AskAsync(Func<string, string?> answer, double limit = 20)
    {
        await using var server = new LineServer(answer);
        var settings = new LinuxCncSettings("127.0.0.1", server.Port) { Timeout = TimeSpan.FromSeconds(limit) };
        return await settings.Open(TimeProvider.System).AskAsync(TestContext.Current.CancellationToken);
    }
}
