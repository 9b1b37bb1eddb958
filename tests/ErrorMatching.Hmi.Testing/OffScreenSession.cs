using Avalonia;
using Avalonia.Threading;

namespace ErrorMatching.Hmi.Testing;

/// <summary>The single application of a process without a screen, on its own UI thread (Avalonia allows one per process). Its work runs
/// sequentially.</summary>
[System.Diagnostics.CodeAnalysis.SuppressMessage("Design", "CA1001", Justification = "It lives as long as the process.")]
public sealed class OffScreenSession
{
    private static readonly Lock Starting = new();
    private static OffScreenSession? _current;
    private readonly Dispatcher _dispatcher;
    private readonly Task _ended;
    private readonly SemaphoreSlim _turn = new(1, 1);

    private OffScreenSession(Dispatcher dispatcher, Task ended) => (_dispatcher, _ended) = (dispatcher, ended);

    /// <summary>Pixels per device-independent unit, for windows opened from now on.</summary>
    public static double Scaling
    {
        get => OffScreenWindow.NextScaling;
        set => OffScreenWindow.NextScaling = value;
    }

    /// <summary>Starts the application, or returns the running one.</summary>
    /// <param name="configure">Creates the application's builder; the platform is added here.</param>
    /// <exception cref="PlatformNotSupportedException">A native library is missing.</exception>
    public static OffScreenSession Start(Func<AppBuilder> configure)
    {
        ArgumentNullException.ThrowIfNull(configure);
        lock (Starting)
        {
            if (_current is not null)
            {
                return _current;
            }

            var ready = new TaskCompletionSource<Dispatcher>(TaskCreationOptions.RunContinuationsAsynchronously);
            var ended = new TaskCompletionSource(TaskCreationOptions.RunContinuationsAsynchronously);
            new Thread(() => Live(configure, ready, ended)) { IsBackground = true, Name = "UI" }.Start();
            return _current = new OffScreenSession(ready.Task.GetAwaiter().GetResult(), ended.Task);
        }
    }

    /// <summary>Runs work on the UI thread after all earlier requests, so that work that pumps the dispatcher does not start the next
    /// request inside itself.</summary>
    public async Task RunAsync(Func<Task> work)
    {
        await _turn.WaitAsync();
        try
        {
            await await Task.WhenAny(_dispatcher.InvokeAsync(work), _ended);
        }
        finally
        {
            _turn.Release();
        }
    }

    /// <summary>Runs work on the UI thread after all earlier requests.</summary>
    public Task RunAsync(Action work) => RunAsync(() =>
    {
        work();
        return Task.CompletedTask;
    });

    private static void Live(Func<AppBuilder> configure, TaskCompletionSource<Dispatcher> ready, TaskCompletionSource ended)
    {
        try
        {
            configure().UseOffScreen().SetupWithoutStarting();
            ready.SetResult(Dispatcher.UIThread);
        }
        catch (Exception e)
        {
            ready.SetException(e);
            return;
        }

        // Without its thread no work would ever run: callers that wait get the exception that ended it.
        try
        {
            Dispatcher.UIThread.MainLoop(CancellationToken.None);
        }
        catch (Exception e)
        {
            ended.SetException(e);
        }
    }
}
