using System.Text.Json;
using ErrorMatching.Cell;

namespace ErrorMatching.Console.Tests;

/// <summary>What <c>cell status</c> says and ends with, for each kind of trouble that a cell can have.</summary>
public sealed class CellStatusTests : IDisposable
{
    private static readonly DateTimeOffset Since = new(2026, 11, 21, 20, 0, 0, TimeSpan.Zero);
    private readonly CellFolder _cell = new();
    private readonly CellSettings _settings;

    public CellStatusTests()
    {
        _settings = CellSettingsReader.Read(_cell.Config);
        CellStore.Open(_settings.Store, TimeProvider.System, AuditKey.Open(_settings.KeysFolder)).Dispose();
    }

    [Fact]
    public void A_cell_that_runs_and_has_nothing_to_do_is_well()
    {
        using var life = Alive();
        var json = IsWell();
        Assert.Equal(
            (true, 17, 0),
            (
                json.GetProperty("running").GetBoolean(),
                json.GetProperty("processId").GetInt32(),
                json.GetProperty("problems").GetArrayLength()));
        Assert.Equal(Since, json.GetProperty("since").GetDateTimeOffset());
        Assert.Contains("Nothing to do.", Shell.Run("cell", "status", _cell.Config).Output, StringComparison.Ordinal);
    }

    [Fact]
    public void What_waits_at_a_gauge_is_counted_and_too_much_of_it_is_a_problem()
    {
        using (Alive(h => h with { Backlog = [new("cmm", 1069, Since, 3, null)] }))
        {
            var backlog = IsWell().GetProperty("backlog")[0];
            Assert.Equal(
                ("cmm", 1069, 3, Since, false),
                (
                    backlog.Text("gauge"),
                    backlog.GetProperty("files").GetInt32(),
                    backlog.GetProperty("pieces").GetInt32(),
                    backlog.GetProperty("oldestSince").GetDateTimeOffset(),
                    backlog.GetProperty("growing").GetBoolean()));
            Assert.Contains(
                "cmm: waiting since 2026-11-21 20:00:00Z: files 1069, measurements not computed 3",
                Shell.Run("cell", "status", _cell.Config).Output,
                StringComparison.Ordinal);
        }

        using var life = Alive(new CellTrouble(CellTrouble.OfBacklog("cmm"), "backlog-grows", "It grows.", Since));
        NeedsHelp("backlog-grows", "It grows.", "backlog cmm: It grows.");
    }

    [Fact]
    public void What_waits_is_counted_also_if_the_cell_does_not_run()
    {
        var folder = _settings.Gauges[0].Incoming!;
        Directory.CreateDirectory(folder);
        File.WriteAllText(Path.Combine(folder, _settings.Gauges[0].Files.Replace('*', 'x')), "");
        To(CorrectionState.Recognized);

        var backlog = Shell.Json(3, "errormatch/cell-status/1", "cell", "status", _cell.Config).GetProperty("backlog")[0];

        Assert.Equal((1, 1), (backlog.GetProperty("files").GetInt32(), backlog.GetProperty("pieces").GetInt32()));
    }

    [Fact]
    public void What_waits_for_a_person_is_the_ordinary_course()
    {
        To(CorrectionState.Proposed);
        using var life = Alive();
        Assert.Equal(1, IsWell().GetProperty("proposed").GetArrayLength());
        var text = Shell.Run("cell", "status", _cell.Config).Output;
        Assert.Contains("Waiting for a person", text, StringComparison.Ordinal);
        Assert.Contains("1: read its report", text, StringComparison.Ordinal);
    }

    [Fact]
    public void What_the_text_leaves_out_is_counted_and_the_document_has_all()
    {
        for (var i = 1; i <= 103; i++)
        {
            To(CorrectionState.Proposed, $"S{i}.csv");
        }

        using var life = Alive();
        Assert.Equal(103, IsWell().GetProperty("proposed").GetArrayLength());
        var text = Shell.Run("cell", "status", _cell.Config).Output;
        Assert.Contains("Waiting for a person: 103, the first 20", text, StringComparison.Ordinal);
        Assert.Contains(
            $"83 more are proposed: errormatch cell history {_cell.Config} --state proposed --most 103", text, StringComparison.Ordinal);
        var found = Shell.Run("cell", "history", _cell.Config, "--state", "proposed", "--most", "5").Output;
        Assert.Contains("The latest 5 of 103.", found, StringComparison.Ordinal);
    }

