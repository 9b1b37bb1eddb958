using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Users: an administrator adds and disables them and sets roles, passwords, PINs and badges. All others can view them
/// and change their own password and PIN. Each change is signed.</summary>
internal sealed class UsersViewModel : ScreenViewModel
{
    private readonly ShellViewModel _shell;
    private UserRow? _chosen;
    private RoleChoice _role;
    private string _name = "";
    private string _password = "";
    private string _again = "";
    private string _badge = "";
    private readonly Command _setBadge;

    public UsersViewModel(ShellViewModel shell)
        : base((shell ?? throw new ArgumentNullException(nameof(shell))).Station)
    {
        _shell = shell;
        _role = Roles[0];
        New = new(() => Chosen = null, () => IsManaging && !IsNew);
        Add = Change(
            "Users.Add",
            () => Name.Trim(),
            () => IsManaging && Name.Trim().Length > 0 && HasPassword,
            (by, name) => (password, role) => Station.Users.Add(by, name, role, password));
        SetRole = Change(
            "Users.SetRole",
            () => Chosen!.Name,
            () => IsManaging && Chosen is { } u && u.Role != Role.Role,
            (by, name) => (_, role) => Station.Users.SetRole(by, name, role));
        SetPassword = Change(
            "Users.SetPassword",
            () => Chosen!.Name,
            () => Chosen is { } u && (IsManaging || u.Name == _shell.UserName) && HasPassword,
            (by, name) => (password, _) => Station.Users.SetPassword(by, name, password));
        SetPin = Change(
            "Users.SetPin",
            () => Chosen!.Name,
            () => TakesPin && Chosen is not null && HasPassword && Password.All(char.IsAsciiDigit),
            (by, name) => (pin, _) => Station.Users.SetPin(by, name, pin));
        RemovePin = Change(
            "Users.RemovePin",
            () => Chosen!.Name,
            () => Chosen is { HasPin: true } && TakesPassword,
            (by, name) => (_, _) => Station.Users.RemovePin(by, name));
        _setBadge = Change(
            "Users.SetBadge",
            () => Chosen!.Name,
            () => IsChanging,
            (by, name) => (code, _) => Station.Users.SetBadge(by, name, code),
            () => _badge);
        RemoveBadge = Change(
            "Users.RemoveBadge",
            () => Chosen!.Name,
            () => IsChanging && Chosen!.HasBadge,
            (by, name) => (_, _) => Station.Users.RemoveBadge(by, name));
        Disable = Change(
            "Users.Disable",
            () => Chosen!.Name,
            () => IsManaging && Chosen is { IsDisabled: false },
            (by, name) => (_, _) => Station.Users.Disable(by, name));
        Enable = Change(
            "Users.Enable",
            () => Chosen!.Name,
            () => IsManaging && Chosen is { IsDisabled: true },
            (by, name) => (_, _) => Station.Users.Enable(by, name));
        Loading = LoadAsync(shell.UserName).Watched();
    }

    public RowList<UserRow> Rows { get; } = [];

    /// <summary>The roles, lowest first.</summary>
    public IReadOnlyList<RoleChoice> Roles { get; } = [.. Enum.GetValues<Role>().Select(r => new RoleChoice(r))];

    /// <summary>True if the current user may change users.</summary>
    public bool IsManaging => _shell.Who is { } who && Rights.Allows(who.Role, Act.ManageUsers);

    /// <summary>True while a new user is being entered.</summary>
    public bool IsNew => Chosen is null;

    /// <summary>The selected user; null for a new one.</summary>
    public UserRow? Chosen
    {
        get => _chosen;
        set
        {
            if (Set(ref _chosen, value))
            {
                (Name, Password, Again) = ("", "", "");
                Role = Roles.First(r => r.Role == (value?.Role ?? Cell.Role.Operator));
                OnPropertyChanged();
                Refresh();
            }
        }
    }

    /// <summary>Title of the right side.</summary>
    public string Title => Chosen?.Name ?? Texts.Current[IsManaging ? "Users.New" : "Users.Choose"];

    /// <summary>True if the password fields are shown.</summary>
    public bool TakesPassword => IsNew ? IsManaging : IsManaging || Chosen!.Name == _shell.UserName;

    /// <summary>True if the cell takes PINs, and the chosen user's can be set here.</summary>
    public bool TakesPin => !IsNew && TakesPassword && Station.Session.TakesPins;

    /// <summary>What is typed twice, in words.</summary>
    public string PasswordLabel => Texts.Current[TakesPin ? "Users.PasswordOrPin" : "Users.Password"];

    /// <summary>What it must be like, in words.</summary>
    public string PasswordRule => Texts.Current[TakesPin ? "Users.PinRule" : "Users.PasswordRule"];

    /// <summary>True if the cell takes badges, and one can be bound to the chosen user here.</summary>
    public bool TakesBadge => IsChanging && Station.Session.TakesBadges;

    /// <summary>True if the chosen user's PIN can be taken away here.</summary>
    public bool HasPin => Chosen is { HasPin: true } && TakesPassword;

    /// <summary>True if the chosen user's badge can be taken away here.</summary>
    public bool HasBadge => Chosen is { HasBadge: true } && IsChanging;

    /// <summary>True if a user's role and status can be changed.</summary>
    public bool IsChanging => IsManaging && !IsNew;

    /// <summary>True if a user is being added.</summary>
    public bool IsAdding => IsManaging && IsNew;

