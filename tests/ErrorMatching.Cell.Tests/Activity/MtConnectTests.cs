using System.Globalization;
using System.Net;
using System.Net.Sockets;
using System.Text;

namespace ErrorMatching.Cell.Tests;

/// <summary>A small agent that answers as agents of MTConnect 1.3 to 2.x do.</summary>
public sealed class MtConnectTests
{
    // One channel, as agents of 1.3 describe it: controller and path.
    private static string One(string execution, string program = "O2001.NC", string mode = "AUTOMATIC", string stop = "ARMED",
        string condition = "Normal", string version = "1.3", string more = "") => $"""
        <?xml version="1.0" encoding="UTF-8"?>
        <MTConnectStreams xmlns:m="urn:mtconnect.org:MTConnectStreams:{version}" xmlns="urn:mtconnect.org:MTConnectStreams:{version}" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:schemaLocation="urn:mtconnect.org:MTConnectStreams:{version} http://schemas.mtconnect.org/schemas/MTConnectStreams_{version}.xsd">
          <Header creationTime="2026-11-26T08:00:00Z" sender="agent" instanceId="1764144000" version="{version}.0.9" bufferSize="131072" nextSequence="8042" firstSequence="1" lastSequence="8041"/>
          <Streams>{more}
            <DeviceStream name="VMC1" uuid="000-1">
              <ComponentStream component="Device" name="VMC1" componentId="d1">
                <Events><Availability dataItemId="avail" timestamp="2026-11-26T06:00:00.123Z" sequence="1">AVAILABLE</Availability></Events>
              </ComponentStream>
              <ComponentStream component="Linear" name="X" componentId="x">
                <Samples><Position dataItemId="xpos" subType="ACTUAL" timestamp="2026-11-26T07:59:59Z" sequence="8040">12.345</Position></Samples>
              </ComponentStream>
              <ComponentStream component="Controller" name="controller" componentId="c1">
                <Events><EmergencyStop dataItemId="estop" timestamp="2026-11-26T06:00:00Z" sequence="3">{stop}</EmergencyStop></Events>
                <Condition><{condition} dataItemId="logic" type="LOGIC_PROGRAM" timestamp="2026-11-26T06:00:00Z" sequence="4"/></Condition>
              </ComponentStream>
              <ComponentStream component="Path" name="path1" componentId="p1">
                <Events>
                  <ControllerMode dataItemId="mode" timestamp="2026-11-26T06:00:00Z" sequence="5">{mode}</ControllerMode>
                  <Execution dataItemId="exec" timestamp="2026-11-26T07:30:00.5Z" sequence="6">{execution}</Execution>
                  <Program dataItemId="pgm" timestamp="2026-11-26T07:30:00Z" sequence="7">{program}</Program>
                </Events>
              </ComponentStream>
            </DeviceStream>
          </Streams>
        </MTConnectStreams>
        """;

    [Theory]
    [InlineData("READY", MachineActivity.Idle)]
    [InlineData("PROGRAM_COMPLETED", MachineActivity.Idle)]
    [InlineData("ACTIVE", MachineActivity.Running)]
    [InlineData("WAIT", MachineActivity.Running)]
    [InlineData("INTERRUPTED", MachineActivity.Held)]
    [InlineData("FEED_HOLD", MachineActivity.Held)]
    [InlineData("STOPPED", MachineActivity.Held)]
    [InlineData("OPTIONAL_STOP", MachineActivity.Held)]
    [InlineData("PROGRAM_STOPPED", MachineActivity.Held)]
    [InlineData("PROGRAM_OPTIONAL_STOP", MachineActivity.Held)]
    public async Task The_execution_says_what_the_machine_is_doing(string execution, MachineActivity activity)
    {
        foreach (var version in new[] { "1.3", "1.8", "2.0", "2.5" })
        {
            var state = await AskAsync(One(execution, version: version));
            Assert.Equal((activity, null), (state.Activity, state.Code));
            Assert.Equal(activity != MachineActivity.Idle, state.Uses(new ProgramIdentity("O2001.NC")));
            Assert.False(state.Uses(new ProgramIdentity("O2002.NC")));
            Assert.Equal(DateTimeOffset.Parse("2026-11-26T07:30:00.5Z", CultureInfo.InvariantCulture), state.Since);
        }
    }

    [Fact]
    public async Task An_adapter_that_reports_a_reset_as_stopped_can_be_told_so() => Assert.Equal(
        MachineActivity.Idle, (await AskAsync(One("STOPPED"), s => s with { StoppedIsIdle = true })).Activity);

    [Fact]
    public async Task A_program_that_is_edited_at_the_control_is_in_use() =>
        Assert.True((await AskAsync(One("READY", mode: "EDIT"))).Uses(new ProgramIdentity("O2001.NC")));

