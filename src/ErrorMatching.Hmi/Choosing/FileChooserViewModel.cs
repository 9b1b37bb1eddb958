using System.Security;

namespace ErrorMatching.Hmi;

/// <summary>File chooser inside the station's own window: the user taps a file or folder, or types its path.</summary>
[System.Diagnostics.CodeAnalysis.SuppressMessage("Design", "CA1001", Justification = "Each look disposes what it made when it ends.")]
public sealed class FileChooserViewModel : Observable
{
    private readonly FileChoice _choice;
    private readonly TimeProvider _clock;
    private CancellationTokenSource? _looking;
    private FolderListing? _listing;
    private IReadOnlyList<FolderPlace> _places = [];
    private string _path = "";
    private string? _message;
    private string? _replaced;
    private bool _isAll;

    /// <summary>Opens it at a folder.</summary>
    /// <param name="choice">What to choose.</param>
    /// <param name="folder">The folder, or a file in it; if it does not exist, the nearest existing parent.</param>
    /// <param name="cellFolder">The folder of the cell's configuration.</param>
    /// <param name="samplesFolder">The folder of the samples; null if there is none.</param>
    /// <param name="recent">Recently used folders, latest first.</param>
    /// <param name="clock">Gives the time zone.</param>
    public FileChooserViewModel(
        FileChoice choice, string folder, string cellFolder, string? samplesFolder, IReadOnlyList<string> recent, TimeProvider clock)
    {
        (_choice, _clock) = (choice ?? throw new ArgumentNullException(nameof(choice)), clock);
        Up = new(() => Enter(Path.GetDirectoryName(Folder)!), () => Path.GetDirectoryName(Folder) is not null);
        Leave = new(() => End(null));
        Confirm = new(_ => ConfirmAsync(), CanConfirm);
        ShowAll = new(
            () =>
            {
                _isAll = !_isAll;
                OnPropertyChanged(nameof(Filter));
                Enter(Folder);
            },
            () => _listing is not null);
        Loading = BeginAsync(folder, cellFolder, samplesFolder, recent).Watched();
    }

    /// <summary>Raised once: with the full path of the choice, or null if canceled.</summary>
    public event Action<string?>? Done;

    /// <summary>The purpose.</summary>
    public string Title => Texts.Current[_choice.TitleKey];

    /// <summary>Folders to start at.</summary>
    public IReadOnlyList<FolderPlace> Places
    {
        get => _places;
        private set => Set(ref _places, value);
    }

    /// <summary>The contents of the folder.</summary>
    public RowList<FolderEntry> Rows { get; } = [];

    /// <summary>The current folder; empty before the first one is shown.</summary>
    public string Folder => _listing?.Folder ?? "";

    /// <summary>The path in the field, which is the choice: a tapped file or typed text.</summary>
    public string Typed
    {
        get => _path;
        set
        {
            if (Set(ref _path, value ?? ""))
            {
                Ask(null);
                Confirm.Refresh();
                OnPropertyChanged(nameof(Chosen));
            }
        }
    }

    /// <summary>The row of the file in the field; null if it is not listed.</summary>
    public FolderEntry? Chosen => Rows.FirstOrDefault(r => !r.IsFolder && r.Path == Typed);

    /// <summary>What is listed and what is not, in words.</summary>
    public string Summary => _listing is not { } l ? "" : Sentence.Joined(Sentences(l));

    /// <summary>The error message; null if there is none.</summary>
    public string? Message
    {
        get => _message;
        private set => Set(ref _message, value);
    }

    /// <summary>True if files are filtered by extension.</summary>
    public bool IsFiltered => _choice.Kind != FileChoiceKind.Folder && _choice.Extensions.Count > 0;

    /// <summary>What a tap on the filter does, in words.</summary>
    public string Filter =>
        _isAll ? Texts.Current.With("Chooser.Only", string.Join(", ", _choice.Extensions)) : Texts.Current["Chooser.All"];

    /// <summary>What the confirm button does, in words.</summary>
    public string ConfirmLabel => Texts.Current[_replaced is not null ? "Chooser.Replace" : "Chooser." + _choice.Kind];

