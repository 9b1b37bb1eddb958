using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Finds called programs in the folder of the calling program: <c>O1002</c> in <c>O1002.nc</c> or <c>1002</c>,
/// <c>POCKET</c> in <c>pocket.spf</c>. Only plain files of that one folder are opened; links are not followed.</summary>
public sealed class ProgramFolder(string program)
{
    private const int MostFiles = 100_000;

    private static readonly string[] Extensions = ["", ".nc", ".ngc", ".spf", ".mpf", ".cnc", ".tap", ".min", ".prg", ".h", ".txt"];

    private readonly string _folder = Path.GetDirectoryName(Path.GetFullPath(program))!;
    private readonly string _own = Path.GetExtension(program);
    private ILookup<string, string>? _files;

    /// <summary>The program of a name; null if the folder has none.</summary>
    /// <exception cref="InputException">It exists but cannot be opened.</exception>
    public NcProgram? Find(string name)
    {
        _files ??= Files();
        var number = name.Length > 1 && name[0] == 'O' ? name[1..].TrimStart('0') : "";
        var file = _files[name.ToUpperInvariant()].Concat(number.Length == 0 ? [] : Numbered(number))
            .Order(StringComparer.Ordinal)
            .FirstOrDefault();
        return file is null ? null : NcProgram.Read(InputFile.Program(file));
    }

    private IEnumerable<string> Numbered(string number) =>
        new[] { number, number.PadLeft(4, '0') }.Distinct(StringComparer.Ordinal).SelectMany(n => _files![n].Concat(_files["O" + n]));

    private ILookup<string, string> Files() => new DirectoryInfo(_folder).EnumerateFiles()
        .Take(MostFiles)
        .Where(
            f => f.LinkTarget is null
                && (
                    Extensions.Contains(f.Extension, StringComparer.OrdinalIgnoreCase)
                        || f.Extension.Equals(_own, StringComparison.OrdinalIgnoreCase)))
        .ToLookup(f => Path.GetFileNameWithoutExtension(f.Name).ToUpperInvariant(), f => f.FullName, StringComparer.Ordinal);
}
