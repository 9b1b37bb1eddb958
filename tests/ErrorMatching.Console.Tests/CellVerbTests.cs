using System.Text.Json;
using ErrorMatching.Cell;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

public sealed class CellVerbTests
{
    private const string Anna = "anna";
    private static readonly string Part = File.ReadAllText(Repository.PathTo("samples", "complex-mating", "part.csv"));

    [Fact]
    public async Task A_file_goes_from_the_gauge_to_the_machine_by_peoples_decisions()
    {
        using var cell = CellFolder.WithPeople();
        var original = File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "counterpart.nc"));
        File.WriteAllBytes(cell["machine/O0211.NC"], original);
        using var running = await BackgroundCell.Start(cell.Config);
        Drop(cell, "S1.csv", Part);
        await Until(cell, 1, "proposed");
        var status = Shell.Json(0, "errormatch/cell-status/1", "cell", "status", cell.Config);
        Assert.Equal(
            (true, 1L), (status.GetProperty("healthy").GetBoolean(), status.GetProperty("proposed")[0].GetProperty("id").GetInt64()));
        Assert.Contains("read its report", Shell.Run("cell", "status", cell.Config).Output, StringComparison.Ordinal);

        Assert.Equal(2, cell.Piped([CellFolder.Bens], "cell", "approve", cell.Config, "1", "--user", "ben").Exit);
        Assert.Equal(
            0, cell.Piped([CellFolder.Annas], "cell", "approve", cell.Config, "1", "--user", Anna, "--reason", "looks right").Exit);
        await Until(cell, 1, "verified");
        var sent = File.ReadAllBytes(cell["machine/O0211.NC"]);
        Assert.NotEqual(original, sent);

        var shown = Shell.Json(0, "errormatch/cell-correction/1", "cell", "show", cell.Config, "1", "--out", cell["out"]);
        Assert.Contains(
            ("approved", "Anna", "looks right"),
            shown.GetProperty("steps").EnumerateArray().Select(s => (s.Text("to"), s.Text("by"), s.Text("basis"))));
        Assert.Contains(
            ("verified", "read back from the machine, the same to the last bit", "[\"read-back\"]"),
            shown.GetProperty("steps").EnumerateArray()
                .Select(s => (s.Text("to"), s.Text("basis"), JsonSerializer.Serialize(s.GetProperty("basisStatement")))));
        Assert.All(
            shown.GetProperty("steps").EnumerateArray().Where(s => s.Text("by") == "Anna"),
            s => Assert.Equal(JsonValueKind.Null, s.GetProperty("basisStatement").ValueKind));
        Assert.Equal(sent, File.ReadAllBytes(cell["out/1-O0211.NC"]));
        Assert.Equal(original, File.ReadAllBytes(cell["out/1-previous-O0211.NC"]));
        Assert.Equal(Part, File.ReadAllText(cell["out/1-measurement-S1.csv"]));
        Assert.All(
            new[] { "1-report.html", "1-report.json", "1-job.json", "1-base-O0211.NC" },
            f => Assert.True(new FileInfo(cell["out/" + f]).Length > 0));

        Assert.Equal(0, cell.Piped([CellFolder.Annas], "cell", "revert", cell.Config, "1", "--user", Anna, "--reason", "chatter").Exit);
        Assert.Equal(original, File.ReadAllBytes(cell["machine/O0211.NC"]));
        Assert.Equal(
            "reverted",
            Shell.Json(0, "errormatch/cell-status/1", "cell", "status", cell.Config)
                .GetProperty("slots")[0]
                .GetProperty("held")
                .Text("state"));
        Assert.Equal(0, cell.Piped([CellFolder.Bens], "cell", "release", cell.Config, "1", "--user", "ben").Exit);
        Assert.Equal(
            JsonValueKind.Null,
            Shell.Json(0, "errormatch/cell-status/1", "cell", "status", cell.Config).GetProperty("slots")[0].GetProperty("held").ValueKind);

        Drop(cell, "S2.csv", Part.Replace("-32.067", "-32.068", StringComparison.Ordinal));
        await Until(cell, 2, "proposed");
        Assert.Equal(0, cell.Piped([CellFolder.Bens], "cell", "reject", cell.Config, "2", "--user", "ben", "--reason", "dirty").Exit);
        var found = Shell.Json(
            0, "errormatch/cell-history/1", "cell", "history", cell.Config, "--user", "Ben", "--serial", "S2").GetProperty("corrections");
        Assert.Equal(
            ("S2.csv", "rejected", "dirty"),
            Assert.Single(found.EnumerateArray()) is var c ? (c.Text("fileName"), c.Text("state"), c.Text("reason")) : default);
        Assert.Equal(0, Shell.Run("audit", "verify", cell.Config).Exit);

        var (exit, output) = await running.Stop();
        Assert.Equal(
            (0, "Cell 1 was told to stop, and stopped. Whatever it had begun is kept: the next run goes on with it.\n"), (exit, output));
    }

    [Fact]
    public void A_cell_that_does_not_run_is_not_well()
    {
        using var cell = CellFolder.WithPeople();
        var (exit, output, error) = Shell.Run("cell", "status", cell.Config, "--json");
        using var document = JsonDocument.Parse(output);
        Assert.Equal(
            (3, "", false, "cell-not-running"),
            (
                exit,
                error,
                document.RootElement.GetProperty("healthy").GetBoolean(),
                document.RootElement.GetProperty("problems")[0].Text("code")));
        Assert.Contains(
            $"Start the cell: errormatch cell run {cell.Config}",
            Shell.Run("cell", "status", cell.Config).Output,
            StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_cell_runs_once()
    {
        using var cell = CellFolder.WithPeople();
        using var running = await BackgroundCell.Start(cell.Config);
        Assert.Equal("cell-runs-already", Shell.Error(3, "cell", "run", cell.Config).Text("code"));

        // Nor does another one with its store, and no process stands by at a file.
        var other = Path.Combine(Path.GetDirectoryName(cell.Config)!, "other.json");
        File.WriteAllText(other, File.ReadAllText(cell.Config).Replace("\"Cell 1\"", "\"Cell 2\"", StringComparison.Ordinal));
        Assert.Equal("store-of-one-cell", Shell.Error(3, "cell", "run", other).Text("code"));
        Assert.Equal("standby-needs-server", Shell.Error(1, "cell", "run", cell.Config, "--standby").Text("code"));
    }

    [Theory]
    [InlineData(1, "unknown-correction", "approve", "7")]
    [InlineData(1, "unknown-correction", "release", "7")]
    [InlineData(1, "unknown-correction", "reject", "7", "--reason", "x")]
    [InlineData(1, "unknown-correction", "again", "7")]
    [InlineData(1, "command-line", "again", "7", "--reason", " ")]
    [InlineData(1, "unknown-correction", "revert", "7", "--reason", "x")]
    [InlineData(1, "command-line", "revert", "7")]
    [InlineData(1, "command-line", "reject", "7")]
    [InlineData(1, "command-line", "reject", "7", "--reason", " ")]
    [InlineData(1, "command-line", "approve", "seven")]
    public void A_decision_that_cannot_be_carried_out_says_why(int exit, string code, string verb, params string[] words)
    {
        using var cell = CellFolder.WithPeople();
        var run = cell.Piped([CellFolder.Annas], ["cell", verb, cell.Config, .. words, "--user", Anna, "--json"]);
        using var document = JsonDocument.Parse(run.Output);
        Assert.Equal((exit, code), (run.Exit, document.RootElement.GetProperty("errors")[0].Text("code")));
    }

    [Fact]
    public async Task A_backup_is_restored_only_while_the_cell_does_not_run()
    {
        using var cell = CellFolder.WithPeople();
        using (var running = await BackgroundCell.Start(cell.Config))
        {
            Drop(cell, "S1.csv", Part);
            await Until(cell, 1, "proposed");
            Assert.Equal(0, Shell.Run("cell", "backup", cell.Config, cell["copy.db"]).Exit);
            Assert.Equal("output-exists", Shell.Error(1, "cell", "backup", cell.Config, cell["copy.db"]).Text("code"));
            Assert.Equal("store-locked", Shell.Error(3, "cell", "restore", cell.Config, cell["copy.db"]).Text("code"));
            Drop(cell, "S2.csv", Part.Replace("-32.067", "-32.068", StringComparison.Ordinal));
            await Until(cell, 2, "proposed");
        }

        Assert.Equal(0, Shell.Run("cell", "restore", cell.Config, cell["copy.db"]).Exit);
        Assert.Equal(
            [1L],
            Shell.Json(0, "errormatch/cell-history/1", "cell", "history", cell.Config)
                .GetProperty("corrections")
                .EnumerateArray()
                .Select(c => c.GetProperty("id").GetInt64()));
    }

    [Fact]
    public void A_store_is_thinned_by_age()
    {
        using var cell = CellFolder.WithPeople();
        foreach (var age in new[] { "soon", "0d", "2w", "101y", "-1y" })
        {
            Assert.Equal("command-line", Shell.Error(1, "cell", "thin", cell.Config, $"--older-than={age}").Text("code"));
        }

        Assert.Equal("command-line", Shell.Error(1, "cell", "thin", cell.Config, "--older-than", "1y", "--keep-last", "0").Text("code"));
        foreach (var age in new[] { "2y", "P18M", "730d" })
        {
            var answer = Shell.Json(0, "errormatch/cell-thin/1", "cell", "thin", cell.Config, "--older-than", age);
            Assert.Equal((false, 0, 100), (
                answer.GetProperty("dryRun").GetBoolean(),
                answer.GetProperty("contents").GetInt32(),
                answer.GetProperty("keepLast").GetInt32()));
            Assert.EndsWith("cell.db.archives", answer.Text("folder"), StringComparison.Ordinal);
            Assert.InRange(
                DateTimeOffset.Parse(answer.Text("before")!, System.Globalization.CultureInfo.InvariantCulture),
                DateTimeOffset.UtcNow.AddDays(-732),
                DateTimeOffset.UtcNow.AddDays(-540));
        }
    }

    [Theory]
    [InlineData("--from", "yesterday")]
    [InlineData("--to", "2026-13-01")]
    [InlineData("--state", "lost")]
    [InlineData("--most", "0")]
    public void A_wrong_question_about_the_history_is_a_wrong_command_line(string option, string value)
    {
        using var cell = CellFolder.WithPeople();
        Assert.Equal("command-line", Shell.Error(1, "cell", "history", cell.Config, option, value).Text("code"));
    }

    [Fact]
    public void Each_code_of_a_cell_is_in_the_reference()
    {
        var reference = File.ReadAllText(Repository.PathTo("docs", "reference-console.md"));
        var codes = new[]
        {
            typeof(CellCodes),
            typeof(DecisionException)
        }.SelectMany(t => t.GetFields()).Where(f => f.IsLiteral).Select(f => (string)f.GetRawConstantValue()!)
            .Concat(Enum.GetValues<TransportError>().Select(CellCodes.Of)).Concat(Enum.GetValues<StoreError>().Select(CellCodes.Of))
                .Concat(["cell-runs-already", "cell-taken-over", "store-of-one-cell", "standby-needs-server", "cell-not-running"])
                .ToArray();
        Assert.True(codes.Length > 35);
        Assert.All(codes, c => Assert.Contains($"| `{c}` |", reference, StringComparison.Ordinal));
    }

    private static void Drop(CellFolder cell, string name, string text)
    {
        File.WriteAllText(cell["written"], text);
        File.Move(cell["written"], cell["incoming/" + name]);
    }

    private static Task Until(CellFolder cell, int id, string state) => BackgroundCell.Until(
        () => Shell.Run("cell", "show", cell.Config, $"{id}", "--json").Output.Contains(
            $"\"state\": \"{state}\"", StringComparison.Ordinal));
}
