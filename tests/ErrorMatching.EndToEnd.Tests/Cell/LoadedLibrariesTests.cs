using System.Text;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>What a run does not need it does not load: databases, servers' protocols and the cell cost every start otherwise.</summary>
public sealed class LoadedLibrariesTests
{
    private static readonly string[] OfCells = ["ErrorMatching.Cell", "Microsoft.Data.Sqlite", "Npgsql", "Serilog", "OpenTelemetry"];

    [Theory]
    [InlineData("--version", "System.CommandLine")]
    [InlineData("cell history --help", "System.CommandLine")]
    [InlineData("match samples/complex-mating/job.json", "ErrorMatching.Mating")]
    public async Task A_verb_that_needs_no_cell_does_not_load_it(string line, string needed)
    {
        using var shop = new Workshop();
        var trace = shop["loaded.nettrace"];

        // The runtime writes down each library that it loads. Sources: learn.microsoft.com, "EventPipe", "Runtime loader events".
        var run = await ConsoleRun.Of(new(ConsoleRun.Built, line.Split(' '))
        {
            WorkingDirectory = shop.Folder,
            Environment =
            {
                ["DOTNET_EnableEventPipe"] = "1",
                ["DOTNET_EventPipeOutputPath"] = trace,
                ["DOTNET_EventPipeConfig"] = "Microsoft-Windows-DotNETRuntime:0x8:4",
            },
        });
        Assert.True(run.Exit == 0, run.Output + run.Error);
        var told = await File.ReadAllBytesAsync(trace, TestContext.Current.CancellationToken);
        Assert.True(IsIn(needed), $"{needed} is not among what was loaded: the trace does not tell.");
        Assert.All(OfCells, library => Assert.False(IsIn(library), $"{line} loaded {library}."));

        bool IsIn(string library) => told.AsSpan().IndexOf(Encoding.Unicode.GetBytes(library + ",")) >= 0;
    }
}
