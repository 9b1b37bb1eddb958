using System.Collections.Concurrent;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Finds called programs in the folder of the calling program, and behind it in further folders: <c>O1002</c> in
/// <c>O1002.nc</c> or <c>1002</c>, <c>POCKET</c> in <c>pocket.spf</c>. Only plain files of these folders are opened; links are not
/// followed. A program is read once, so that all who ask for it get the same.</summary>
/// <param name="program">The calling program.</param>
/// <param name="libraries">Further folders, in the order in which they are searched.</param>
public sealed class ProgramFolder(string program, params IReadOnlyList<string> libraries)
{
    private const int MostFiles = 100_000;

    private static readonly string[] Extensions = ["", ".nc", ".ngc", ".spf", ".mpf", ".cnc", ".tap", ".min", ".sub", ".prg", ".h", ".txt"];

    private readonly ConcurrentDictionary<string, NcProgram?> _found = new(StringComparer.Ordinal);
    private readonly Lazy<ILookup<string, string>[]> _folders = new(() => Folders(program, libraries));
    private readonly ConcurrentQueue<string> _opened = new();

    /// <summary>The files that were opened.</summary>
    public IReadOnlyList<string> Opened => [.. _opened.Order(StringComparer.Ordinal)];

    /// <summary>The program of a name; null if no folder has it.</summary>
    /// <exception cref="InputException">It exists but cannot be opened, or a folder cannot be.</exception>
    public NcProgram? Find(string name) => _found.GetOrAdd(name, Read);

    private NcProgram? Read(string name)
    {
        foreach (var files in _folders.Value)
        {
            if (FileOf(files, name) is { } file)
            {
                _opened.Enqueue(file);
                return NcProgram.Read(InputFile.Program(file));
            }
        }

        return null;
    }

    private static string? FileOf(ILookup<string, string> files, string name)
    {
        var number = name.Length > 1 && name[0] == 'O' ? name[1..].TrimStart('0') : "";
        return files[name.ToUpperInvariant()].Concat(number.Length == 0 ? [] : Numbered(files, number))
            .Order(StringComparer.Ordinal)
            .FirstOrDefault();
    }

    private static IEnumerable<string> Numbered(ILookup<string, string> files, string number) =>
        new[] { number, number.PadLeft(4, '0') }.Distinct(StringComparer.Ordinal).SelectMany(n => files[n].Concat(files["O" + n]));

    private static ILookup<string, string>[] Folders(string program, IReadOnlyList<string> libraries)
    {
        var own = Path.GetExtension(program);
        return [.. libraries.Prepend(Path.GetDirectoryName(Path.GetFullPath(program))!).Select(
            folder => InputFile.Open(folder, f => Files(f, own)))];
    }

    private static ILookup<string, string> Files(string folder, string own) => new DirectoryInfo(folder).EnumerateFiles()
        .Take(MostFiles)
        .Where(
            f => f.LinkTarget is null
                && (
                    Extensions.Contains(f.Extension, StringComparer.OrdinalIgnoreCase)
                        || f.Extension.Equals(own, StringComparison.OrdinalIgnoreCase)))
        .ToLookup(f => Path.GetFileNameWithoutExtension(f.Name).ToUpperInvariant(), f => f.FullName, StringComparer.Ordinal);
}
