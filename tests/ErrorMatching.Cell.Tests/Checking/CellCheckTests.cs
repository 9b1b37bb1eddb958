using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

public sealed class CellCheckTests : IDisposable
{
    private readonly CellFolder _cell = new();

    public CellCheckTests()
    {
        foreach (var file in Directory.GetFiles(Repository.PathTo("samples", "complex-mating"))
            .Concat(Directory.GetFiles(Repository.PathTo("samples", "surface-one")))
            .Where(f => !f.EndsWith("job.json", StringComparison.Ordinal)))
        {
            File.Copy(file, _cell.PathOf("jobs/" + Path.GetFileName(file)), overwrite: true);
        }

        // Each slot has a program of its own number.
        var program = File.ReadAllText(_cell.PathOf("jobs/counterpart.nc"));
        foreach (var (name, number) in new[] { ("counterpart.nc", "O2001"), ("O2002.nc", "O2002"), ("O3001.nc", "O3001") })
            _cell.Write("jobs/" + name, program.Replace("O0211", number, StringComparison.Ordinal));

        Directory.CreateDirectory(_cell.PathOf("machine"));
    }

    public void Dispose() => _cell.Dispose();

    [Fact]
    public async Task Each_waiting_file_is_given_to_its_job_or_to_none_and_stays_where_it_is()
    {
        _cell.Write("incoming/WO-1_A7.csv", "");
        _cell.Write("incoming/stranger.csv", "");
        _cell.Write("incoming/notes.txt", "");
        File.CreateSymbolicLink(_cell.PathOf("incoming/link.csv"), _cell.PathOf("cell.json"));
        var gauge = (await Check(CellFolder.Right)).Gauges[0];
        Assert.Equal(
            [("WO-1_A7.csv", "housing", "A7", null), ("stranger.csv", null, null, "unknown-piece")],
            gauge.Files.Select(f => (f.Name, f.Found?.Job?.Name, f.Found?.Serial, f.Found?.Code)).Order());
        Assert.Equal("link.csv", Assert.Single(gauge.Left).Name);
        Assert.Null(gauge.Problem);
        Assert.Equal(4, Directory.GetFiles(_cell.PathOf("incoming")).Length);
        Assert.Single(Directory.GetFileSystemEntries(_cell.PathOf("incoming")), e => e.EndsWith("notes.txt", StringComparison.Ordinal));
    }

    [Fact]
    public async Task Files_that_are_not_finished_are_told_as_well_and_markers_are_not()
    {
        _cell.Write("incoming/WO-1_A.csv", "");
        _cell.Write("incoming/WO-1_B.csv", "");
        _cell.Write("incoming/WO-1_B.csv.csv", "");
        var check = await Check(CellFolder.With("\"finished\": \"rename\"", "\"finished\": { \"marker\": \".csv\" }"));
        Assert.Empty(check.Gauges[0].Files);
        check = await Check(CellFolder.With("\"finished\": \"rename\"", "\"finished\": { \"atRestS\": 60 }"));
        Assert.Equal(3, check.Gauges[0].Files.Count);
    }

    [Fact]
    public async Task A_file_that_is_too_large_is_not_read()
    {
        _cell.Write("incoming/WO-1_A.csv", "0123456789");
        var check = await Check(CellFolder.With("\"finished\": \"rename\"", "\"mostMB\": 0.000005"));
        Assert.Equal("file-too-large", Assert.Single(check.Gauges[0].Files).Found?.Code);
    }

    [Fact]
    public async Task A_folder_that_is_away_is_outside()
    {
        Directory.Delete(_cell.PathOf("incoming"));
        var check = await Check(CellFolder.Right);
        Assert.Equal("gauge-away", check.Gauges[0].Problem?.Errors[0].Code);
        Assert.Contains(check.Gauges[0].Problem, check.Away);
    }

    [Fact]
    public async Task A_machines_folder_is_listed_and_a_missing_password_is_named()
    {
        _cell.Write("machine/O2001.NC", "");
        var machines = (await Check(CellFolder.Right)).Machines;
        Assert.Equal(["O2001.NC"], machines[0].Names!);
        Assert.Null(machines[0].Problem);
        Assert.Equal(["secret-missing", "secret-missing"], machines.Skip(1).Select(m => m.Problem!.Errors[0].Code));
        Assert.Contains("errormatch cell secret", machines[1].Problem!.Errors[0].Message, StringComparison.Ordinal);
        Assert.False(File.Exists(_cell.PathOf("store/cell.db")));
    }

