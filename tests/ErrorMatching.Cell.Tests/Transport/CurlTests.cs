using System.Text;

namespace ErrorMatching.Cell.Tests;

/// <summary>What curl is told and what it says. That curl reads it so is tested against a real server,
/// in ErrorMatching.Peers.Tests.</summary>
public sealed class CurlTests
{
    [Theory]
    [InlineData("plain", "user = \"plain\"\n")]
    [InlineData("a\"b", "user = \"a\\\"b\"\n")]
    [InlineData("a\\b\\", "user = \"a\\\\b\\\\\"\n")]
    [InlineData("a\nurl = x", "user = \"a\\nurl = x\"\n")]
    [InlineData("a\r\t\v", "user = \"a\\r\\t\\v\"\n")]
    [InlineData("# - = ' $(id) %41", "user = \"# - = ' $(id) %41\"\n")]
    public void Any_value_stays_one_value(string value, string line) =>
        Assert.Equal(line, Encoding.UTF8.GetString(new CurlConfig().Set("user", value).ToBytes()));

    [Theory]
    [InlineData(6, 0, TransportError.Away)]
    [InlineData(7, 0, TransportError.Away)]
    [InlineData(9, 550, TransportError.Denied)]
    [InlineData(18, 226, TransportError.Away)]
    [InlineData(18, 150, TransportError.Away)]
    [InlineData(25, 552, TransportError.Full)]
    [InlineData(25, 452, TransportError.Full)]
    [InlineData(25, 553, TransportError.Denied)]
    [InlineData(25, 550, TransportError.Denied)]
    [InlineData(25, 450, TransportError.Unknown)]
    [InlineData(70, 552, TransportError.Full)]
    [InlineData(28, 150, TransportError.Slow)]
    [InlineData(28, 421, TransportError.Away)]
    [InlineData(35, 234, TransportError.Away)]
    [InlineData(51, 234, TransportError.WrongServer)]
    [InlineData(60, 234, TransportError.WrongServer)]
    [InlineData(90, 234, TransportError.WrongServer)]
    [InlineData(64, 500, TransportError.WrongServer)]
    [InlineData(55, 150, TransportError.Away)]
    [InlineData(56, 150, TransportError.Away)]
    [InlineData(56, 426, TransportError.Away)]
    [InlineData(67, 530, TransportError.Login)]
    [InlineData(67, 421, TransportError.Away)]
    [InlineData(78, 550, TransportError.Denied)]
    [InlineData(21, 550, TransportError.Denied)]
    [InlineData(21, 421, TransportError.Away)]
    [InlineData(1, 0, TransportError.ToolMissing)]
    [InlineData(27, 0, TransportError.Unknown)]
    public void An_exit_code_and_the_servers_answer_name_the_error(int exit, int response, TransportError error) =>
        Assert.Equal(
            error,
            new CurlAnswer(new ToolResult(ToolEnd.Exited, exit, [], $"curl: ({exit}) words\nerrormatch-answer {response:000}\n")).Error);

    [Fact]
    public void The_last_answer_counts_and_words_and_codes_are_said()
    {
        var answer = new CurlAnswer(new ToolResult(
            ToolEnd.Exited, 25, [], "errormatch-answer 226\ncurl: (25) Failed FTP upload: 552\nerrormatch-answer 552\n"));
        Assert.Equal("the server answered 552, no room (curl 25: Failed FTP upload: 552)", answer.Text);
        Assert.Null(new CurlAnswer(new ToolResult(ToolEnd.Exited, 0, [], "errormatch-answer 226\n")).Error);
    }
}
