using System.Text.Json;
using ErrorMatching.Cell;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

public sealed class CellCheckTests : IDisposable
{
    private readonly CellFolder _cell = new();

    public void Dispose() => _cell.Dispose();

    [Fact]
    public void A_cell_that_could_start_is_exit_0_in_both_forms()
    {
        File.WriteAllText(_cell["incoming/A7.csv"], "");
        var document = Shell.Json(0, "errormatch/cell-check/1", "cell", "check", _cell.Config);
        Assert.Equal("Cell 1", document.Text("cell"));
        var file = Assert.Single(Assert.Single(document.GetProperty("gauges").EnumerateArray()).GetProperty("files").EnumerateArray());
        Assert.Equal(("A7.csv", "housing", "part", "A7"), (file.Text("name"), file.Text("job"), file.Text("piece"), file.Text("serial")));
        Assert.Equal(JsonValueKind.False, document.GetProperty("store").GetProperty("exists").ValueKind);
        Assert.False(document.TryGetProperty("errors", out _));
        var (exit, output, error) = Shell.Run("cell", "check", _cell.Config);
        Assert.Equal((0, ""), (exit, error));
        Assert.Contains("is a valid configuration: Cell 1", output, StringComparison.Ordinal);
        Assert.True(File.Exists(_cell["incoming/A7.csv"]));
        Assert.False(File.Exists(_cell["cell.db"]));
    }

    [Fact]
    public void A_machine_says_what_it_is_doing_or_that_is_exit_3()
    {
        File.WriteAllText(
            _cell.Config,
            File.ReadAllText(_cell.Config).Replace(
                "\"slots\":", "\"state\": { \"kind\": \"file\", \"file\": \"plc.txt\" }, \"slots\":", StringComparison.Ordinal));
        var away = Shell.Json(3, "errormatch/cell-check/1", "cell", "check", _cell.Config);
        Assert.Equal("state-away", Assert.Single(away.GetProperty("errors").EnumerateArray()).Text("code"));

        File.WriteAllText(_cell["plc.txt"], "STATE=HELD\nPROGRAM=O0211.NC\nEND\n");
        var machine = Shell.Json(0, "errormatch/cell-check/1", "cell", "check", _cell.Config).GetProperty("machines")[0];
        Assert.Equal("held", machine.GetProperty("machineState").Text("activity"));
        Assert.Contains("plc.txt: held, O0211.NC", Shell.Run("cell", "check", _cell.Config).Output, StringComparison.Ordinal);
    }

    [Fact]
    public void A_wrong_configuration_is_exit_1_by_path_line_and_column()
    {
        File.WriteAllText(
            _cell.Config,
            File.ReadAllText(_cell.Config).Replace("\"gauges\": [\"cmm\"]", "\"gauges\": [\"ccm\"]", StringComparison.Ordinal));
        var error = Shell.Error(1, "cell", "check", _cell.Config);
        Assert.Equal(
            ("unknown-gauge", _cell.Config, "$.jobs[0].gauges[0]", 5),
            (error.Text("code"), error.Text("file"), error.Text("path"), error.GetProperty("line").GetInt32()));
        Assert.StartsWith($"{_cell.Config}:5:", Shell.Run("cell", "check", _cell.Config).Error, StringComparison.Ordinal);
    }

    [Fact]
    public void A_configuration_that_is_not_there_is_exit_1() =>
        Assert.Equal("file-unreadable", Shell.Error(1, "cell", "check", _cell["none.json"]).Text("code"));

    [Fact]
    public void A_program_that_is_missing_is_exit_1()
    {
        File.Delete(_cell["job/counterpart.nc"]);
        var document = Shell.Json(1, "errormatch/cell-check/1", "cell", "check", _cell.Config);
        Assert.Equal("file-unreadable", Assert.Single(document.GetProperty("errors").EnumerateArray()).Text("code"));
    }

    [Fact]
    public void What_does_not_answer_is_exit_3()
    {
        Directory.Delete(_cell["machine"]);
        Directory.Delete(_cell["incoming"]);
        var document = Shell.Json(3, "errormatch/cell-check/1", "cell", "check", _cell.Config);
        Assert.Equal(3, document.GetProperty("exit").GetInt32());
        Assert.Equal("gauge-away", document.GetProperty("errors")[0].Text("code"));
        Assert.StartsWith("machine-", document.GetProperty("errors")[1].Text("code"), StringComparison.Ordinal);
    }

    [Fact]
    public void A_new_cells_file_says_what_to_do_next_and_its_schema_is_printed()
    {
        var (exit, output, _) = Shell.Run("job", "new", "cell", _cell["new.json"]);
        Assert.Equal(0, exit);
        Assert.Contains("errormatch cell check ", output, StringComparison.Ordinal);
        Assert.Equal(CellTemplate.Text, File.ReadAllText(_cell["new.json"]));
        Assert.Equal("a cell", Shell.Json(0, "errormatch/job-schema/1", "job", "schema", "cell").Text("title"));
    }

    [Fact]
    public void Each_code_of_a_check_is_in_the_reference()
    {
        var reference = File.ReadAllText(Repository.PathTo("docs", "reference-console.md"));
        Assert.All(
            [
                "secret-missing", "key-missing", RecognitionResult.UnknownPiece, RecognitionResult.AmbiguousPiece,
                RecognitionResult.ContradictoryPiece, RecognitionResult.UnusableJob, RecognitionResult.TooLarge],
            c => Assert.Contains($"| `{c}` |", reference, StringComparison.Ordinal));
    }
}