    /// <summary>Opens the parent folder.</summary>
    public Command Up { get; }

    /// <summary>Cancels.</summary>
    public Command Leave { get; }

    /// <summary>Switches between all files and those with the extensions.</summary>
    public Command ShowAll { get; }

    /// <summary>Accepts the field: opens a folder or chooses a file.</summary>
    public LongCommand Confirm { get; }

    /// <summary>Completes when the requested folder is shown.</summary>
    internal Task Loading { get; private set; }

    /// <summary>Handles a tap on a row: opens a folder, or puts a file into the field. A file that is already in the field is
    /// chosen; to write one needs the button.</summary>
    public void Take(FolderEntry entry)
    {
        ArgumentNullException.ThrowIfNull(entry);
        if (entry.IsFolder)
        {
            Enter(entry.Path);
        }
        else if (_choice.Kind == FileChoiceKind.Open && Typed == entry.Path)
        {
            Confirm.Execute(null);
        }
        else
        {
            Typed = entry.Path;
        }
    }

    /// <summary>Shows a folder. If it cannot be shown, a message tells why and the previous one stays.</summary>
    public void Enter(string folder) => Loading = EnterAsync(folder, Typed).Watched();

    /// <summary>Updates all texts after a change of language.</summary>
    internal void Translate()
    {
        Message = null;
        Places = [.. Places];
        Rows.Show([.. Rows.Select(r => r.Now(_clock))]);
        OnPropertyChanged();
    }

    private async Task BeginAsync(string folder, string cellFolder, string? samplesFolder, IReadOnlyList<string> recent)
    {
        var (there, name) = await Task.Run(() => Begin(folder));
        Places = await Task.Run(() => Hmi.Places.Of(cellFolder, samplesFolder, recent));
        await EnterAsync(there, "");
        if (name is not null && Folder == there && Typed == there)
        {
            Typed = Path.Combine(there, name);
        }
    }

    // A proposed path need not exist yet: a folder to write to, or the name of a new file.
    private static (string Folder, string? Name) Begin(string path)
    {
        var full = Path.GetFullPath(path);
        var folder = full;
        while (!Directory.Exists(folder) && Path.GetDirectoryName(folder) is { } above)
        {
            folder = above;
        }

        return (folder, full == folder ? null : Path.GetRelativePath(folder, full));
    }

    // Before: what stood in the field when it was asked for. What was typed or tapped since then is the choice.
    private async Task EnterAsync(string folder, string before)
    {
        _looking?.Cancel();
        using var looking = _looking = new();
        Message = null;
        try
        {
            IReadOnlyList<string>? endings = _choice.Kind == FileChoiceKind.Folder ? null : _isAll ? [] : _choice.Extensions;
            var listing = await Task.Run(() => FolderListing.Read(folder, endings, _clock, looking.Token), looking.Token);
            if (_looking == looking)
            {
                _listing = listing;
                Rows.Show(listing.Entries);
                Typed = IsNew(before) || (_choice.Kind == FileChoiceKind.Open && Chosen is not null) ? Typed
                    : _choice.Kind == FileChoiceKind.Save
                        && Typed.Length > 0
                        && Path.GetFileName(Typed) is { Length: > 0 } name
                        && !Directory.Exists(Typed)
                    ? Path.Combine(listing.Folder, name)
                    : listing.Folder;
                Up.Refresh();
                ShowAll.Refresh();
                Confirm.Refresh();
                OnPropertyChanged();
                OnPropertyChanged(nameof(Chosen));
            }
        }
        catch (OperationCanceledException) when (looking.IsCancellationRequested)
        {
            // Another folder was opened meanwhile.
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or SecurityException)
        {
            // Of a folder that was left meanwhile nothing is said.
            Message = _looking == looking ? Why(e, folder) : Message;
        }
        finally
        {
            _looking = _looking == looking ? null : _looking;
        }
    }

