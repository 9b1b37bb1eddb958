using ErrorMatching.Refusals;

namespace ErrorMatching.Cell.Tests;

/// <summary>The broker in a configuration.</summary>
public sealed class EventSettingsTests : IDisposable
{
    private const string Pin = "sha256//47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=";
    private readonly CellFolder _cell = new();

    /// <summary>What is configured, and the path, code and part of the sentence of the only problem.</summary>
    public static TheoryData<string, string, string, string> Wrong => new()
    {
        { """{ "port": 8883 }""", "", "missing-key", "\"host\"" },
        { """{ "host": "b" }""", "", "pin-missing", "caFile" },
        { $$"""{ "host": "b", "caFile": "ca.pem", "pinnedKey": "{{Pin}}" }""", ".pinnedKey", "pin-beside-authority", "only one" },
        { """{ "host": "b", "tls": false, "caFile": "ca.pem" }""", ".caFile", "pin-without-tls", "not encrypted" },
        { """{ "host": "b", "tls": false, "passwordFile": "p" }""", ".passwordFile", "user-missing", "without a user" },
        { """{ "host": "b", "tls": false, "topic": "a/#" }""", ".topic", "pattern-mismatch", "without wildcards" },
        { """{ "host": "b", "tls": false, "topic": "$SYS" }""", ".topic", "pattern-mismatch", "without wildcards" },
        { """{ "host": "b", "pinnedKey": "sha256//short" }""", ".pinnedKey", "pattern-mismatch", "base 64" },
        { """{ "host": "b", "caFile": "incoming/ca.pem" }""", ".caFile", "inside-incoming", "the broker's authorities" },
        {
            $$"""{ "host": "b", "pinnedKey": "{{Pin}}", "user": "u", "passwordFile": "machine/p" }""",
            ".passwordFile",
            "inside-machine",
            "the broker's password"
        },
    };

    public void Dispose() => _cell.Dispose();

    [Theory]
    [MemberData(nameof(Wrong))]
    public void Each_wrong_thing_is_named_by_path_and_line(string events, string path, string code, string words)
    {
        var problem = Assert.Single(Assert.Throws<InputException>(() => Read(events)).Refusals);
        Assert.Equal((code, "$.events" + path, 2), (problem.Code, problem.Place.Path, problem.Place.Line));
        Assert.Contains(words, problem.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_broker_has_a_port_and_a_topic_by_default()
    {
        var encrypted = Read("""{ "host": "b", "caFile": "ca.pem" }""");
        var plain = Read("""{ "host": "b", "tls": false, "user": "cell", "topic": "a/b" }""");
        Assert.Equal(new("b", 8883, "errormatch/steps", null, null, true, _cell.PathOf("ca.pem"), null), encrypted.Events);
        Assert.Equal(new("b", 1883, "a/b", "cell", null, false, null, null), plain.Events);
        Assert.Equal("mqtt://cell@b:1883", plain.Events!.Address);
        Assert.Contains(plain.Warnings, w => w is { Code: "plain-mqtt", Place.Path: "$.events.tls" });
        Assert.Null(_cell.Read(CellFolder.Right).Events);
    }

    private CellSettings Read(string events) =>
        _cell.Read(CellFolder.With("\"kind\": \"cell\"", $"\"kind\": \"cell\", \"events\": {events}"));
}
