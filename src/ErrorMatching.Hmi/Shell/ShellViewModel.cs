using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>The frame around all screens: navigation, current user, problems of the cell, and the lock.</summary>
public sealed class ShellViewModel : Observable, IDisposable
{
    private readonly SeatGuard _seat;
    private readonly Func<string, Action<SignedIn>, ScreenViewModel> _openLogin;
    private NavigationItem? _chosen;
    private ScreenViewModel? _current;
    private ScreenViewModel? _login;
    private SigningViewModel? _signing;
    private FileChooserViewModel? _choosing;
    private LeavingViewModel? _leaving;
    private SignedIn? _who;
    private string _lastName = "";

    /// <summary>The shell of a station, locked until a user signs in.</summary>
    /// <param name="station">The station.</param>
    /// <param name="login">Creates the login, given the last user's name, empty if there was none, and what to do with the user who
    /// signs in.</param>
    /// <param name="screens">The screens after the login, in the order of the navigation.</param>
    public ShellViewModel(Station station, Func<string, Action<SignedIn>, ScreenViewModel> login, IReadOnlyList<Screen> screens)
    {
        Station = station ?? throw new ArgumentNullException(nameof(station));
        _openLogin = login;
        Preferences = new(station);
        Preferences.PropertyChanged += (_, e) => OnSaidChanged(e.PropertyName);
        CloseNotice = new(() => Preferences.Notice = null);
        Items = [.. screens.Select(s => new NavigationItem(s))];
        SignOut = new(_ => SignOutAsync());
        SwitchLanguage = new(
            () => Texts.Current.Language = Texts.Current.Language == Language.English ? Language.TraditionalChinese : Language.English);
        SwitchTheme = new(() => IsDark = !IsDark);
        Editing = new(station, () => _who);
        Editing.Begun += () => Looked.SystemSide = 0;
        Editing.Asked += Ask;
        Station.Changed += Follow;
        Texts.Current.LanguageChanged += Translate;
        Lock();
        _seat = new(station, Lock);
    }

    public Station Station { get; }

    public IReadOnlyList<NavigationItem> Items { get; }

    /// <summary>The job being edited at this station, whichever set-up screen shows it.</summary>
    public JobEditing Editing { get; }

    /// <summary>Signs out, which locks the station.</summary>
    public LongCommand SignOut { get; }

    /// <summary>Switches to the other language.</summary>
    public Command SwitchLanguage { get; }

    /// <summary>Switches between light and dark.</summary>
    public Command SwitchTheme { get; }

    /// <summary>The open screen, as a navigation item; null before the first sign-in.</summary>
    public NavigationItem? Chosen
    {
        get => _chosen;
        set
        {
            if (value is not null && value != _chosen)
            {
                Show(value, value.Screen.Open(this));
            }
        }
    }

    /// <summary>The content in the middle: the login while the station is locked.</summary>
    public ScreenViewModel? Current => _login ?? _current;

    /// <summary>The open signing dialog; null if there is none.</summary>
    public SigningViewModel? Signing
    {
        get => _signing;
        private set
        {
            if (Set(ref _signing, value))
            {
                OnPropertyChanged(nameof(IsFree));
            }
        }
    }

    /// <summary>The open file chooser; null if there is none.</summary>
    public FileChooserViewModel? Choosing
    {
        get => _choosing;
        private set
        {
            if (Set(ref _choosing, value))
            {
                OnPropertyChanged(nameof(IsFree));
            }
        }
    }

    /// <summary>The open question whether to close the station; null if there is none.</summary>
    public LeavingViewModel? Leaving
    {
        get => _leaving;
        private set
        {
            if (Set(ref _leaving, value))
            {
                OnPropertyChanged(nameof(IsFree));
            }
        }
    }

    /// <summary>True if no dialog is in front of the screen.</summary>
    public bool IsFree => Signing is null && Choosing is null && Leaving is null;

