using System.Windows.Input;

namespace ErrorMatching.Hmi;

/// <summary>A long-running command: it runs in the background, one run at a time, and can be canceled.</summary>
[System.Diagnostics.CodeAnalysis.SuppressMessage("Design", "CA1001", Justification = "A run disposes what it made when it ends.")]
public sealed class LongCommand : Observable, ICommand
{
    private readonly Func<CancellationToken, Task> _run;
    private readonly Func<bool>? _can;
    private CancellationTokenSource? _cancellation;
    private bool _isAsking;

    /// <summary>Creates the command.</summary>
    /// <param name="run">The work. It must report its own failures.</param>
    /// <param name="can">Whether it can run now; null for always.</param>
    public LongCommand(Func<CancellationToken, Task> run, Func<bool>? can = null)
    {
        (_run, _can) = (run, can);
        Cancel = new(() => _cancellation?.Cancel(), () => IsRunning);
    }

    /// <inheritdoc/>
    public event EventHandler? CanExecuteChanged;

    /// <summary>Cancels the run.</summary>
    public Command Cancel { get; }

    /// <summary>True from the tap until the end of the run.</summary>
    public bool IsRunning => _cancellation is not null;

    /// <summary>True while it makes progress, that is, runs without waiting for the user.</summary>
    public bool IsWorking => IsRunning && !_isAsking;

    /// <summary>The current run, or the last one; completed if there was none.</summary>
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

    /// <summary>Waits for the user's answer during a run.</summary>
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

    /// <summary>Call this when the result of <c>can</c> may have changed.</summary>
    public void Refresh()
    {
        CanExecuteChanged?.Invoke(this, EventArgs.Empty);
        Cancel.Refresh();
    }

    private async Task RunAsync()
    {
        using var cancellation = _cancellation = new();
        OnRunningChanged();
        try
        {
            await _run(cancellation.Token);
        }
        catch (OperationCanceledException) when (cancellation.IsCancellationRequested)
        {
            // The user canceled.
        }
        finally
        {
            _cancellation = null;
            OnRunningChanged();
        }
    }

    private void OnRunningChanged()
    {
        OnPropertyChanged(nameof(IsRunning));
        OnPropertyChanged(nameof(IsWorking));
        Refresh();
    }

    private void Ask(bool isAsking)
    {
        _isAsking = isAsking;
        OnPropertyChanged(nameof(IsWorking));
    }
}