    // A new name of a file to write goes into the folder that is opened, unless its folder was typed, too.
    private bool IsNew(string before) => Typed != before
        && (_choice.Kind != FileChoiceKind.Save || Path.GetDirectoryName(Typed) != Path.GetDirectoryName(before));

    // The current folder is not a file: nothing is chosen yet.
    private bool CanConfirm() =>
        Typed.Trim() is { Length: > 0 } typed
            && (
                _choice.Kind == FileChoiceKind.Folder
                    || typed.TrimEnd(Path.DirectorySeparatorChar) != Folder.TrimEnd(Path.DirectorySeparatorChar));

    private async Task ConfirmAsync()
    {
        Message = null;
        var typed = Typed;
        if (typed.Contains('\0', StringComparison.Ordinal) || (Folder.Length == 0 && !Path.IsPathFullyQualified(typed.Trim())))
        {
            Message = Texts.Current.With("Chooser.Missing", FolderEntry.Visible(typed));
            return;
        }

        var path = Folder.Length == 0 ? Path.GetFullPath(typed.Trim()) : Path.GetFullPath(typed.Trim(), Folder);
        var (isFolder, isFile, isPlaced) = await Task.Run(
            () => (Directory.Exists(path), File.Exists(path), Directory.Exists(Path.GetDirectoryName(path))));
        switch (_choice.Kind)
        {
            case FileChoiceKind.Folder when !isFile:
                End(path);
                break;
            case FileChoiceKind.Folder:
                Message = Texts.Current.With("Chooser.NoFolder", FolderEntry.Visible(path));
                break;
            case var _ when isFolder:
                Loading = EnterAsync(path, typed).Watched();
                await Loading;
                break;
            case FileChoiceKind.Open when isFile:
                End(path);
                break;
            case FileChoiceKind.Save when isPlaced:
                Save(path, isFile);
                break;
            default:
                Message = Texts.Current.With("Chooser.Missing", FolderEntry.Visible(path));
                break;
        }
    }

    private void Save(string path, bool isThere)
    {
        if (!Path.HasExtension(path) && _choice.Extensions is [var ending, ..])
        {
            (path, isThere) = (path + ending, File.Exists(path + ending));
        }

        if (!isThere || _replaced == path)
        {
            End(path);
            return;
        }

        Ask(path);
        Message = Texts.Current.With("Chooser.Exists", FolderEntry.Visible(Path.GetFileName(path)));
    }

    // Replacing a file needs a second tap, on a button that says so.
    private void Ask(string? replaced)
    {
        _replaced = replaced;
        OnPropertyChanged(nameof(ConfirmLabel));
    }

    private void End(string? path)
    {
        _looking?.Cancel();
        Done?.Invoke(path);
    }

    internal static string Why(Exception failure, string folder)
    {
        var shown = FolderEntry.Visible(folder);
        return failure switch
        {
            UnauthorizedAccessException or SecurityException => Texts.Current.With("Chooser.Denied", shown),
            DirectoryNotFoundException or FileNotFoundException => Texts.Current.With("Chooser.Missing", shown),
            _ => Texts.Current.With("Chooser.Unreadable", shown, failure.Message),
        };
    }

    private IEnumerable<string> Sentences(FolderListing listing)
    {
        var texts = Texts.Current;
        var folders = listing.Entries.Count(e => e.IsFolder);
        yield return _choice.Kind == FileChoiceKind.Folder
            ? texts.With("Chooser.Folders", Shown.Count(folders))
            : texts.With("Chooser.Both", Shown.Count(folders), Shown.Count(listing.Entries.Count - folders));
        if (listing.Others > 0)
        {
            yield return texts.With(
                _choice.Kind == FileChoiceKind.Folder ? "Chooser.Files" : "Chooser.Others", Shown.Count(listing.Others));
        }

        if (listing.Hidden > 0)
        {
            yield return texts.With("Chooser.Hidden", Shown.Count(listing.Hidden));
        }

        if (!listing.IsWhole)
        {
            yield return texts.With("Chooser.Most", Shown.Count(FolderListing.Most));
        }
    }
}
