using System.Windows.Input;

namespace ErrorMatching.Hmi;

/// <summary>A command that completes at once.</summary>
/// <param name="run">The action.</param>
/// <param name="can">Whether it can run now; null for always.</param>
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

    /// <summary>Call this when the result of <c>can</c> may have changed.</summary>
    public void Refresh() => CanExecuteChanged?.Invoke(this, EventArgs.Empty);
}