    public bool IsDisabled => Chosen is { IsDisabled: true };

    /// <summary>The name of a new user.</summary>
    public string Name
    {
        get => _name;
        set => Put(ref _name, value ?? "", nameof(Name));
    }

    /// <summary>The selected role.</summary>
    public RoleChoice Role
    {
        get => _role;
        set
        {
            // A list that leaves the screen loses its selection.
            if (value is not null)
            {
                Put(ref _role, value, nameof(Role));
            }
        }
    }

    /// <summary>A new password.</summary>
    public string Password
    {
        get => _password;
        set => Put(ref _password, value ?? "", nameof(Password));
    }

    /// <summary>The password, repeated.</summary>
    public string Again
    {
        get => _again;
        set => Put(ref _again, value ?? "", nameof(Again));
    }

    /// <summary>What is wrong with the two passwords; null if nothing.</summary>
    public string? PasswordProblem => Again.Length > 0 && Again != Password ? Texts.Current["Users.Differ"] : null;

    /// <summary>Starts entering a new user.</summary>
    public Command New { get; }

    public Command Add { get; }

    /// <summary>Assigns the role.</summary>
    public Command SetRole { get; }

    public Command SetPassword { get; }

    /// <summary>Sets what was typed twice as the PIN.</summary>
    public Command SetPin { get; }

    public Command RemovePin { get; }

    public Command RemoveBadge { get; }

    /// <summary>Binds a scanned badge to the chosen user, once that is signed.</summary>
    public void TakeCode(string code)
    {
        _badge = code;
        if (TakesBadge)
        {
            _setBadge.Execute(null);
        }
    }

    /// <summary>Disables the user, who then cannot sign in.</summary>
    public Command Disable { get; }

    /// <summary>Enables the user again.</summary>
    public Command Enable { get; }

    /// <summary>Completes when the users are listed.</summary>
    internal Task Loading { get; private set; }

    private bool HasPassword => Password.Length > 0 && Password == Again;

    /// <inheritdoc/>
    protected override void Follow()
    {
        // Users change only through this page. Changes made at a console appear when the page is opened again.
    }

    /// <inheritdoc/>
    protected override void Translate()
    {
        foreach (var role in Roles)
        {
            role.Rename();
        }

        Loading = LoadAsync(Chosen?.Name).Watched();
        OnPropertyChanged();
    }

    // A signature is valid for one act only, and the user book demands it.
    private Command Change(
        string title,
        Func<string> name,
        Func<bool> can,
        Func<SignedIn, string, Func<string, Role, User>> change,
        Func<string>? secret = null) => new(
        () =>
        {
            var (subject, password, role) = (name(), secret?.Invoke() ?? Password, Role.Role);
            var signing = new SigningViewModel(
                Station,
                _shell.Who!,
                Act.ManageUsers,
                title == "Users.SetRole" ? $"{subject}: {Texts.Current.Word(role)}" : subject,
                needsReason: false,
                (by, _, _) => Task.FromResult(change(by, subject)(password, role)))
            { TitleKey = title, IsDemandedElsewhere = true };
            signing.Signed += () => Loading = LoadAsync(subject).Watched();
            _shell.Sign(signing);
        },
        can);

    private void Put<T>(ref T field, T value, string name)
    {
        if (Set(ref field, value, name))
        {
            OnPropertyChanged(nameof(PasswordProblem));
            Refresh();
        }
    }

    private void Refresh()
    {
        foreach (var command in new[] { New, Add, SetRole, SetPassword, SetPin, RemovePin, _setBadge, RemoveBadge, Disable, Enable })
        {
            command.Refresh();
        }
    }

    private async Task LoadAsync(string? choose)
    {
        IReadOnlyList<User> users = [];
        if (await TryAsync(() => users = Station.Users.List()))
        {
            Rows.Show([.. users.Select(Row)]);
            _chosen = null;
            Chosen = Rows.FirstOrDefault(r => r.Name == choose);
            OnPropertyChanged();
            Refresh();
        }
    }

    private UserRow Row(User user) => new(
        user.Name,
        user.Role,
        Texts.Current.Word(user.Role),
        user.IsDisabled,
        user.IsDisabled
            ? Texts.Current["Users.IsDisabled"]
            : user.LockedUntil is { } until
            ? Texts.Current.With("Users.IsLocked", Shown.Time(until, Station.Clock))
            : "")
    {
        HasPin = user.HasPin,
        HasBadge = user.HasBadge,
    };
}

/// <summary>A user in the list of users.</summary>
/// <param name="Name">The name.</param>
/// <param name="Role">The role.</param>
/// <param name="RoleName">The role in a word.</param>
/// <param name="IsDisabled">True if the user may not sign in.</param>
/// <param name="Standing">Disabled or locked, in words; empty if neither.</param>
internal sealed record UserRow(string Name, Role Role, string RoleName, bool IsDisabled, string Standing)
{
    public string AutomationId => "user-row-" + Name;

    public bool HasPin { get; init; }

    public bool HasBadge { get; init; }
}

/// <summary>A role to choose. The object stays the same in another language, so that it stays selected.</summary>
/// <param name="role">The role.</param>
internal sealed class RoleChoice(Role role) : Observable
{
    public Role Role { get; } = role;

    public string Name => Texts.Current.Word(Role);

    /// <summary>Updates the name after a change of language.</summary>
    internal void Rename() => OnPropertyChanged(nameof(Name));
}