    [Fact]
    public void A_piece_that_is_at_its_machine_waits_for_its_release_in_the_ordinary_course()
    {
        To(CorrectionState.Verified);
        using var life = Alive();
        Assert.Equal("verified", IsWell().GetProperty("slots")[0].GetProperty("held").Text("state"));
        Assert.Contains(
            $"errormatch cell release {_cell.Config} 1", Shell.Run("cell", "status", _cell.Config).Output, StringComparison.Ordinal);
    }

    [Fact]
    public void What_is_approved_and_waits_behind_others_says_behind_whom()
    {
        To(CorrectionState.Proposed);
        To(CorrectionState.Approved, "S2.csv");
        using var life = Alive();
        var heldUp = Assert.Single(IsWell().GetProperty("slots")[0].GetProperty("heldUp").EnumerateArray());
        Assert.Equal(
            (2, 1), (heldUp.GetProperty("correction").GetInt32(), Assert.Single(heldUp.GetProperty("behind").EnumerateArray()).GetInt32()));
        Assert.Contains(
            "2 is approved and waits in line behind 1: decide about what stands before it first.",
            Shell.Run("cell", "status", _cell.Config).Output,
            StringComparison.Ordinal);
    }

    [Fact]
    public void What_waits_for_its_machine_says_what_the_machine_is_doing()
    {
        To(CorrectionState.Approved);
        var state = new MachineState(MachineActivity.Running, ["\u001b[2J/nc/O2001.NC"], Since);
        using var life = Alive(h => h with
        {
            Machines = [new("vmc1", state)],
            Waiting = [new("vmc1", "A", 1, "vmc1 is running.", Since)],
        });
        var slot = IsWell().GetProperty("slots")[0];
        Assert.Equal("running", slot.GetProperty("machineState").Text("activity"));
        Assert.Equal((1, "vmc1 is running."),
            (slot.GetProperty("waitsForMachine").GetProperty("correction").GetInt32(), slot.GetProperty("waitsForMachine").Text("reason")));
        var text = Shell.Run("cell", "status", _cell.Config).Output;
        Assert.Contains("vmc1: running, \\u001b[2J/nc/O2001.NC, since 2026-11-21 20:00:00Z", text, StringComparison.Ordinal);
        Assert.Contains("vmc1/A: correction 1 waits since 2026-11-21 20:00:00Z: vmc1 is running.", text, StringComparison.Ordinal);
    }

    [Fact]
    public void A_correction_that_failed_needs_help()
    {
        To(CorrectionState.Failed);
        using var life = Alive();
        NeedsHelp(
            "machine-login",
            "Correction 1 (S1.csv) failed: vmc1 refused the login.",
            "1: put right what it says, then errormatch cell approve");
    }

    [Theory]
    [InlineData("slot vmc1/A", "machine-away")]
    [InlineData("gauge cmm", "store-full")]
    [InlineData("gauge cmm", "gauge-away")]
    [InlineData("files of gauge cmm", "file-left")]
    [InlineData("signs of life", "not-kept")]
    [InlineData("computing 1", "internal-error")]
    public void What_keeps_a_part_from_working_needs_help(string where, string code)
    {
        using var life = Alive(new CellTrouble(where, code, "It is so.", Since));
        NeedsHelp(code, $"{where}, since 2026-11-21 20:00:00Z: It is so.", $"{where}: put right what it says ({code})");
    }

    [Fact]
    public void Without_a_sign_of_life_it_needs_help() =>
        NeedsHelp("cell-not-running", "The cell does not run.", $"Start the cell: errormatch cell run {_cell.Config}");

    [Theory]
    [InlineData(-16)]
    [InlineData(-86400)]
    [InlineData(3600)]
    public void A_sign_of_life_of_another_time_is_none(int seconds)
    {
        var at = TimeProvider.System.GetUtcNow().AddSeconds(seconds);
        new Heartbeat(17, Since, at, []).Write(_settings.LogFolder);
        NeedsHelp(
            "cell-not-running", FormattableString.Invariant($"its last sign of life was at {at:yyyy-MM-dd HH:mm:ss}Z"), "Start the cell");
    }

    [Fact]
    public void A_sign_of_life_that_cannot_be_read_is_none()
    {
        Directory.CreateDirectory(_settings.LogFolder);
        File.WriteAllText(Path.Combine(_settings.LogFolder, "running.json"), "{\"ProcessId\":17,");
        NeedsHelp("cell-not-running", "The cell does not run.", "Start the cell");
    }

    [Fact]
    public void A_name_that_steers_terminals_steers_none()
    {
        To(CorrectionState.Failed, "\u001b[2Jwell\n0  fine\u202E.csv");
        using var life = Alive();
        var (exit, output, error) = Shell.Run("cell", "status", _cell.Config);
        Assert.Equal(3, exit);
        Assert.Contains("\\u001b[2Jwell\\n0  fine\\u202e.csv", output, StringComparison.Ordinal);
        Assert.DoesNotContain(output + error, c => c is '\u001b' or '\u202E');
        Assert.Single(error.Split('\n', StringSplitOptions.RemoveEmptyEntries));
    }

