namespace ErrorMatching.Hmi;

/// <summary>The station's appearance for the current user: language, theme, height of touch targets, keyboard. It is stored by user
/// name.</summary>
internal sealed class LookViewModel : ScreenViewModel
{
    private readonly ShellViewModel _shell;

    public LookViewModel(ShellViewModel shell)
        : base((shell ?? throw new ArgumentNullException(nameof(shell))).Station)
    {
        _shell = shell;
        _shell.Preferences.PropertyChanged += OnPreferences;
    }

    /// <summary>The languages, each in its own words.</summary>
    public IReadOnlyList<LookChoice> Languages { get; } = [
        .. Enum.GetValues<Language>().Select(l => new LookChoice(l.ToString(), () => Texts.Of(l)["Language.Name"]))];

    public IReadOnlyList<LookChoice> Themes { get; } = [
        new("light", () => Texts.Current["Look.Light"]), new("dark", () => Texts.Current["Look.Dark"])];

    /// <summary>The heights of touch targets.</summary>
    public IReadOnlyList<LookChoice> Sizes { get; } = [
        .. Enum.GetValues<TouchSize>().Select(s => new LookChoice(s.ToString(), () => Texts.Current.Word(s)))];

    /// <summary>When the keyboard on the screen opens.</summary>
    public IReadOnlyList<LookChoice> Keyboards { get; } = [
        .. Enum.GetValues<KeyboardUse>().Select(k => new LookChoice(k.ToString(), () => Texts.Current.Word(k)))];

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

    public LookChoice? Keyboard
    {
        get => Keyboards[(int)_shell.Preferences.Keyboard];
        set
        {
            if (value is not null)
            {
                _shell.Preferences.Keyboard = Enum.Parse<KeyboardUse>(value.Key);
            }
        }
    }

    /// <summary>Where it is stored, in words.</summary>
    public string Stored =>
        _shell.Preferences.File is { } file ? Texts.Current.With("Look.Stored", _shell.UserName, file) : Texts.Current["Look.NotKept"];

    /// <inheritdoc/>
    protected override void Dispose(bool isDisposing)
    {
        _shell.Preferences.PropertyChanged -= OnPreferences;
        base.Dispose(isDisposing);
    }

    /// <inheritdoc/>
    protected override void Follow()
    {
        // Nothing here depends on the cell.
    }

    /// <inheritdoc/>
    protected override void Translate()
    {
        foreach (var choice in Themes.Concat(Sizes).Concat(Keyboards))
        {
            choice.Rename();
        }

        OnPropertyChanged(nameof(Language));
        OnPropertyChanged(nameof(Stored));
    }

    private void OnPreferences(object? sender, System.ComponentModel.PropertyChangedEventArgs e)
    {
        OnPropertyChanged(nameof(Theme));
        OnPropertyChanged(nameof(Size));
        OnPropertyChanged(nameof(Keyboard));
    }
}

/// <summary>An option for the appearance. The object stays the same in another language, so that it stays selected.</summary>
/// <param name="key">Its key.</param>
/// <param name="name">Returns its name in the display language.</param>
internal sealed class LookChoice(string key, Func<string> name) : Observable
{
    public string Key { get; } = key;

    public string Name => name();

    public string AutomationId => "look-" + Key;

    /// <summary>Updates the name after a change of language.</summary>
    internal void Rename() => OnPropertyChanged(nameof(Name));
}
