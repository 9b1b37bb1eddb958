namespace ErrorMatching.Hmi;

/// <summary>Settings: who may do what, whether machines and gauges answer, how the station looks to who sits there, and what it is.</summary>
public sealed class SettingsViewModel : ScreenViewModel
{
    private readonly ScreenViewModel[] _pages;

    /// <summary>The screen, with its pages.</summary>
    public SettingsViewModel(ShellViewModel shell)
        : base((shell ?? throw new ArgumentNullException(nameof(shell))).Station)
    {
        (Users, Connections, Look, About) = (new(shell), new(shell), new(shell), new(shell));
        _pages = [Users, Connections, Look, About];
    }

    /// <summary>Who may sign in, and what for.</summary>
    public UsersViewModel Users { get; }

    /// <summary>Whether machines and gauges answer.</summary>
    public ConnectionsViewModel Connections { get; }

    /// <summary>How the station looks.</summary>
    public LookViewModel Look { get; }

    /// <summary>What the station is.</summary>
    public AboutViewModel About { get; }

    /// <inheritdoc/>
    protected override void Dispose(bool isDisposing)
    {
        foreach (var page in _pages)
        {
            page.Dispose();
        }

        base.Dispose(isDisposing);
    }

    /// <inheritdoc/>
    protected override void Follow()
    {
        // The pages follow by themselves.
    }
}
