using System.Globalization;
using System.Text;
using ErrorMatching.Jobs;

namespace ErrorMatching.Cell;

/// <summary>Prepared jobs: each has its own folder that no configuration names, so no measurement uses it before it is put in
/// use.</summary>
/// <param name="settings">The cell's configuration.</param>
internal sealed class PreparedJobs(CellSettings settings)
{
    private const string FolderEnding = ".saved";
    private const string FileName = "job.json";

    /// <inheritdoc cref="JobEdits.IsInUse"/>
    public bool IsInUse(CellJobSettings job) => settings.Jobs.Any(j => CellPaths.AreSame(j.File, job.File));

    /// <inheritdoc cref="JobEdits.PlaceOf"/>
    public CellJobSettings PlaceOf(CellJobSettings job) => IsInUse(job)
        ? job
        : settings.Jobs.FirstOrDefault(j => CellPaths.AreSame(At(j, NameOf(job)).File, job.File))
            ?? throw new ArgumentException($"{job.File} is no job of this cell.", nameof(job));

    /// <inheritdoc cref="JobEdits.PreparedFor"/>
    public IReadOnlyList<CellJobSettings> For(CellJobSettings job)
    {
        var folder = FolderOf(job);
        return InputFile.Open(folder, IReadOnlyList<CellJobSettings> (_) =>
        [
            .. Entries(folder).Where(e => SavedJobName.Defect(Path.GetFileName(e)) is null).Select(e => At(job, Path.GetFileName(e)))
                .Where(j => IsPlain(j) && !IsInUse(j)).OrderBy(j => j.Name, StringComparer.Ordinal),
        ]);
    }

    /// <summary>The name of a prepared job among those of its place.</summary>
    public static string NameOf(CellJobSettings prepared) => Path.GetFileName(Path.GetDirectoryName(prepared.File)) ?? "";

    /// <summary>The prepared job of a name for the place of a job, which need not exist.</summary>
    public static CellJobSettings At(CellJobSettings place, string name) =>
        place with { Name = $"{place.Name}/{name}", File = Path.Combine(FolderOf(place), name, FileName) };

    /// <summary>Rejects a name that is taken.</summary>
    /// <exception cref="JobEditException">It is, or the folder of prepared jobs cannot be used.</exception>
    public static void DemandFree(CellJobSettings place, string name)
    {
        var folder = FolderOf(place);
        if (File.Exists(folder) || new DirectoryInfo(folder).LinkTarget is not null)
        {
            throw new JobEditException(
                JobEditException.NoFolder, $"{folder}, where saved jobs are kept, is a file or a link. Remove it, and save again.");
        }

        // Some file systems ignore case.
        var entries = InputFile.Open(folder, _ => Entries(folder));
        if (entries.Any(e => string.Equals(Path.GetFileName(e), name, StringComparison.OrdinalIgnoreCase)))
        {
            throw new JobEditException(
                JobEditException.NameTaken, $"There is something called {name} in {folder} already. Give the new job another name.");
        }
    }

    /// <summary>Rejects files outside of a prepared job's folder, and a folder that is a link: it may belong to a job in use.</summary>
    /// <exception cref="JobEditException">There is one.</exception>
    public static void DemandInside(CellJobSettings prepared, IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> files)
    {
        var folder = Path.GetDirectoryName(prepared.File)!;
        if (files.Select(f => f.Path).FirstOrDefault(f => !CellPaths.AreSame(Path.GetDirectoryName(f)!, folder)) is { } outside)
        {
            throw new JobEditException(
                JobEditException.Shared, $"{outside} is not in {folder}, the folder of the saved job. Give it a file there.");
        }

        if (!IsInFolders(prepared))
        {
            throw new JobEditException(JobEditException.NoFolder, $"{folder} is a link. Remove it, and save the job under another name.");
        }
    }

    private static bool IsInFolders(CellJobSettings prepared)
    {
        var folder = new DirectoryInfo(Path.GetDirectoryName(prepared.File)!);
        return folder.LinkTarget is null && folder.Parent!.LinkTarget is null;
    }

    private static string FolderOf(CellJobSettings place) => place.File + FolderEnding;

    // A link may lead to a job in use, so its target is ignored.
    private static string[] Entries(string folder) =>
        new DirectoryInfo(folder) is { Exists: true, LinkTarget: null } ? Directory.GetFileSystemEntries(folder) : [];

    private static bool IsPlain(CellJobSettings prepared) =>
        new DirectoryInfo(Path.GetDirectoryName(prepared.File)!) is { Exists: true, LinkTarget: null }
        && new FileInfo(prepared.File) is { Exists: true } file && PlainFile.Defect(file) is null;
}

/// <summary>Valid names of saved jobs: valid folder names on every system that do not lead elsewhere.</summary>
internal static class SavedJobName
{
    private const int Longest = 64;
    private const string Forbidden = "/\\:*?\"<>|";

    /// <summary>Why a folder cannot have this name, or null.</summary>
    public static string? Defect(string name) =>
        name.Length is 0 or > Longest ? $"it has 1 to {Longest} characters"
        : name.EnumerateRunes().Any(r => Forbidden.Contains(r.ToString(), StringComparison.Ordinal) || IsUnseen(r))
            ? $"it has none of {string.Join(' ', Forbidden.ToCharArray())}, and nothing that is not seen"
        : name[0] is '.' or ' ' || name[^1] is '.' or ' ' ? "it neither begins nor ends with a dot or a space"
        : ProgramNames.IsReserved(name) ? "Windows keeps it for a device"
        : null;

    // A lone surrogate is read as the replacement character.
    private static bool IsUnseen(Rune rune) => rune == Rune.ReplacementChar
        || Rune.GetUnicodeCategory(rune) is UnicodeCategory.Control or UnicodeCategory.Format
        or UnicodeCategory.LineSeparator or UnicodeCategory.ParagraphSeparator or UnicodeCategory.PrivateUse;
}
