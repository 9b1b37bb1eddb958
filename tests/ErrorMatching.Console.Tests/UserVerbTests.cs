using System.Text.Json;
using ErrorMatching.Cell;

namespace ErrorMatching.Console.Tests;

public sealed class UserVerbTests
{
    [Fact]
    public void The_words_for_roles_are_those_of_the_cell() =>
        Assert.Equal(Enum.GetNames<Role>().Select(n => n.ToLowerInvariant()), RoleOption.Words);

    [Fact]
    public void The_first_user_is_an_administrator_by_a_password_that_is_not_shown()
    {
        using var cell = new CellFolder();
        var (exit, output, error, shown) = cell.Typed(
            $"{CellFolder.Annas}\n{CellFolder.Annas}\n", "user", "add", cell.Config, "Anna", "--role", "administrator");
        Assert.Equal(
            (0, "Anna is the first administrator. Add a second one soon: a lost password is set by another administrator.\n", ""),
            (exit, output, error));
        Assert.Equal("New password of Anna: \nNew password of Anna again: \n", shown);
    }

    [Theory]
    [InlineData("setter"), InlineData("operator")]
    public void The_first_user_is_nothing_less(string role)
    {
        using var cell = new CellFolder();
        Assert.Equal("no-users", Error(1, cell.Piped([CellFolder.Annas], "user", "add", cell.Config, "Anna", "--role", role, "--json")));
    }

    [Fact]
    public void Each_verb_changes_its_user_and_says_so()
    {
        using var cell = CellFolder.WithPeople();
        Changed("role", "Ben is setter now.", u => u.GetProperty("role").GetString() == "setter", "--role", "setter");
        Changed("disable", "Ben may not sign in any more.", u => u.GetProperty("isDisabled").GetBoolean());
        Changed("enable", "Ben may sign in.", u => !u.GetProperty("isDisabled").GetBoolean());

        void Changed(string verb, string sentence, Func<JsonElement, bool> holds, params string[] more)
        {
            string[] args = ["user", verb, cell.Config, "ben", "--user", "ANNA", .. more];
            Assert.Equal((0, sentence + "\n", ""), cell.Piped([CellFolder.Annas], args));
            var document = Document(0, $"errormatch/user-{verb}/1", cell.Piped([CellFolder.Annas], [.. args, "--json"]));
            Assert.Equal("Ben", document.Text("name"));
            Assert.True(holds(document));
        }
    }

    [Fact]
    public void A_password_is_set_with_the_old_one()
    {
        using var cell = CellFolder.WithPeople();
        Assert.Equal(
            (0, "Ben has a new password.\n", ""),
            cell.Piped([CellFolder.Bens, "a third one for Ben"], "user", "password", cell.Config, "Ben", "--user", "Ben"));
        Assert.Equal(
            "sign-in-refused",
            Error(1, cell.Piped([CellFolder.Bens, CellFolder.Bens], "user", "password", cell.Config, "Ben", "--user", "Ben", "--json")));
        Assert.Equal(
            "weak-password",
            Error(1, cell.Piped(["a third one for Ben", "short"], "user", "password", cell.Config, "Ben", "--user", "Ben", "--json")));
    }

    [Fact]
    public void What_may_not_be_is_refused_with_a_code_each()
    {
        using var cell = CellFolder.WithPeople();
        Assert.Equal("user-exists", Refused(1, [CellFolder.Annas, CellFolder.Bens], "add", "BEN", "--role", "setter", "--user", "anna"));
        Assert.Equal("bad-user-name", Refused(1, [CellFolder.Annas, CellFolder.Bens], "add", " x", "--role", "setter", "--user", "anna"));
        Assert.Equal("unknown-user", Refused(1, [CellFolder.Annas], "disable", "Cem", "--user", "anna"));
        Assert.Equal("last-administrator", Refused(2, [CellFolder.Annas], "disable", "Anna", "--user", "anna"));
        Assert.Equal("not-allowed", Refused(2, [CellFolder.Bens], "disable", "Anna", "--user", "Ben"));
        Assert.Equal("no-password", Refused(1, [], "disable", "Ben", "--user", "anna"));
        for (var i = 0; i < 5; i++)
        {
            Assert.Equal("sign-in-refused", Refused(1, ["wrong"], "disable", "Anna", "--user", "Ben"));
        }

        Assert.Equal("locked-out", Refused(2, [CellFolder.Bens], "disable", "Anna", "--user", "Ben"));
        Assert.Contains("locked until", Shell.Run("user", "list", cell.Config).Output, StringComparison.Ordinal);

        string? Refused(int exit, string[] lines, string verb, params string[] more) =>
            Error(exit, cell.Piped(lines, ["user", verb, cell.Config, .. more, "--json"]));
    }

