using System.Windows.Input;

namespace ErrorMatching.Hmi;

/// <summary>Something a person can do that takes its time: it runs beside the screen, once at a time, and can be cancelled.</summary>
[System.Diagnostics.CodeAnalysis.SuppressMessage("Design", "CA1001", Justification = "A run disposes what it made when it ends.")]
public sealed class LongCommand : Observable, ICommand
{
    private readonly Func<CancellationToken, Task> _run;
    private readonly Func<bool>? _can;
    private CancellationTokenSource? _cancellation;
    private bool _isAsking;

    /// <summary>A command.</summary>
    /// <param name="run">Does it. Whatever may fail in it, it says itself.</param>
    /// <param name="can">Whether it can be done now; null if always.</param>
    public LongCommand(Func<CancellationToken, Task> run, Func<bool>? can = null)
    {
        (_run, _can) = (run, can);
        Cancel = new(() => _cancellation?.Cancel(), () => IsRunning);
    }

    /// <inheritdoc/>
    public event EventHandler? CanExecuteChanged;

    /// <summary>Ends it before it is done.</summary>
    public Command Cancel { get; }

    /// <summary>True from the tap until it is done.</summary>
    public bool IsRunning => _cancellation is not null;

    /// <summary>True while it runs and does not wait for somebody: it makes progress.</summary>
    public bool IsWorking => IsRunning && !_isAsking;

    /// <summary>The run that is under way, or the last one; done if there was none.</summary>
    public Task Running { get; private set; } = Task.CompletedTask;

    /// <inheritdoc/>
    public bool CanExecute(object? parameter) => !IsRunning && (_can?.Invoke() ?? true);

    /// <inheritdoc/>
    public void Execute(object? parameter)
    {
        if (CanExecute(parameter))
        {
            Running = RunAsync().Watched();
        }
    }

    /// <summary>Waits within a run for what somebody answers: as long as they think, nothing goes on.</summary>
    public async Task<T> AskAsync<T>(Func<Task<T>> ask)
    {
        ArgumentNullException.ThrowIfNull(ask);
        Ask(true);
        try
        {
            return await ask();
        }
        finally
        {
            Ask(false);
        }
    }

    /// <summary>Says that it may be possible now, or not any more.</summary>
    public void Refresh()
    {
        CanExecuteChanged?.Invoke(this, EventArgs.Empty);
        Cancel.Refresh();
    }

    private async Task RunAsync()
    {
        using var cancellation = _cancellation = new();
        SayRunning();
        try
        {
            await _run(cancellation.Token);
        }
        catch (OperationCanceledException) when (cancellation.IsCancellationRequested)
        {
            // That is what was asked for.
        }
        finally
        {
            _cancellation = null;
            SayRunning();
        }
    }

    private void SayRunning()
    {
        Say(nameof(IsRunning));
        Say(nameof(IsWorking));
        Refresh();
    }

    private void Ask(bool isAsking)
    {
        _isAsking = isAsking;
        Say(nameof(IsWorking));
    }
}