    /// <summary>True while no user is signed in.</summary>
    public bool IsLocked => _login is not null;

    /// <summary>True for the dark theme.</summary>
    public bool IsDark
    {
        get => Preferences.IsDark;
        set => Preferences.IsDark = value;
    }

    /// <summary>Height of touch targets.</summary>
    public TouchSize TouchSize => Preferences.TouchSize;

    /// <summary>A notice about the user's preferences; null if there is none.</summary>
    public string? Notice => Preferences.Notice;

    /// <summary>Closes the notice.</summary>
    public Command CloseNotice { get; }

    /// <summary>The current user's preferences.</summary>
    public StoredPreferences Preferences { get; }

    public string CellName => Station.Settings.Name;

    /// <summary>The current user's name; empty if no user is signed in.</summary>
    public string UserName => _who?.Name ?? "";

    /// <summary>The current user's role, in a word.</summary>
    public string UserRole => _who is null ? "" : Texts.Current.Word(_who.Role);

    /// <summary>What the cell cannot do now, and what still works; null if there is no problem.</summary>
    public string? Banner => Station.State switch
    {
        { StoreTrouble: { } trouble } => Texts.Current.With("Banner.Store", Texts.Current.Word(trouble.Error)),
        { Status: { IsRunning: false } } => Texts.Current["Banner.NotRunning"],
        { Status.Heartbeat.Troubles: [var only] } =>
            Texts.Current.With("Banner.Trouble", CodeText.Where(only.Where), CodeText.Of(only.Code, only.Statement)),
        { Status.Heartbeat.Troubles: [_, ..] and var troubles } => Texts.Current.With("Banner.Troubles", troubles.Count),
        _ => null,
    };

    /// <summary>True if the <see cref="Notice"/> is shown: a banner about the cell has priority.</summary>
    public bool IsNoticed => Notice is not null && Banner is null;

    /// <summary>True if neither a banner nor a notice replaces the cell's name.</summary>
    public bool IsCellNamed => Notice is null && Banner is null;

    /// <summary>The current user; null if no user is signed in.</summary>
    internal SignedIn? Who => _who;

    /// <summary>The current user's last choice on each screen.</summary>
    internal LastLooked Looked { get; private set; } = new();

    /// <summary>Opens the on-line compensation at a correction.</summary>
    public void Look(long correction) => Open(ScreenKeys.Compensation, s => (s as ILooksAt)?.LookAt(correction));

    /// <summary>Opens the verification at a piece.</summary>
    public void LookAtPiece(long correction) => Open(ScreenKeys.Verification, s => (s as ILooksAt)?.LookAt(correction));

    /// <summary>Opens a screen at something in it.</summary>
    /// <param name="key">Its key.</param>
    /// <param name="at">Called before it is shown.</param>
    public void Open(string key, Action<ScreenViewModel> at)
    {
        ArgumentNullException.ThrowIfNull(at);
        if (!IsLocked && Items.FirstOrDefault(i => i.Screen.Key == key) is { } item && item.Screen.Open(this) is { } screen)
        {
            at(screen);
            Show(item, screen);
        }
    }

    /// <summary>Opens a screen.</summary>
    public void Go(string key) => Chosen = Items.First(i => i.Screen.Key == key);

    /// <summary>True if a scanned code is a badge now, also if a field has the focus: somebody signs in or signs, and the cell takes
    /// badges.</summary>
    public bool ExpectsBadge => (IsLocked || Signing is { NeedsPassword: true }) && Station.Session.TakesBadges;

    /// <summary>Completes when the last code was taken.</summary>
    internal Task Scanning { get; private set; } = Task.CompletedTask;

