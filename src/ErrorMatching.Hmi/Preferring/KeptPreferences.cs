using System.Runtime.CompilerServices;

namespace ErrorMatching.Hmi;

/// <summary>The preferences that hold now: those of who is signed in, kept as soon as one of them is changed. Who has none yet takes what is shown.</summary>
public sealed class KeptPreferences : Observable, IDisposable
{
    private readonly Station _station;
    private string? _user;
    private bool _isDark;
    private TouchSize _touchSize;
    private IReadOnlyList<string> _folders = [];
    private string? _notice;

    /// <summary>Those of a station where nobody is signed in.</summary>
    public KeptPreferences(Station station)
    {
        _station = station ?? throw new ArgumentNullException(nameof(station));
        Texts.Current.LanguageChanged += Keep;
    }

    /// <summary>True for light on dark.</summary>
    public bool IsDark
    {
        get => _isDark;
        set => Change(ref _isDark, value);
    }

    /// <summary>How high what is touched is.</summary>
    public TouchSize TouchSize
    {
        get => _touchSize;
        set => Change(ref _touchSize, value);
    }

    /// <summary>Folders in which something was chosen, the latest first.</summary>
    public IReadOnlyList<string> Folders
    {
        get => _folders;
        set => Change(ref _folders, value);
    }

    /// <summary>Why they cannot be read or kept; null if they can.</summary>
    public string? Notice
    {
        get => _notice;
        set => Set(ref _notice, value);
    }

    /// <summary>Where they are kept; null if they are not.</summary>
    public string? File => _user is null ? null : _station.Preferences?.Of(_user);

    /// <summary>Done when everything is kept or read that was to be.</summary>
    internal Task Running { get; private set; } = Task.CompletedTask;

    /// <summary>Takes those of a user, or of nobody.</summary>
    public void Take(string? user)
    {
        _user = user;
        if (user is not null && _station.Preferences is { } files)
        {
            Running = ReadAsync(Running, files, user).Watched();
        }
    }

    /// <summary>Remembers a folder in which something was chosen.</summary>
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
            Running = KeepAsync(Running, files, user, new(Texts.Current.Language, IsDark, TouchSize, Folders)).Watched();
        }
    }

    // One after another: what was changed last is what is kept.
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
                // Nobody changed anything: nothing is to be kept.
                _user = null;
                (Texts.Current.Language, IsDark, TouchSize, Folders) = (read.Language, read.IsDark, read.TouchSize, read.Folders);
                _user = user;
            }
        }
        catch (Exception e) when (Failures.IsKnown(e))
        {
            Notice = Texts.Current.With("Preferences.Unreadable", Failures.Of(e, _station.Clock));
        }
    }
}
