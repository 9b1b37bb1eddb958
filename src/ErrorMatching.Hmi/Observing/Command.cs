using System.Windows.Input;

namespace ErrorMatching.Hmi;

/// <summary>Something a person can do at once.</summary>
/// <param name="run">Does it.</param>
/// <param name="can">Whether it can be done now; null if always.</param>
public sealed class Command(Action run, Func<bool>? can = null) : ICommand
{
    /// <inheritdoc/>
    public event EventHandler? CanExecuteChanged;

    /// <inheritdoc/>
    public bool CanExecute(object? parameter) => can?.Invoke() ?? true;

    /// <inheritdoc/>
    public void Execute(object? parameter)
    {
        if (CanExecute(parameter))
        {
            run();
        }
    }

    /// <summary>Says that it may be possible now, or not any more.</summary>
    public void Refresh() => CanExecuteChanged?.Invoke(this, EventArgs.Empty);
}
