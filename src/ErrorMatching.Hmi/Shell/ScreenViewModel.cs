namespace ErrorMatching.Hmi;

/// <summary>What a screen shows and does. It is made anew each time the screen is opened, and let go when it is left.</summary>
public abstract class ScreenViewModel : Observable, IDisposable
{
    private string? _message;
    private Func<string>? _words;
    private bool _isLeft;

    /// <summary>A screen of a station, which follows what happens in the cell and the language.</summary>
    protected ScreenViewModel(Station station)
    {
        Station = station ?? throw new ArgumentNullException(nameof(station));
        Station.Changed += Follow;
        Texts.Current.LanguageChanged += Translate;
    }

    /// <summary>The station.</summary>
    public Station Station { get; }

    /// <summary>What did not work, in words; null if nothing is to be said.</summary>
    public string? Message
    {
        get => _words?.Invoke() ?? _message;
        protected set
        {
            _words = null;
            _message = value;
            Say(nameof(Message));
        }
    }

    /// <summary>Says something that is said anew in another language.</summary>
    protected void Tell(Func<string>? words)
    {
        (_words, _message) = (words, null);
        Say(nameof(Message));
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        Dispose(isDisposing: true);
        GC.SuppressFinalize(this);
    }

    /// <summary>Lets go of the station.</summary>
    protected virtual void Dispose(bool isDisposing)
    {
        _isLeft = true;
        Station.Changed -= Follow;
        Texts.Current.LanguageChanged -= Translate;
    }

    /// <summary>Called when something has changed in the cell, on the screen's thread.</summary>
    protected virtual void Follow() => Say();

    /// <summary>Called when the language has changed.</summary>
    protected virtual void Translate() => Follow();

    /// <summary>Does something beside the screen: the store and passwords take their time. What does not work becomes the <see cref="Message"/>.</summary>
    /// <returns>True if it worked.</returns>
    protected async Task<bool> TryAsync(Action work)
    {
        Message = null;
        try
        {
            if (await Failures.OfAsync(work, Station.Clock) is not { } failure)
            {
                return true;
            }

            Message = failure;
        }
        catch (ObjectDisposedException) when (_isLeft)
        {
            // The station was closed while a screen that is not there any more was being read for: nobody waits for that.
        }

        return false;
    }
}
