using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>Who follows what the check of a new cell says gets a cell that runs.</summary>
public sealed class NewCellTests : IDisposable
{
    private const string Password = "correct horse battery";
    private readonly TemporaryFolder _folder = new();

    private string Config => _folder["cell.json"];

    public void Dispose() => _folder.Dispose();

    [Fact]
    public async Task What_the_check_says_works_in_the_configuration_that_is_written_for_a_new_cell()
    {
        Assert.Equal(0, Shell.Run("job", "new", "cell", Config).Exit);
        foreach (var file in Directory.EnumerateFiles(Repository.PathTo("samples", "complex-mating")))
            File.Copy(file, _folder[Path.GetFileName(file)]);

        // The check names the folders that are missing. The person makes them, and checks again.
        var first = Shell.Json(3, "errormatch/cell-check/1", "cell", "check", Config);
        Assert.Equal(
            ["gauge-away", "machine-away"],
            first.GetProperty("errors").EnumerateArray().Select(e => e.GetProperty("code").GetString()).Order());
        Directory.CreateDirectory(_folder["incoming"]);
        Directory.CreateDirectory(_folder["machine"]);
        var check = Shell.Run("cell", "check", Config);
        Assert.Equal(0, check.Exit);
        Assert.Contains("not there yet: errormatch user add makes it", check.Output, StringComparison.Ordinal);

        // So does a cell that is started too early, and it makes nothing.
        var early = Shell.Run("cell", "run", Config);
        Assert.NotEqual(0, early.Exit);
        Assert.Contains("errormatch user add", early.Error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(_folder["store"]));

        using var input = new StringReader(Password + "\n");
        var added = Shell.Run(
            new SecretInput(input, null, TextWriter.Null), ["user", "add", Config, "anna", "--role", "administrator", "--password-stdin"]);
        Assert.True(added.Exit == 0, added.Error);
        Assert.DoesNotContain("not there yet", Shell.Run("cell", "check", Config).Output, StringComparison.Ordinal);
        using var running = await BackgroundCell.Start(Config);
    }

    // A cell that ran here had a store: the folder is on a disk that is not mounted.
    [Fact]
    public void A_folder_that_is_gone_with_its_store_is_not_made_again()
    {
        using var cell = CellFolder.WithPeople();
        File.WriteAllText(
            cell.Config, File.ReadAllText(cell.Config).Replace("\"cell.db\"", "\"disk/cell.db\"", StringComparison.Ordinal));
        var (exit, _, error) = cell.Piped([Password], "user", "add", cell.Config, "carl", "--role", "administrator");
        Assert.NotEqual(0, exit);
        Assert.Contains("Mount the disk", error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(cell["disk"]));
    }
}
