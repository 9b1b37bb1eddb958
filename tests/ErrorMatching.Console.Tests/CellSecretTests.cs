using ErrorMatching.Cell;

namespace ErrorMatching.Console.Tests;

public sealed class CellSecretTests
{
    [Fact]
    public void An_administrator_sets_and_removes_the_password_of_a_machine()
    {
        using var cell = CellFolder.WithPeople();
        var (exit, output, error, shown) = cell.Typed(
            $"{CellFolder.Annas}\ns3cret\ns3cret\n", "cell", "secret", cell.Config, "vmc1", "--user", "anna");
        Assert.Equal((0, "The cell signs in to vmc1 with the new password from now on.\n", ""), (exit, output, error));
        Assert.Equal("Password of anna: \nPassword at vmc1: \nPassword at vmc1 again: \n", shown);
        Assert.Equal("s3cret", Stored());
        Assert.DoesNotContain("s3cret", Shell.Run("audit", "export", cell.Config).Output, StringComparison.Ordinal);

        var removed = UserVerbTests.Document(
            0,
            "errormatch/cell-secret/1",
            cell.Piped([CellFolder.Annas], "cell", "secret", cell.Config, "vmc1", "--remove", "--user", "anna", "--json"));
        Assert.Equal(
            ("vmc1", false, true),
            (removed.Text("machine"), removed.GetProperty("isSet").GetBoolean(), removed.GetProperty("isChanged").GetBoolean()));
        Assert.Null(Stored());

        string? Stored()
        {
            var settings = CellSettingsReader.Read(cell.Config);
            using var store = CellStore.Open(settings.Store, TimeProvider.System, AuditKey.Open(settings.KeysFolder));
            return new MachineSecrets(store, settings.KeysFolder).Get("vmc1");
        }
    }

    [Fact]
    public void Nobody_else_does()
    {
        using var cell = CellFolder.WithPeople();
        Assert.Equal(
            "not-allowed",
            UserVerbTests.Error(
                2, cell.Piped([CellFolder.Bens, "s3cret"], "cell", "secret", cell.Config, "vmc1", "--user", "Ben", "--json")));
        Assert.Equal(
            "bad-secret",
            UserVerbTests.Error(1, cell.Piped([CellFolder.Annas, ""], "cell", "secret", cell.Config, "vmc1", "--user", "anna", "--json")));
    }

    [Fact]
    public void Only_machines_of_the_configuration_have_one()
    {
        using var cell = CellFolder.WithPeople();
        var error = Shell.Error(1, "cell", "secret", cell.Config, "vmc2", "--user", "anna");
        Assert.Equal(("unknown-machine", cell.Config, "$.machines"), (error.Text("code"), error.Text("file"), error.Text("path")));
        Assert.Contains("vmc1", error.Text("message"), StringComparison.Ordinal);
    }
}
