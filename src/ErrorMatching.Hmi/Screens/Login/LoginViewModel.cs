using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Login by name and password, PIN or badge, with a view of the cell's state for everyone.</summary>
public sealed class LoginViewModel : ScreenViewModel, ITakesCodes
{
    private readonly Action<SignedIn> _unlock;
    private IReadOnlyList<UserTile> _users = [];
    private string _name;
    private string _password = "";
    private string? _badge;
    private bool _isListed;

    /// <summary>A locked station.</summary>
    /// <param name="station">The station.</param>
    /// <param name="lastName">The last user; empty if there was none.</param>
    /// <param name="unlock">Called with the user who signed in.</param>
    public LoginViewModel(Station station, string lastName, Action<SignedIn> unlock)
        : base(station)
    {
        (_unlock, LastName, _name) = (unlock, lastName, lastName);
        SignIn = new(_ => SignInAsync(), () => Name.Trim().Length > 0 && Password.Length > 0);
        Live = new OverviewViewModel(station, null, null, null, null);
        Loading = LoadAsync().Watched();
    }

    /// <summary>How to sign in to a demonstration; null at a real station.</summary>
    public string? Hint => Station.IsDemonstration ? Texts.Current.With("Login.Demonstration", DemoCell.Password, DemoCell.Setter) : null;

    /// <summary>The last user; empty if there was none.</summary>
    public string LastName { get; }

    /// <summary>The state of the cell.</summary>
    public OverviewViewModel Live { get; }

    public LongCommand SignIn { get; }

    /// <summary>The users who may sign in.</summary>
    public IReadOnlyList<UserTile> Users
    {
        get => _users;
        private set => Set(ref _users, value);
    }

    /// <summary>The user selected in the list; null if the name is typed.</summary>
    public UserTile? Chosen
    {
        get => Users.FirstOrDefault(u => u.Name == Name);
        set
        {
            if (value is not null)
            {
                Name = value.Name;
            }
        }
    }

    public string Name
    {
        get => _name;
        set
        {
            if (Set(ref _name, value ?? ""))
            {
                _badge = null;
                OnPropertyChanged(nameof(Chosen));
                SignIn.Refresh();
            }
        }
    }

    public string Password
    {
        get => _password;
        set
        {
            if (Set(ref _password, value ?? ""))
            {
                SignIn.Refresh();
            }
        }
    }

    /// <summary>What the field for the password takes, in words.</summary>
    public string PasswordLabel => Texts.Current[TakesPin ? "Login.PasswordOrPin" : "Login.Password"];

    /// <summary>True if a PIN counts, alone or with a badge.</summary>
    public bool TakesPin => Station.Session.TakesPins;

    /// <summary>That a badge can be scanned here, in words; null if the cell takes none.</summary>
    public string? BadgeHint => Station.Session.Ways switch
    {
        var ways when ways.HasFlag(SignInWays.Badge) => Texts.Current["Login.Badge"],
        var ways when ways.HasFlag(SignInWays.BadgeWithPin) => Texts.Current["Login.BadgeWithPin"],
        _ => null,
    };

    public string CellName => Station.Settings.Name;

    /// <summary>True if the cell has no users yet, so that sign-in is impossible.</summary>
    public bool HasNoUsers { get; private set; }

    /// <summary>The command that creates the first user.</summary>
    public string FirstUserCommand => $"errormatch user add {Path.GetFileName(Station.Settings.File)} NAME --role administrator";

    /// <summary>Completes when the users are listed.</summary>
    internal Task Loading { get; private set; }

    /// <summary>The last scan; completed if there was none.</summary>
    internal Task Scanning { get; private set; } = Task.CompletedTask;

    /// <summary>Takes a scanned badge.</summary>
    public void TakeCode(string code) => Scanning = TakeAsync(code).Watched();

    /// <summary>Asks for a user's password; what was typed for another one is forgotten.</summary>
    public void Ask(UserTile user)
    {
        ArgumentNullException.ThrowIfNull(user);
        (Name, Password) = (user.Name, "");
    }

    /// <inheritdoc/>
    protected override void Dispose(bool isDisposing)
    {
        Live.Dispose();
        base.Dispose(isDisposing);
    }

    /// <inheritdoc/>
    protected override void Follow()
    {
        // Live follows the cell. A list that could not be read is read when the store is available again.
        if (!_isListed && Loading.IsCompleted && Station.State.StoreTrouble is null)
        {
            Loading = LoadAsync().Watched();
        }
    }

    /// <inheritdoc/>
    protected override void Translate()
    {
        Users = [.. Users.Select(u => u with { RoleName = Texts.Current.Word(u.Role) })];
        OnPropertyChanged(nameof(Chosen));
        OnPropertyChanged(nameof(Hint));
        OnPropertyChanged(nameof(PasswordLabel));
        OnPropertyChanged(nameof(BadgeHint));
    }

    private async Task LoadAsync()
    {
        IReadOnlyList<User> users = [];
        if (await TryAsync(() => users = Station.Users.List()))
        {
            Users = [.. users.Where(u => !u.IsDisabled).Select(u => new UserTile(u.Name, u.Role, Texts.Current.Word(u.Role)))];
            (_isListed, HasNoUsers) = (true, users.Count == 0);
            OnPropertyChanged(nameof(HasNoUsers));
            OnPropertyChanged(nameof(Chosen));
        }
    }

    // Of a scanner that acts as a keyboard, the badge was also typed into a field.
    private async Task TakeAsync(string code)
    {
        (_badge, Name, Password) = (null, LastName, "");
        SignedIn? who = null;
        var owner = "";
        var isEnough = Station.Session.Ways.HasFlag(SignInWays.Badge);
        if (!await TryAsync(() =>
            {
                who = isEnough ? Station.Session.SignInByBadge(code, null) : null;
                owner = isEnough ? "" : Station.Session.OwnerOf(code);
            }))
        {
            return;
        }

        if (who is not null)
        {
            _unlock(who);
            return;
        }

        Name = owner;
        _badge = code;
        Report(() => Texts.Current.With("Login.NowPin", owner));
    }

    private async Task SignInAsync()
    {
        SignedIn? who = null;
        var (name, password, badge) = (Name.Trim(), Password, _badge);
        if (await TryAsync(
            () => who = badge is null ? Station.Session.SignIn(name, password) : Station.Session.SignInByBadge(badge, password)))
        {
            _unlock(who!);
        }

        Password = "";
    }
}

/// <summary>A user in the login list.</summary>
/// <param name="Name">The name.</param>
/// <param name="Role">The role.</param>
/// <param name="RoleName">The role in a word.</param>
public sealed record UserTile(string Name, Role Role, string RoleName)
{
    public string AutomationId => "login-user-" + Name;
}
