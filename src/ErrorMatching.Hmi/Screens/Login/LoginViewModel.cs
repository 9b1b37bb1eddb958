using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Login by name and password, with a view of the cell's state for everyone.</summary>
public sealed class LoginViewModel : ScreenViewModel
{
    private readonly Action<SignedIn> _unlock;
    private IReadOnlyList<UserTile> _users = [];
    private string _name;
    private string _password = "";
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
        Live = new OverviewViewModel(station, null, null, null);
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

    public string CellName => Station.Settings.Name;

    /// <summary>True if the cell has no users yet, so that sign-in is impossible.</summary>
    public bool HasNoUsers { get; private set; }

    /// <summary>The command that creates the first user.</summary>
    public string FirstUserCommand => $"errormatch user add {Path.GetFileName(Station.Settings.File)} NAME --role administrator";

    /// <summary>Completes when the users are listed.</summary>
    internal Task Loading { get; private set; }

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

    private async Task SignInAsync()
    {
        SignedIn? who = null;
        var (name, password) = (Name.Trim(), Password);
        if (await TryAsync(() => who = Station.Session.SignIn(name, password)))
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