    /// <summary>Handles a code from a scanner. While somebody signs in or signs, it is a badge if the cell takes badges, and nothing
    /// otherwise. Else the open screen takes it if it accepts codes, otherwise the history.</summary>
    public void Scan(string code)
    {
        if (ExpectsBadge)
        {
            ((ITakesCodes?)Signing ?? _login as ITakesCodes)?.TakeCode(code);
            return;
        }

        if (IsLocked || !IsFree || Editing.Save.IsRunning || Editing.PutInUse.IsRunning)
        {
            return;
        }

        if (Station.Session.TakesBadges)
        {
            Scanning = TakeAsync(code).Watched();
        }
        else
        {
            Take(code);
        }
    }

    /// <summary>Lets the user choose a file or folder in a dialog.</summary>
    /// <returns>Its full path; null if nothing was chosen, or if the station was locked meanwhile.</returns>
    public async Task<string?> ChooseAsync(FileChoice choice)
    {
        ArgumentNullException.ThrowIfNull(choice);
        Choosing?.Leave.Execute(null);
        if (IsLocked)
        {
            return null;
        }

        var cellFolder = Path.GetDirectoryName(Path.GetFullPath(Station.Settings.File))!;
        var begin = string.IsNullOrWhiteSpace(choice.Start) ? FirstFolder(choice, cellFolder) : choice.Start;
        var chooser = new FileChooserViewModel(choice, begin, cellFolder, Station.SamplesFolder, Preferences.Folders, Station.Clock);
        var chosen = new TaskCompletionSource<string?>();
        chooser.Done += path =>
        {
            Choosing = Choosing == chooser ? null : Choosing;
            chosen.TrySetResult(path);
        };
        Choosing = chooser;
        var path = await chosen.Task;
        if (path is not null && (choice.Kind == FileChoiceKind.Folder ? path : Path.GetDirectoryName(path)) is { } folder)
        {
            Preferences.Remember(folder);
        }

        return path;
    }

    /// <summary>True if the station may be closed now. If the edited job has changes that are not saved, the user is asked first.</summary>
    /// <param name="close">Called if the user closes all the same.</param>
    public bool MayClose(Action close)
    {
        if (!Editing.IsChanged)
        {
            return true;
        }

        Leaving ??= new(
            Editing.Place?.Name ?? "",
            () =>
            {
                Leaving = null;
                close();
            },
            () => Leaving = null);
        return false;
    }

    /// <summary>Opens a signing dialog.</summary>
    internal void Sign(SigningViewModel signing)
    {
        Signing = signing;
        signing.Done += () => Signing = null;
    }

    /// <summary>Call this on every key press or tap. It does work once a second at most.</summary>
    public void Touch()
    {
        if (!IsLocked)
        {
            _seat.Touch();
        }
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        _seat.Dispose();
        Station.Changed -= Follow;
        Texts.Current.LanguageChanged -= Translate;
        Preferences.Dispose();
        _login?.Dispose();
        _current?.Dispose();
        Editing.Dispose();
    }

    // A badge that somebody shows too late is not searched for, where everybody could read it.
    private async Task TakeAsync(string code)
    {
        var isBadge = false;
        if (await Failures.OfAsync(() => isBadge = Station.Users.IsBadge(code), Station.Clock) is null
            && !IsLocked
            && IsFree
            && (!isBadge || Chosen?.Screen.Key == ScreenKeys.Settings))
        {
            Take(code);
        }
    }

    private void Take(string code)
    {
        if (_current is not ITakesCodes)
        {
            Go(ScreenKeys.History);
        }

        (_current as ITakesCodes)?.TakeCode(code);
    }

    // The last folder used. Without one, a demonstration opens files from the samples' folder, but does not write there.
    private string FirstFolder(FileChoice choice, string cellFolder)
    {
        var samples = choice.Kind == FileChoiceKind.Open ? Station.SamplesFolder : null;
        var folder = Preferences.Folders is [var last, ..] ? last : samples ?? cellFolder;
        return folder == samples && choice.Sample is { } meant ? Path.Combine(folder, meant) : folder;
    }

    private void Show(NavigationItem item, ScreenViewModel screen)
    {
        _current?.Dispose();
        (_chosen, _current) = (item, screen);
        OnPropertyChanged(nameof(Chosen));
        OnPropertyChanged(nameof(Current));
    }