    [Theory]
    [InlineData("TRIGGERED", "Normal")]
    [InlineData("ARMED", "Fault")]
    public async Task Emergency_stop_and_faults_of_the_control_are_an_alarm(string stop, string condition)
    {
        var state = await AskAsync(One("READY", stop: stop, condition: condition));
        Assert.Equal((MachineActivity.Alarm, true), (state.Activity, state.Uses(new ProgramIdentity("O2001.NC"))));
        Assert.False(state.Uses(new ProgramIdentity("O9.NC")));
    }

    [Theory]
    [InlineData("UNAVAILABLE", "O2001.NC", MachineActivity.Unknown)]
    [InlineData("ACTIVE", "UNAVAILABLE", MachineActivity.Running)]
    [InlineData("ACTIVE", "", MachineActivity.Running)]
    public async Task What_is_unavailable_is_not_taken_for_idle_or_for_another_program(
        string execution, string program, MachineActivity activity)
    {
        var state = await AskAsync(One(execution, program));
        Assert.Equal((activity, true, null), (state.Activity, state.Uses(new ProgramIdentity("O9.NC")), state.Code));
    }

    // Two paths, one of them busy: what is only selected in the idle one is free.
    [Theory]
    [InlineData("ACTIVE", "O1", "READY", "O2", "O1", true)]
    [InlineData("ACTIVE", "O1", "READY", "O2", "O2", false)]
    [InlineData("READY", "O1", "INTERRUPTED", "O2", "O2", true)]
    [InlineData("READY", "O1", "READY", "O2", "O1", false)]
    [InlineData("READY", "O1", "UNAVAILABLE", "O2", "O1", true)]
    public async Task Every_path_has_a_say(string first, string program, string second, string other, string asked, bool isUsed)
    {
        var two = One(first, program).Replace(
            "</DeviceStream>",
            $"""<ComponentStream component="Path" name="path2" componentId="p2"><Events><Execution dataItemId="e2" timestamp="2026-11-26T07:30:00Z" sequence="9">{second}</Execution><Program dataItemId="g2" timestamp="2026-11-26T07:30:00Z" sequence="10">{other}</Program></Events></ComponentStream></DeviceStream>""",
            StringComparison.Ordinal);
        Assert.Equal(isUsed, (await AskAsync(two)).Uses(new ProgramIdentity(asked)));
    }

    [Fact]
    public async Task A_main_program_and_the_active_one_are_both_in_use()
    {
        var state = await AskAsync(One("ACTIVE").Replace("</Program>", """</Program><Program dataItemId="a" subType="ACTIVE" timestamp="2026-11-26T07:30:00Z" sequence="8">O77</Program>""", StringComparison.Ordinal));
        Assert.True(state.Uses(new ProgramIdentity("O2001.NC")) && state.Uses(new ProgramIdentity("O77.NC")));
        Assert.False(state.Uses(new ProgramIdentity("O1.NC")));
    }

    [Fact]
    public async Task One_of_several_devices_must_be_named_and_the_agent_itself_is_none()
    {
        const string agent = """<DeviceStream name="Agent" uuid="a"><ComponentStream component="Agent" name="Agent" componentId="a0"><Events><Availability dataItemId="aa" timestamp="2026-11-26T06:00:00Z" sequence="1">AVAILABLE</Availability></Events></ComponentStream></DeviceStream>""";
        const string other = """<DeviceStream name="VMC2" uuid="000-2"><ComponentStream component="Path" name="p" componentId="q1"><Events><Execution dataItemId="qe" timestamp="2026-11-26T06:00:00Z" sequence="1">ACTIVE</Execution></Events></ComponentStream></DeviceStream>""";
        Assert.Equal(MachineActivity.Idle, (await AskAsync(One("READY", version: "2.0", more: agent))).Activity);
        var several = One("READY", more: other);
        Assert.Contains("VMC2, VMC1", (await AskAsync(several)).Why!.Sentence, StringComparison.Ordinal);
        Assert.Equal(MachineActivity.Idle, (await AskAsync(several, s => s with { Device = "VMC1" })).Activity);
        Assert.Equal(MachineActivity.Running, (await AskAsync(several, s => s with { Device = "000-2" })).Activity);
        Assert.Equal("state-wrong", (await AskAsync(several, s => s with { Device = "VMC3" })).Code);
    }

    [Fact]
    public async Task The_device_is_part_of_the_address()
    {
        var heard = "";
        await AskAsync(One("READY"), s => s with { Device = "VMC1" }, heard: h => heard = h);
        Assert.StartsWith("GET /VMC1/current HTTP/1.1", heard, StringComparison.Ordinal);
        await AskAsync(One("READY"), heard: h => heard = h);
        Assert.StartsWith("GET /current HTTP/1.1", heard, StringComparison.Ordinal);
        Assert.Contains("no-cache", heard, StringComparison.Ordinal);
    }

