namespace ErrorMatching.Hmi;

/// <summary>Settings: users, connections, appearance, and information about the station.</summary>
internal sealed class SettingsViewModel : ScreenViewModel, ITakesCodes
{
    private readonly ScreenViewModel[] _pages;

    public SettingsViewModel(ShellViewModel shell)
        : base((shell ?? throw new ArgumentNullException(nameof(shell))).Station)
    {
        (Users, Connections, Look, About) = (new(shell), new(shell), new(shell), new(shell));
        _pages = [Users, Connections, Look, About];
    }

    /// <summary>Users and their roles.</summary>
    public UsersViewModel Users { get; }

    /// <summary>Tests of machines and gauges.</summary>
    public ConnectionsViewModel Connections { get; }

    /// <summary>The station's appearance.</summary>
    public LookViewModel Look { get; }

    /// <summary>Information about the station.</summary>
    public AboutViewModel About { get; }

    /// <summary>Takes a badge that is to belong to the chosen user.</summary>
    public void TakeCode(string code) => Users.TakeCode(code);

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
        // The pages follow the cell themselves.
    }
}