    [Fact]
    public void All_troubles_are_said_at_once()
    {
        To(CorrectionState.Failed);
        using var life = Alive(
            new CellTrouble("slot vmc1/A", "machine-away", "No answer.", Since),
            new CellTrouble("signs of life", "not-kept", "No room.", Since));
        var (exit, output, error) = Shell.Run("cell", "status", _cell.Config, "--json");
        using var document = JsonDocument.Parse(output);
        Assert.Equal((3, ""), (exit, error));
        Assert.Equal(
            ["machine-away", "not-kept", "machine-login"],
            document.RootElement.GetProperty("problems").EnumerateArray().Select(p => p.Text("code")));
        Assert.Equal(3, Shell.Run("cell", "status", _cell.Config).Error.Split('\n', StringSplitOptions.RemoveEmptyEntries).Length);
    }

    [Fact]
    public void A_store_that_is_gone_or_damaged_is_named()
    {
        using var life = Alive();
        using (var file = new FileStream(_cell["cell.db"], FileMode.Open))
        {
            file.SetLength(0);
        }

        Assert.Equal("store-damaged", Shell.Error(3, "cell", "status", _cell.Config).Text("code"));
        File.Delete(_cell["cell.db"]);
        Assert.Equal("store-missing", Shell.Error(1, "cell", "status", _cell.Config).Text("code"));
    }

    public void Dispose() => _cell.Dispose();

    private JsonElement IsWell()
    {
        var json = Shell.Json(0, "errormatch/cell-status/1", "cell", "status", _cell.Config);
        Assert.True(json.GetProperty("healthy").GetBoolean());
        var (exit, _, error) = Shell.Run("cell", "status", _cell.Config);
        Assert.Equal((0, ""), (exit, error));
        return json;
    }

    private void NeedsHelp(string code, string message, string next)
    {
        var json = Shell.Json(3, "errormatch/cell-status/1", "cell", "status", _cell.Config);
        Assert.False(json.GetProperty("healthy").GetBoolean());
        var problem = Assert.Single(json.GetProperty("problems").EnumerateArray());
        Assert.Equal(code, problem.Text("code"));
        Assert.Contains(message, problem.Text("message"), StringComparison.Ordinal);
        var (exit, output, error) = Shell.Run("cell", "status", _cell.Config);
        Assert.Equal(3, exit);
        Assert.Contains(message, error, StringComparison.Ordinal);
        Assert.Contains(next, output, StringComparison.Ordinal);
        Assert.DoesNotContain("Nothing to do.", output, StringComparison.Ordinal);
    }

    // A cell that says again and again that it lives, however slow the test is.
    private Timer Alive(params CellTrouble[] troubles) => Alive(h => h with { Troubles = troubles });

    private Timer Alive(Func<Heartbeat, Heartbeat> with)
    {
        Beat(null);
        return new(Beat, null, TimeSpan.Zero, TimeSpan.FromMilliseconds(500));

        void Beat(object? state) => with(new(17, Since, TimeProvider.System.GetUtcNow(), [])).Write(_settings.LogFolder);
    }

    private void To(CorrectionState state, string fileName = "S1.csv")
    {
        using var store = CellStore.Open(_settings.Store, TimeProvider.System, AuditKey.Open(_settings.KeysFolder));
        var key = Path.GetFileNameWithoutExtension(fileName);
        var correction = store.Archive(new Arrival("cmm", fileName, key, new byte[] { 1 })).Correction;
        foreach (var next in Way(state))
        {
            correction = store.Step(correction, next, "cell", "for the test", c => c with
            {
                Job = "housing",
                Serial = "S1",
                Identity = key,
                Machine = "vmc1",
                Slot = "A",
                Program = "O2001.NC",
                ProgramSha256 = c.MeasurementSha256,
                Code = next == CorrectionState.Failed ? "machine-login" : null,
                Reason = next == CorrectionState.Failed ? "vmc1 refused the login." : null,
            });
        }
    }

    private static CorrectionState[] Way(CorrectionState state) => state switch
    {
        CorrectionState.Recognized => [CorrectionState.Recognized],
        CorrectionState.Proposed => [CorrectionState.Recognized, CorrectionState.Computed, CorrectionState.Proposed],
        CorrectionState.Approved => [.. Way(CorrectionState.Proposed), CorrectionState.Approved],
        _ => [.. Way(CorrectionState.Approved), CorrectionState.Uploading, state],
    };
}
