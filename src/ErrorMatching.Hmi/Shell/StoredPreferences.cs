using System.Runtime.CompilerServices;

namespace ErrorMatching.Hmi;

/// <summary>The preferences in effect: those of the current user, stored as soon as one of them changes. A user without stored
/// preferences gets the current ones.</summary>
public sealed class StoredPreferences : Observable, IDisposable
{
    private readonly Station _station;
    private string? _user;
    private bool _isDark;
    private TouchSize _touchSize;
    private KeyboardUse _keyboard = Preferences.UsualKeyboard;
    private IReadOnlyList<string> _folders = [];
    private string? _notice;

    /// <summary>The preferences of a station before the first sign-in.</summary>
    public StoredPreferences(Station station)
    {
        _station = station ?? throw new ArgumentNullException(nameof(station));
        Texts.Current.LanguageChanged += Keep;
    }

    /// <summary>True for the dark theme.</summary>
    public bool IsDark
    {
        get => _isDark;
        set => Change(ref _isDark, value);
    }

    /// <summary>Height of touch targets.</summary>
    public TouchSize TouchSize
    {
        get => _touchSize;
        set => Change(ref _touchSize, value);
    }

    /// <summary>When the keyboard on the screen opens.</summary>
    public KeyboardUse Keyboard
    {
        get => _keyboard;
        set => Change(ref _keyboard, value);
    }

    /// <summary>Recently used folders, latest first.</summary>
    public IReadOnlyList<string> Folders
    {
        get => _folders;
        set => Change(ref _folders, value);
    }

    /// <summary>Why they cannot be read or stored; null if they can.</summary>
    public string? Notice
    {
        get => _notice;
        set => Set(ref _notice, value);
    }

    /// <summary>The file they are stored in; null if they are not stored.</summary>
    public string? File => _user is null ? null : _station.Preferences?.Of(_user);

    /// <summary>Completes when all pending reading and storing is done.</summary>
    internal Task Running { get; private set; } = Task.CompletedTask;

    /// <summary>Loads the preferences of a user, or of no user.</summary>
    public void Take(string? user)
    {
        _user = user;
        if (user is not null && _station.Preferences is { } files)
        {
            Running = ReadAsync(Running, files, user).Watched();
        }
    }

    /// <summary>Remembers a recently used folder.</summary>
    public void Remember(string folder) => Folders = [.. Folders.Where(f => f != folder).Prepend(folder).Take(PreferenceFiles.MostFolders)];

    /// <inheritdoc/>
    public void Dispose() => Texts.Current.LanguageChanged -= Keep;

    private void Change<T>(ref T field, T value, [CallerMemberName] string? name = null)
    {
        if (Set(ref field, value, name))
        {
            Keep();
        }
    }

    private void Keep()
    {
        if (_user is { } user && _station.Preferences is { } files)
        {
            Running = KeepAsync(Running, files, user, new(Texts.Current.Language, IsDark, TouchSize, Keyboard, Folders)).Watched();
        }
    }

    // One after another, so that the last change wins.
    private async Task KeepAsync(Task before, PreferenceFiles files, string user, Preferences preferences)
    {
        await before;
        if (await Failures.OfAsync(() => files.Keep(user, preferences), _station.Clock) is { } failure)
        {
            Notice = Texts.Current.With("Preferences.NotKept", failure);
        }
    }

    private async Task ReadAsync(Task before, PreferenceFiles files, string user)
    {
        await before;
        try
        {
            var read = await Task.Run(() => files.Read(user));
            if (read is not null && _user == user)
            {
                // With no user set, the values just read are not stored again.
                _user = null;
                (Texts.Current.Language, IsDark, TouchSize) = (read.Language, read.IsDark, read.TouchSize);
                (Keyboard, Folders) = (read.Keyboard, read.Folders);
                _user = user;
            }
        }
        catch (Exception e) when (Failures.IsKnown(e))
        {
            Notice = Texts.Current.With("Preferences.Unreadable", Failures.Of(e, _station.Clock));
        }
    }
}
