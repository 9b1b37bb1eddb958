using System.ComponentModel;
using System.Runtime.CompilerServices;

namespace ErrorMatching.Hmi;

/// <summary>Base class that reports property changes. Use it on the UI thread only.</summary>
public abstract class Observable : INotifyPropertyChanged
{
    /// <inheritdoc/>
    public event PropertyChangedEventHandler? PropertyChanged;

    /// <summary>Sets a property and reports a change.</summary>
    /// <returns>True if the value changed.</returns>
    protected bool Set<T>(ref T field, T value, [CallerMemberName] string? name = null)
    {
        if (EqualityComparer<T>.Default.Equals(field, value))
        {
            return false;
        }

        field = value;
        OnPropertyChanged(name);
        return true;
    }

    /// <summary>Reports that a property has changed; without a name, that all may have.</summary>
    protected void OnPropertyChanged(string? name = null) => PropertyChanged?.Invoke(this, new PropertyChangedEventArgs(name));
}
