namespace ErrorMatching.Hmi;

/// <summary>View model of a screen. Created each time the screen is opened, and disposed when it is left.</summary>
/// <remarks>It knows no Avalonia, so that it is tested without a window. What it shows of the cell is in the immutable
/// <see cref="StationState"/>. The store is queried off the UI thread, such as by <see cref="TryAsync"/>.</remarks>
public abstract class ScreenViewModel : Observable, IDisposable
{
    private string? _message;
    private Func<string>? _words;

    /// <summary>Follows changes in the cell and of the language.</summary>
    protected ScreenViewModel(Station station)
    {
        Station = station ?? throw new ArgumentNullException(nameof(station));
        Station.Changed += Follow;
        Texts.Current.LanguageChanged += Translate;
    }

    public Station Station { get; }

    /// <summary>The error message; null if there is none.</summary>
    public string? Message
    {
        get => _words?.Invoke() ?? _message;
        protected set
        {
            _words = null;
            _message = value;
            OnPropertyChanged(nameof(Message));
        }
    }

    /// <summary>Shows a message that is translated again when the language changes.</summary>
    protected internal void Report(Func<string>? words)
    {
        (_words, _message) = (words, null);
        OnPropertyChanged(nameof(Message));
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        Dispose(isDisposing: true);
        GC.SuppressFinalize(this);
    }

    /// <summary>Stops following the station.</summary>
    protected virtual void Dispose(bool isDisposing)
    {
        Station.Changed -= Follow;
        Texts.Current.LanguageChanged -= Translate;
    }

    /// <summary>Called on the UI thread when the cell has changed.</summary>
    protected virtual void Follow() => OnPropertyChanged();

    /// <summary>Called when the language has changed.</summary>
    protected virtual void Translate() => Follow();

    /// <summary>Runs work off the UI thread; the store and password hashing are slow. Failures set <see cref="Message"/>.</summary>
    /// <returns>True if it succeeded.</returns>
    protected internal async Task<bool> TryAsync(Action work)
    {
        Message = null;
        if (await Failures.OfAsync(work, Station.Clock) is not { } failure)
        {
            return true;
        }

        Message = failure;
        return false;
    }
}
