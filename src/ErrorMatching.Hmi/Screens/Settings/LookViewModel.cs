namespace ErrorMatching.Hmi;

/// <summary>How the station looks to who sits there: language, theme, size of what is touched. It is kept with the name.</summary>
public sealed class LookViewModel : ScreenViewModel
{
    private readonly ShellViewModel _shell;

    /// <summary>The page.</summary>
    public LookViewModel(ShellViewModel shell)
        : base((shell ?? throw new ArgumentNullException(nameof(shell))).Station)
    {
        _shell = shell;
        _shell.Preferences.PropertyChanged += OnPreferences;
    }

    /// <summary>The languages, each in its own words.</summary>
    public IReadOnlyList<LookChoice> Languages { get; } = [.. Enum.GetValues<Language>().Select(l => new LookChoice(l.ToString(), () => Texts.Of(l)["Language.Name"]))];

    /// <summary>Light and dark.</summary>
    public IReadOnlyList<LookChoice> Themes { get; } = [new("light", () => Texts.Current["Look.Light"]), new("dark", () => Texts.Current["Look.Dark"])];

    /// <summary>The sizes of what is touched.</summary>
    public IReadOnlyList<LookChoice> Sizes { get; } = [.. Enum.GetValues<TouchSize>().Select(s => new LookChoice(s.ToString(), () => Texts.Current.Word(s)))];

    /// <summary>The language.</summary>
    public LookChoice? Language
    {
        get => Languages.First(l => l.Key == Texts.Current.Language.ToString());
        set
        {
            if (value is not null)
            {
                Texts.Current.Language = Enum.Parse<Language>(value.Key);
            }
        }
    }

    /// <summary>The theme.</summary>
    public LookChoice? Theme
    {
        get => Themes[_shell.IsDark ? 1 : 0];
        set
        {
            if (value is not null)
            {
                _shell.IsDark = value.Key == "dark";
            }
        }
    }

    /// <summary>The size.</summary>
    public LookChoice? Size
    {
        get => Sizes[(int)_shell.TouchSize];
        set
        {
            if (value is not null)
            {
                _shell.Preferences.TouchSize = Enum.Parse<TouchSize>(value.Key);
            }
        }
    }

    /// <summary>Where it is kept, in words.</summary>
    public string Kept => _shell.Preferences.File is { } file ? Texts.Current.With("Look.Kept", _shell.UserName, file) : Texts.Current["Look.NotKept"];

    /// <inheritdoc/>
    protected override void Dispose(bool isDisposing)
    {
        _shell.Preferences.PropertyChanged -= OnPreferences;
        base.Dispose(isDisposing);
    }

    /// <inheritdoc/>
    protected override void Follow()
    {
        // Nothing of it is the cell's.
    }

    /// <inheritdoc/>
    protected override void Translate()
    {
        foreach (var choice in Themes.Concat(Sizes))
        {
            choice.Rename();
        }

        Say(nameof(Language));
        Say(nameof(Kept));
    }

    private void OnPreferences(object? sender, System.ComponentModel.PropertyChangedEventArgs e)
    {
        Say(nameof(Theme));
        Say(nameof(Size));
    }
}