    public static TheoryData<string> Hostile =>
    [
        "",
        "not xml",
        "<MTConnectDevices/>",
        "<MTConnectStreams/>",
        "<MTConnectStreams><Streams><DeviceStream name=\"V\"/></Streams></MTConnectStreams>",
        "<MTConnectError><Errors><Error errorCode=\"NO_DEVICE\">no such device</Error></Errors></MTConnectError>",
        "<!DOCTYPE x [<!ENTITY e SYSTEM \"file:///etc/passwd\">]>" + One("&e;")[(One("").IndexOf('\n', StringComparison.Ordinal) + 1)..],
        "<!DOCTYPE x [<!ENTITY a \"READY\"><!ENTITY b \"&a;&a;&a;\">]><MTConnectStreams>&b;</MTConnectStreams>",
        One("<b>READY</b>"),
        One("RESTING"),
        One("READY")[..^40],
        string.Concat(Enumerable.Repeat("<MTConnectStreams>", 200)),
        "<MTConnectStreams><Streams><DeviceStream name=\"V\"><ComponentStream componentId=\"c\">"
            + string.Concat(Enumerable.Repeat("<Execution>READY</Execution>", 201))
            + "</ComponentStream></DeviceStream></Streams></MTConnectStreams>",
    ];

    [Theory]
    [MemberData(nameof(Hostile))]
    public async Task Any_other_document_is_unknown(string document)
    {
        var state = await AskAsync(document);
        Assert.Equal((MachineActivity.Unknown, "state-wrong"), (state.Activity, state.Code));
        Assert.InRange(state.Why!.Sentence.Length, 20, 500);
        Assert.DoesNotContain("root:", state.Why.Sentence, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_redirect_is_not_followed_a_cached_answer_is_none_and_an_answer_has_its_limits()
    {
        var moved = await AskAsync("", status: "302 Found\r\nLocation: http://127.0.0.1:1/");
        Assert.Contains("elsewhere", moved.Why!.Sentence, StringComparison.Ordinal);
        Assert.Equal("state-wrong", (await AskAsync("", status: "500 Internal Server Error")).Code);
        Assert.Equal("state-stale", (await AskAsync(One("READY"), status: "200 OK\r\nAge: 30")).Code);
        Assert.Equal("state-wrong", (await AskAsync(One("READY") + new string(' ', 5 << 20))).Code);
        Assert.Equal("state-away", (await AskAsync("", status: null)).Code);
        Assert.Equal("state-slow", (await AskAsync("", s => s with { Timeout = TimeSpan.FromSeconds(0.2) }, status: "")).Code);
    }

    private static async Task<MachineState> AskAsync(
        string document, Func<MtConnectSettings, MtConnectSettings>? with = null, string? status = "200 OK", Action<string>? heard = null)
    {
        var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start();
        using var end = new CancellationTokenSource();
        var serving = ServeAsync(listener, document, status, heard, end.Token);
        var url = new Uri($"http://127.0.0.1:{((IPEndPoint)listener.LocalEndpoint).Port}");
        var settings = new MtConnectSettings(url, null, false) { Timeout = TimeSpan.FromSeconds(20) };
        var state = await (with?.Invoke(settings) ?? settings).Open(TimeProvider.System).AskAsync(TestContext.Current.CancellationToken);
        await end.CancelAsync();
        await serving;
        listener.Dispose();
        return state;
    }

    // One question and its answer: status null closes the connection, and an empty one never answers.
    private static async Task ServeAsync(
        TcpListener listener, string document, string? status, Action<string>? heard, CancellationToken end)
    {
        try
        {
            using var client = await listener.AcceptTcpClientAsync(end);
            var stream = client.GetStream();
            var question = new StringBuilder();
            var buffer = new byte[4096];
            while (!question.ToString().EndsWith("\r\n\r\n", StringComparison.Ordinal))
                question.Append(Encoding.ASCII.GetString(buffer, 0, await stream.ReadAsync(buffer, end)));
            heard?.Invoke(question.ToString());
            if (status is null)
            {
                listener.Stop();
                return;
            }

            if (status.Length == 0)
                await Task.Delay(Timeout.Infinite, end);
            var body = Encoding.UTF8.GetBytes(document);
            var head = $"HTTP/1.1 {status}\r\nContent-Type: text/xml\r\nContent-Length: {body.Length}\r\nConnection: close\r\n\r\n";
            await stream.WriteAsync(Encoding.ASCII.GetBytes(head), end);
            await stream.WriteAsync(body, end);
            client.Client.Shutdown(SocketShutdown.Send);
            await Task.Delay(Timeout.Infinite, end);
        }
        catch (Exception e) when (e is OperationCanceledException or IOException)
        {
            // The test ends, or the client has read enough.
        }
    }
}
