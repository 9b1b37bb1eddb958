using System.ComponentModel;
using System.Runtime.CompilerServices;

namespace ErrorMatching.Hmi;

/// <summary>Something that says when a property of it has changed. Used on one thread, that of the screen.</summary>
public abstract class Observable : INotifyPropertyChanged
{
    /// <inheritdoc/>
    public event PropertyChangedEventHandler? PropertyChanged;

    /// <summary>Sets a property's value and says so if it is another one.</summary>
    /// <returns>True if it is another one.</returns>
    protected bool Set<T>(ref T field, T value, [CallerMemberName] string? name = null)
    {
        if (EqualityComparer<T>.Default.Equals(field, value))
        {
            return false;
        }

        field = value;
        Say(name);
        return true;
    }

    /// <summary>Says that a property has changed; without a name, that all may have.</summary>
    protected void Say(string? name = null) => PropertyChanged?.Invoke(this, new PropertyChangedEventArgs(name));
}