    [Fact]
    public async Task A_login_that_fails_is_named_by_its_transport()
    {
        var text = CellFolder.With("\"host\": \"vmc2\"", "\"host\": \"127.0.0.1\", \"port\": 1").Replace(
            "\"machine\": \"vmc2\", \"slot\"", "\"machine\": \"vmc2\", \"slot\"", StringComparison.Ordinal);
        Directory.CreateDirectory(_cell.PathOf("store"));
        var settings = _cell.Read(text);
        using (var store = CellStore.Open(settings.Store, TimeProvider.System))
        {
            new MachineSecrets(store, settings.KeysFolder).Set("vmc2", "secret", "test");
        }

        var problem = (await CellCheck.OfAsync(settings, TestContext.Current.CancellationToken)).Machines[1].Problem!;
        Assert.Equal("machine-away", problem.Errors[0].Code);
        Assert.DoesNotContain("secret", problem.Errors[0].Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_machines_folder_that_is_not_there_is_outside()
    {
        Directory.Delete(_cell.PathOf("machine"));
        Assert.StartsWith("machine-", (await Check(CellFolder.Right)).Machines[0].Problem?.Errors[0].Code, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_store_is_looked_at_and_not_made()
    {
        Assert.Equal(new(false, 0, Migrations.All[^1].Number, null), (await Check(CellFolder.Right)).Store);
        Assert.False(Directory.Exists(_cell.PathOf("store")));
        Directory.CreateDirectory(_cell.PathOf("store"));
        CellStore.Open(new SqliteSettings(_cell.PathOf("store/cell.db")), TimeProvider.System).Dispose();
        Assert.Equal(new(true, Migrations.All[^1].Number, Migrations.All[^1].Number, null), (await Check(CellFolder.Right)).Store);
    }

    [Theory]
    [InlineData("", "store-foreign")]
    [InlineData("no database at all, but long enough to be looked at as one", "store-damaged")]
    public async Task A_file_that_is_no_store_is_named(string text, string code)
    {
        _cell.Write("store/cell.db", text);
        Assert.Equal(code, (await Check(CellFolder.Right)).Store.Problem?.Errors[0].Code);
    }

    [Fact]
    public async Task Each_job_could_start()
    {
        var jobs = (await Check(CellFolder.Right)).Jobs;
        Assert.All(jobs, j => Assert.Null(j.Problem));
        Assert.Equal(117, jobs[0].Motions);
        Assert.All(jobs, j => Assert.True(j.Motions > 0));
    }

    [Fact]
    public async Task A_program_that_is_missing_or_cannot_be_followed_is_named()
    {
        File.Delete(_cell.PathOf("jobs/counterpart.nc"));
        var check = await Check(CellFolder.Right);
        Assert.Equal("file-unreadable", check.Jobs[0].Problem?.Errors[0].Code);
        Assert.NotEmpty(check.Wrong);
        _cell.Write("jobs/counterpart.nc", "N10 G90 G1 X1 F100\nN20 GOTO 10\n");
        Assert.NotNull((await Check(CellFolder.Right)).Jobs[0].Problem);
    }

    // A number that the file's name denies, a number of two slots, a file at the machine that has the number, too.
    [Theory]
    [InlineData("counterpart.nc", "O0240", null, "program-named-otherwise", "O0240 at its head, and goes to O2001.NC")]
    [InlineData("O2002.nc", "O2001", null, "program-name-taken", "of slot A, O2001.NC")]
    [InlineData("O2002.nc", "O2002", "2002.TXT", "program-name-taken", "the file 2002.TXT at the machine")]
    [InlineData("O2002.nc", "O2002", "o02002", "program-name-taken", "the file o02002 at the machine")]
    public async Task A_name_by_which_the_control_would_mean_another_program_is_wrong(
        string file, string number, string? there, string code, string says)
    {
        Assert.Empty((await Check(CellFolder.Right)).Wrong);
        var before = file == "counterpart.nc" ? "O2001" : "O2002";
        _cell.Write("jobs/" + file, (await File.ReadAllTextAsync(_cell.PathOf("jobs/" + file), TestContext.Current.CancellationToken))
            .Replace(before, number, StringComparison.Ordinal));
        if (there is not null) _cell.Write("machine/" + there, "");
        _cell.Write("machine/O2002.NC", "");
        _cell.Write("machine/O2002.BAK", "");
        var wrong = (await Check(CellFolder.Right)).Wrong.SelectMany(p => p.Errors).ToArray();
        Assert.Contains(wrong, e => e.Code == code && e.Message.Contains(says, StringComparison.Ordinal));
        Assert.All(wrong, e => Assert.EndsWith(".nc", e.Place.File, StringComparison.Ordinal));
    }

    [Fact]
    public async Task A_base_program_in_a_file_of_another_number_is_wrong()
    {
        File.Move(_cell.PathOf("jobs/O2002.nc"), _cell.PathOf("jobs/O0077.nc"));
        var job = await File.ReadAllTextAsync(_cell.PathOf("jobs/feedback.json"), TestContext.Current.CancellationToken);
        _cell.Write("jobs/feedback.json", job.Replace("O2002.nc", "O0077.nc", StringComparison.Ordinal));
        var wrong = Assert.Single((await Check(CellFolder.Right)).Wrong.SelectMany(p => p.Errors));
        Assert.Equal("program-named-otherwise", wrong.Code);
        Assert.Contains("another program than O2002", wrong.Message, StringComparison.Ordinal);
    }

    private Task<CellCheck> Check(string text) => CellCheck.OfAsync(_cell.Read(text), TestContext.Current.CancellationToken);
}
