using System.Reflection;
using System.Runtime.InteropServices;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>About: what the station is, where it stores data, and its components.</summary>
internal sealed class AboutViewModel : ScreenViewModel
{
    private const int CommitDigits = 10;
    private readonly ShellViewModel _shell;

    public AboutViewModel(ShellViewModel shell)
        : base((shell ?? throw new ArgumentNullException(nameof(shell))).Station) => _shell = shell;

    /// <summary>Version and folders.</summary>
    public IReadOnlyList<AboutRow> Places =>
    [
        new(Texts.Current["About.Version"], "ErrorMatching " + Version),
        new(Texts.Current["About.System"], $"{RuntimeInformation.FrameworkDescription}, {RuntimeInformation.OSDescription}"),
        new(Texts.Current["About.Cell"], Path.GetFullPath(Station.Settings.File)),
        new(Texts.Current["About.Store"], Place(Station.Settings.Store)),
        new(Texts.Current["About.Keys"], Station.Settings.KeysFolder),
        new(Texts.Current["About.Logs"], Station.Settings.LogFolder),
        new(Texts.Current["About.Preferences"], _shell.Preferences.File ?? Shown.Nothing),
    ];

    /// <summary>Its components with their licenses.</summary>
    public IReadOnlyList<AboutRow> Parts { get; } =
    [
        new("ErrorMatching", "MIT"),
        .. Licenses.Packages.Select(p => new AboutRow(p.Package, p.License)),
        .. OperatingSystem.IsLinux() ? Licenses.OfLinux.Select(p => new AboutRow(p.Package, p.License)) : [],
    ];

    /// <inheritdoc/>
    protected override void Follow()
    {
        // Nothing here depends on the cell.
    }

    /// <inheritdoc/>
    protected override void Translate() => OnPropertyChanged();

    // Release number, and the first digits of the commit.
    private static string Version =>
        typeof(AboutViewModel).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()?.InformationalVersion.Split('+') switch
        {
            [var release, { Length: > CommitDigits } commit] => $"{release} ({commit[..CommitDigits]})",
            [var release, ..] => release,
            _ => Shown.Nothing,
        };

    private static string Place(StoreSettings settings) => settings switch
    {
        SqliteSettings { File: var file } => file,
        PostgresSettings p => FormattableString.Invariant($"PostgreSQL {p.Database}, {p.Host}:{p.Port}"),
        _ => Shown.Nothing,
    };
}

/// <summary>Information about the station or one of its components.</summary>
/// <param name="What">Its name.</param>
/// <param name="Value">Its version, place or license.</param>
internal sealed record AboutRow(string What, string Value);
