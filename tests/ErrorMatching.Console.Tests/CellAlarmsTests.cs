using System.Text.Json;
using ErrorMatching.Cell;

namespace ErrorMatching.Console.Tests;

/// <summary>What <c>cell alarms</c> lists, and what a person does about it.</summary>
public sealed class CellAlarmsTests : IDisposable
{
    private readonly CellFolder _cell = CellFolder.WithPeople();

    [Fact]
    public void A_cell_that_stands_is_listed_acknowledged_by_a_person_and_never_shelved()
    {
        var alarm = Only();
        Assert.Equal(
            ("cell", "high", false, false),
            (alarm.Text("key"), alarm.Text("priority"), Is(alarm, "isAcknowledged"), Is(alarm, "isShelved")));
        Assert.False(alarm.TryGetProperty("since", out _));
        Assert.Contains("The cell does not run.", Shell.Run("cell", "alarms", _cell.Config).Output, StringComparison.Ordinal);

        alarm = Only("--acknowledge", "cell", "--user", "Ben");
        Assert.Equal((true, "Ben"), (Is(alarm, "isAcknowledged"), alarm.Text("acknowledgedBy")));
        Assert.Equal((true, "Ben"), (Is(Only(), "isAcknowledged"), Only().Text("acknowledgedBy")));
        Assert.Equal("stays-in-sight", Code(2, "--shelve", "cell", "--hours", "1", "--user", "Anna"));
        Assert.Equal("unknown-alarm", Code(1, "--acknowledge", "no such", "--user", "Ben"));
    }

    [Fact]
    public void A_failed_correction_is_shelved_by_a_setter_and_brought_back()
    {
        Fail();
        Assert.Equal(["cell", "correction 1: failed"], Listed().Select(a => a.Text("key")));
        Assert.Equal("not-allowed", Code(2, "--shelve", "correction 1: failed", "--hours", "1", "--user", "Ben"));
        var shelved = Listed("--shelve", "correction 1: failed", "--hours", "0.5", "--user", "Anna")[1];
        Assert.Equal((true, "Anna"), (Is(shelved, "isShelved"), shelved.Text("shelvedBy")));
        Assert.InRange(
            shelved.GetProperty("shelvedUntil").GetDateTimeOffset() - DateTimeOffset.UtcNow,
            TimeSpan.FromMinutes(28),
            TimeSpan.FromMinutes(30));
        Assert.False(Is(Listed("--bring-back", "correction 1: failed", "--user", "Anna")[1], "isShelved"));
    }

    [Theory]
    [InlineData("--shelve", "cell")]
    [InlineData("--hours", "1")]
    [InlineData("--shelve", "cell", "--hours", "0")]
    [InlineData("--shelve", "cell", "--hours", "24.1")]
    [InlineData("--shelve", "cell", "--hours", "NaN")]
    [InlineData("--shelve", "cell", "--hours", "1", "--acknowledge", "cell")]
    public void What_cannot_be_meant_is_refused(params string[] options) =>
        Assert.Equal(1, Shell.Run(["cell", "alarms", _cell.Config, .. options]).Exit);

    public void Dispose() => _cell.Dispose();

    private void Fail()
    {
        var settings = CellSettingsReader.Read(_cell.Config);
        using var store = CellStore.Open(settings.Store, TimeProvider.System, AuditKey.Open(settings.KeysFolder));
        var arrived = store.Archive(new(settings.Gauges[0].Name, "S1.csv", "S1", "S1"u8.ToArray(), "trace")).Correction;
        var recognized = store.Step(
            arrived, CorrectionState.Recognized, "cell", "by name", c => c with { Job = settings.Jobs[0].Name, Serial = "S1" });
        store.Step(recognized, CorrectionState.Failed, "cell", "away", c => c with { Code = "machine-away", Reason = "away" });
    }

    private JsonElement Only(params string[] options) => Assert.Single(Listed(options));

    private JsonElement[] Listed(params string[] options) =>
        [.. Document(0, "errormatch/cell-alarms/1", options).GetProperty("alarms").EnumerateArray()];

    private string? Code(int exit, params string[] options) =>
        Document(exit, "errormatch/error/1", options).GetProperty("errors")[0].Text("code");

    // Signed with the password of the person after --user, if there is one.
    private JsonElement Document(int exit, string schema, string[] options)
    {
        string[] args = ["cell", "alarms", _cell.Config, .. options, "--json"];
        var (actual, output, _) = options is [.., "--user", var who]
            ? _cell.Piped([who == "Anna" ? CellFolder.Annas : CellFolder.Bens], args) : Shell.Run(args);
        var document = JsonDocument.Parse(output).RootElement;
        Assert.Equal((exit, schema), (actual, document.Text("schema")));
        return document;
    }

    private static bool Is(JsonElement alarm, string name) => alarm.GetProperty(name).GetBoolean();
}
