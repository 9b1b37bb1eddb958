namespace ErrorMatching.Cell.Tests;

/// <summary>What a check says about gauges' folders that files cannot be taken out of, and about what it does not try.</summary>
public sealed class CheckedFolderTests : IDisposable
{
    private readonly CellFolder _cell = new();

    public void Dispose() => _cell.Dispose();

    [Fact]
    public async Task A_folder_that_nothing_can_be_taken_out_of_is_named()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "Windows has no folder that even its administrator cannot write to.");
        var check = await CheckAsync(CellFolder.With("\"incoming\": \"incoming\"", "\"incoming\": \"/proc\""));
        var problem = check.Gauges[0].Problem!;
        Assert.Equal("gauge-denied", problem.Errors[0].Code);
        Assert.Contains("\"cmm\": in /proc ", problem.Errors[0].Message, StringComparison.Ordinal);
        Assert.Contains(problem, check.Away);
    }

    [Fact]
    public async Task The_folder_inside_is_looked_at_as_well_and_nothing_is_left_of_the_look()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "Windows has no folder that even its administrator cannot write to.");
        Assert.Null((await CheckAsync(CellFolder.Right)).Gauges[0].Problem);
        Assert.Empty(Directory.EnumerateFileSystemEntries(_cell.PathOf("incoming")));
        Directory.CreateSymbolicLink(_cell.PathOf("incoming/.errormatch"), "/proc");
        Assert.Equal("gauge-denied", (await CheckAsync(CellFolder.Right)).Gauges[0].Problem?.Errors[0].Code);
        Assert.Single(Directory.EnumerateFileSystemEntries(_cell.PathOf("incoming")));
    }

    [Fact]
    public async Task A_check_says_what_it_did_not_try_at_machines_that_answer()
    {
        Directory.CreateDirectory(_cell.PathOf("machine"));
        var check = await CheckAsync(CellFolder.Right);
        Assert.StartsWith("vmc1: whether programs may be written", Assert.Single(check.Untried), StringComparison.Ordinal);
    }

    [Fact]
    public async Task The_logs_of_a_machine_that_does_not_answer_are_not_counted_and_the_machine_is_told_once()
    {
        var check = await CheckAsync(CellFolder.Right);
        Assert.Same(check.Machines[1].Problem, check.Gauges[1].Problem);
        Assert.Single(check.Away, p => p == check.Machines[1].Problem);
    }

    private Task<CellCheck> CheckAsync(string text) => CellCheck.OfAsync(_cell.Read(text), TestContext.Current.CancellationToken);
}
