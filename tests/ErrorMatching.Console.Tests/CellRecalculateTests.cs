using System.Text.Json;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>A job is changed while a correction waits: an operator recalculates it.</summary>
public sealed class CellRecalculateTests
{
    [Fact]
    public async Task What_waits_is_computed_with_the_job_as_it_is_now_once_the_job_was_changed()
    {
        using var cell = CellFolder.WithPeople();
        var (theoretical, part) = (cell["job/theoretical.csv"], Repository.PathTo("samples", "complex-mating", "part.csv"));
        using var running = await BackgroundCell.Start(cell.Config);
        File.Copy(part, cell["written"]);
        File.Move(cell["written"], cell["incoming/S1.csv"]);
        await Until(cell, 1, "proposed");

        // As it is, there is nothing to compute.
        var refused = Again(cell);
        Assert.Equal((2, "job-unchanged"), (refused.Exit, refused.Document.GetProperty("errors")[0].GetProperty("code").GetString()));

        await File.WriteAllTextAsync(
            theoretical,
            (
                await File.ReadAllTextAsync(theoretical, TestContext.Current.CancellationToken))
                .Replace("-31.950", "-31.951", StringComparison.Ordinal),
            TestContext.Current.CancellationToken);
        var (exit, given) = Again(cell);
        Assert.Equal(
            (0, 2L, 1L, "archived", "S1.csv"),
            (
                exit,
                given.GetProperty("id").GetInt64(),
                given.GetProperty("measuredAs").GetInt64(),
                given.Text("state"),
                given.Text("fileName")));
        Assert.Equal("errormatch/cell-again/1", given.Text("schema"));
        await Until(cell, 2, "proposed");
        var old = Shell.Json(0, "errormatch/cell-correction/1", "cell", "show", cell.Config, "1");
        Assert.Equal(
            ("superseded", "computed-anew", JsonValueKind.Null),
            (old.Text("state"), old.Text("code"), old.GetProperty("measuredAs").ValueKind));
        Assert.Contains("correction 2", old.Text("reason"), StringComparison.Ordinal);
        Assert.Contains(("superseded", "Ben"), old.GetProperty("steps").EnumerateArray().Select(s => (s.Text("to"), s.Text("by"))));
        Assert.Equal("wrong-state", Again(cell).Document.GetProperty("errors")[0].GetProperty("code").GetString());

        // In words.
        await File.WriteAllTextAsync(
            theoretical,
            (
                await File.ReadAllTextAsync(theoretical, TestContext.Current.CancellationToken))
                .Replace("-31.951", "-31.952", StringComparison.Ordinal),
            TestContext.Current.CancellationToken);
        Assert.Equal(
            (0, "Correction 3 (S1.csv) is computed in the place of correction 2, which is superseded, with the job as it is now.\n", ""),
            cell.Piped([CellFolder.Bens], "cell", "again", cell.Config, "2", "--user", "ben", "--reason", "nose radius"));
        Assert.Equal(0, Shell.Run("audit", "verify", cell.Config).Exit);
    }

    private static (int Exit, JsonElement Document) Again(CellFolder cell)
    {
        var (exit, output, _) = cell.Piped([CellFolder.Bens], "cell", "again", cell.Config, "1", "--user", "ben", "--json");
        return (exit, JsonDocument.Parse(output).RootElement);
    }

    private static Task Until(CellFolder cell, int id, string state) =>
        BackgroundCell.Until(
            () => Shell.Run("cell", "show", cell.Config, $"{id}", "--json").Output.Contains(
                $"\"state\": \"{state}\"", StringComparison.Ordinal));
}