    private void Lock()
    {
        if (_login is not null)
        {
            return;
        }

        (Signing, Leaving) = (null, null);
        Choosing?.Leave.Execute(null);
        _lastName = UserName;
        _login = _openLogin(_lastName, Unlock);
        _who = null;
        Preferences.Take(null);
        OnPropertyChanged();
    }

    private async Task SignOutAsync()
    {
        await _seat.LeaveAsync();
        Lock();
    }

    private void Unlock(SignedIn who)
    {
        // The same user finds the screen unchanged; another user starts at the overview.
        var isOther = _lastName != who.Name;
        _login!.Dispose();
        (_login, _who) = (null, who);
        _seat.Arrive();
        Preferences.Take(who.Name);
        Editing.Refresh();
        Looked = isOther ? new() : Looked;
        if (isOther || _current is null)
        {
            Show(Items[0], Items[0].Screen.Open(this));
        }

        OnPropertyChanged();
    }

    private void Ask(JobReplacement replacement)
    {
        // The user who tapped may have signed out meanwhile; the draft is kept.
        if (_who is { } who)
        {
            SignedIn? signed = null;
            var signing = new SigningViewModel(
                Station, who, Act.EditJobs, replacement.Name, needsReason: false, (by, _, _) => Task.FromResult(signed = by))
            {
                TitleKey = replacement.IsNew ? "Setup.Replace" : "Setup.Sign",
                Told = () => replacement.Told,
                Known = () => replacement.Facts,

                // Saving demands it.
                IsDemandedElsewhere = true,
            };
            signing.Signed += () => Editing.SaveSigned(signed!);
            Sign(signing);
        }
    }

    private void Follow() => OnSaidChanged(nameof(Banner));

    private void OnSaidChanged(string? name)
    {
        OnPropertyChanged(name);
        OnPropertyChanged(nameof(IsNoticed));
        OnPropertyChanged(nameof(IsCellNamed));
    }

    private void Translate()
    {
        foreach (var item in Items)
        {
            item.Rename();
        }

        Choosing?.Translate();
        Signing?.Translate();
        Leaving?.Translate();
        OnPropertyChanged(nameof(Banner));
        OnPropertyChanged(nameof(UserRole));
    }
}

/// <summary>A screen in the navigation, with its name in the display language.</summary>
public sealed class NavigationItem : Observable
{
    public NavigationItem(Screen screen)
    {
        Screen = screen ?? throw new ArgumentNullException(nameof(screen));
    }

    public Screen Screen { get; }

    public string Name => Texts.Current["Screen." + Screen.Key];

    /// <summary>Updates the name after a change of language.</summary>
    internal void Rename() => OnPropertyChanged(nameof(Name));
}

/// <summary>The current user's last choice on each screen, restored when the screen is opened again. Another user starts without
/// choices.</summary>
internal sealed class LastLooked
{
    /// <summary>The correction chosen in the on-line compensation; null if there is none. Sets <see cref="Piece"/>, too.</summary>
    public long? Correction
    {
        get;
        set => Piece = field = value;
    }

    /// <summary>The correction last selected automatically in the on-line compensation, as long as the user chose none; null if
    /// there is none. It stays selected while it waits, even if a longer-waiting one has arrived meanwhile.</summary>
    public long? Shown { get; set; }

    /// <summary>The mating chosen in the verification; null if there is none.</summary>
    public string? Mating { get; set; }

    /// <summary>The piece chosen in the verification, by the number of its correction or measured counterpart; null if there is
    /// none.</summary>
    public long? Piece { get; set; }

    /// <summary>The chosen free-form job; null if there is none.</summary>
    public string? SurfaceJob { get; set; }

    /// <summary>The chosen measured surface; null if there is none.</summary>
    public long? Surface { get; set; }

    /// <summary>The tab of the system set-up.</summary>
    public int SystemSide { get; set; }
}
