using ErrorMatching.Refusals;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Hosting;

namespace ErrorMatching.Console.Tests;

/// <summary>A cell under a service manager: it starts, stops when told to, and reports that it ended by itself.</summary>
public sealed class CellServiceTests
{
    private readonly Manager _manager = new();
    private int _ended;

    [Fact]
    public async Task A_service_runs_until_its_manager_stops_it()
    {
        var stopped = new Failure(ExitCode.Cancelled, new Refusal("stopped", "It gave back what it held."));
        var run = Task.Run(() => Run(async stop =>
        {
            _manager.Works.SetResult();
            await Task.Delay(Timeout.Infinite, stop).ContinueWith(_ => { }, TaskScheduler.Default);
            return stopped;
        }));
        await _manager.Works.Task;
        Assert.False(run.IsCompleted);
        _manager.Application!.StopApplication();

        Assert.Same(stopped, await run);
        Assert.Equal((0, true), (_ended, _manager.IsStopped));
    }

    [Fact]
    public void What_it_refuses_ends_the_service_with_an_error()
    {
        var refused = new Failure(ExitCode.Outside, new Refusal("cell-runs-already", "Another process has it."));
        Assert.Same(refused, Run(_ => Task.FromResult<VerbResult>(refused)));
        Assert.Equal((1, true), (_ended, _manager.IsStopped));
    }

    [Fact]
    public void What_it_throws_ends_the_service_with_an_error_and_is_thrown_where_the_command_ends()
    {
        Assert.Equal("The disk is full.", Assert.Throws<IOException>(() => Run(_ => throw new IOException("The disk is full."))).Message);
        Assert.Equal((1, true), (_ended, _manager.IsStopped));
    }

    [Fact]
    public async Task A_service_that_is_stopped_while_it_waits_for_its_store_is_canceled()
    {
        var run = Task.Run(() => Run(async stop =>
        {
            _manager.Works.SetResult();
            await Task.Delay(Timeout.Infinite, stop);
            return null!;
        }));
        await _manager.Works.Task;
        _manager.Application!.StopApplication();

        Assert.Equal(ExitCode.Cancelled, Assert.IsType<Failure>(await run).Exit);
        Assert.Equal(0, _ended);
    }

    [Fact]
    public void At_a_console_a_cell_is_no_service() => Assert.False(CellService.IsOne);

    private VerbResult Run(Func<CancellationToken, Task<VerbResult>> work) => CellService.Run(
        work,
        services => services.AddSingleton<IHostLifetime>(s =>
        {
            _manager.Application = s.GetRequiredService<IHostApplicationLifetime>();
            return _manager;
        }),
        lifetime =>
        {
            Assert.Same(_manager, lifetime);
            Assert.False(_manager.IsStopped);
            _ended++;
        },
        TestContext.Current.CancellationToken);

    private sealed class Manager : IHostLifetime
    {
        public TaskCompletionSource Works { get; } = new();

        public IHostApplicationLifetime? Application { get; set; }

        public bool IsStopped { get; private set; }

        public Task WaitForStartAsync(CancellationToken cancellationToken) => Task.CompletedTask;

        public Task StopAsync(CancellationToken cancellationToken)
        {
            IsStopped = true;
            return Task.CompletedTask;
        }
    }
}