    [Fact]
    public void Who_signs_is_named_by_an_option_or_the_environment()
    {
        using var cell = CellFolder.WithPeople();
        string[] args = ["user", "role", cell.Config, "Ben", "--role", "setter"];
        Assert.Equal("no-password", Error(1, cell.Piped([CellFolder.Annas], [.. args, "--json"])));
        Environment.SetEnvironmentVariable(SigningVerb.UserVariable, "Anna");
        try
        {
            Assert.Equal(0, cell.Piped([CellFolder.Annas], args).Exit);
            Assert.Equal("not-allowed", Error(2, cell.Piped([CellFolder.Bens], [.. args, "--user", "Ben", "--json"])));
        }
        finally
        {
            Environment.SetEnvironmentVariable(SigningVerb.UserVariable, null);
        }
    }

    [Fact]
    public void No_argument_takes_a_password() => Assert.All(
        Verbs(CommandTree.Build()).OfType<SigningVerb>().SelectMany(
            v => v.Options.Select(o => o.Name).Concat(v.Arguments.Select(a => a.Name))),
        name => Assert.True(
            name == "--password-stdin"
                || !name.Contains("pass", StringComparison.OrdinalIgnoreCase)
                    && !name.Contains("secret", StringComparison.OrdinalIgnoreCase),
            name));

    [Fact]
    public void Users_are_listed()
    {
        using var cell = CellFolder.WithPeople();
        var users = Shell.Json(0, "errormatch/user-list/1", "user", "list", cell.Config).GetProperty("users").EnumerateArray().ToArray();
        Assert.Equal([("Anna", "administrator"), ("Ben", "operator")], users.Select(u => (u.Text("name"), u.Text("role"))));
        Assert.All(
            users,
            u => Assert.Equal(
                (JsonValueKind.Null, 0, false),
                (u.GetProperty("lockedUntil").ValueKind, u.GetProperty("failures").GetInt32(), u.GetProperty("isDisabled").GetBoolean())));
        var (exit, output, error) = Shell.Run("user", "list", cell.Config);
        Assert.Equal((0, ""), (exit, error));
        Assert.StartsWith("name  role ", output, StringComparison.Ordinal);
        Assert.Contains("\nAnna  administrator  ", output, StringComparison.Ordinal);
    }

    [Fact]
    public void Looking_makes_no_store()
    {
        using var cell = new CellFolder();
        Assert.Equal("store-missing", Shell.Error(1, "user", "list", cell.Config).Text("code"));
        Assert.Equal(
            "store-missing", Error(1, cell.Piped([CellFolder.Annas], "user", "disable", cell.Config, "Ben", "--user", "anna", "--json")));
        Assert.False(File.Exists(cell["cell.db"]));
        Assert.False(Directory.Exists(cell["keys"]));
    }

    [Fact]
    public void A_configuration_that_is_not_there_is_named()
    {
        var error = Shell.Error(1, "user", "list", "none.json");
        Assert.Equal(("file-unreadable", "none.json"), (error.Text("code"), error.Text("file")));
    }

    [Theory]
    [InlineData("add", "Dan"), InlineData("role", "Ben"), InlineData("add", "Dan", "--role", "boss"),
        InlineData("role", "Ben", "--role", "Administrator"), InlineData("add", "Dan", "--role", "setter", "--password", "x")]
    public void A_wrong_command_line_is_one(string verb, params string[] more)
    {
        using var cell = new CellFolder();
        var errors = Shell.Json(1, "errormatch/error/1", ["user", verb, cell.Config, .. more]).GetProperty("errors").EnumerateArray();
        Assert.All(errors, e => Assert.Equal("command-line", e.Text("code")));
    }

    internal static string? Error(int exit, (int Exit, string Output, string Error) run) =>
        Assert.Single(Document(exit, "errormatch/error/1", run).GetProperty("errors").EnumerateArray()).Text("code");

    internal static JsonElement Document(int exit, string schema, (int Exit, string Output, string Error) run)
    {
        Assert.Equal((exit, ""), (run.Exit, run.Error));
        using var document = JsonDocument.Parse(run.Output);
        Assert.Equal(schema, document.RootElement.Text("schema"));
        return document.RootElement.Clone();
    }

    private static IEnumerable<System.CommandLine.Command> Verbs(System.CommandLine.Command command) =>
        command.Subcommands.SelectMany(Verbs).Prepend(command);
}
