using ErrorMatching.Json;

namespace ErrorMatching.Jobs;

/// <summary>Writes outputs that appear complete or not at all: written under a temporary name, flushed to disk, renamed.</summary>
public static class OutputFile
{
    private static readonly StringComparison OfPaths = OperatingSystem.IsWindows()
        ? StringComparison.OrdinalIgnoreCase
        : StringComparison.Ordinal;

    /// <summary>Writes a file, replacing an existing one. Missing folders are created.</summary>
    /// <param name="path">The file.</param>
    /// <param name="bytes">Its content.</param>
    /// <param name="inputs">The files that were read: none of them is ever replaced, not even through a link.</param>
    /// <param name="cancellation">Checked last before the file appears.</param>
    /// <exception cref="OutputException">The file is an input, or cannot be written.</exception>
    /// <exception cref="OperationCanceledException">Nothing was written.</exception>
    public static void Write(string path, ReadOnlyMemory<byte> bytes, IReadOnlyCollection<string> inputs, CancellationToken cancellation) =>
        WriteAll([(path, bytes)], inputs, cancellation);

    /// <summary>Writes a file that is too large for memory, replacing an existing one. Missing folders are created.</summary>
    /// <param name="path">The file.</param>
    /// <param name="write">Writes the content to a stream. Its exceptions, other than disk failures, pass through, and nothing is
    /// written.</param>
    /// <param name="inputs">The files that were read: none of them is ever replaced, not even through a link.</param>
    /// <param name="cancellation">Checked last before the file appears.</param>
    /// <exception cref="OutputException">The file is an input, or cannot be written.</exception>
    /// <exception cref="OperationCanceledException">Nothing was written.</exception>
    public static void Write(string path, Action<Stream> write, IReadOnlyCollection<string> inputs, CancellationToken cancellation) =>
        WriteAll([(path, write)], inputs, () => true, cancellation);

    /// <summary>Writes files that belong together: either all appear, in this order, or none does and existing files stay.</summary>
    /// <param name="files">The files and their contents.</param>
    /// <param name="inputs">The files that were read: none of them is ever replaced, not even through a link.</param>
    /// <param name="cancellation">Checked last before the first file appears.</param>
    /// <exception cref="OutputException">A file is an input or another output, or cannot be written.</exception>
    /// <exception cref="OperationCanceledException">Nothing was written.</exception>
    public static void WriteAll(
        IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> files,
        IReadOnlyCollection<string> inputs,
        CancellationToken cancellation = default) =>
        WriteAll(files, inputs, () => true, cancellation);

    /// <summary>Writes files that belong together, then asks whether they may appear: either all do, in this order, or none does.</summary>
    /// <param name="files">The files and their contents.</param>
    /// <param name="inputs">The files that were read: none of them is ever replaced, not even through a link.</param>
    /// <param name="mayAppear">Called last before the first file appears. If it returns false, nothing is left behind.</param>
    /// <param name="cancellation">Checked before the first file appears.</param>
    /// <returns>True if the files were written.</returns>
    /// <exception cref="OutputException">A file is an input or another output, or cannot be written.</exception>
    /// <exception cref="OperationCanceledException">Nothing was written.</exception>
    public static bool WriteAll(
        IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> files,
        IReadOnlyCollection<string> inputs,
        Func<bool> mayAppear,
        CancellationToken cancellation) =>
        WriteAll([.. files.Select(f => (f.Path, (Action<Stream>)(s => s.Write(f.Bytes.Span))))], inputs, mayAppear, cancellation);

    private static bool WriteAll(
        IReadOnlyList<(string Path, Action<Stream> Write)> files,
        IReadOnlyCollection<string> inputs,
        Func<bool> mayAppear,
        CancellationToken cancellation)
    {
        var targets = new List<string>();
        foreach (var (path, _) in files)
        {
            var target = Try(path, () => Final(Path.GetFullPath(path)));
            if (inputs.FirstOrDefault(i => string.Equals(Final(Path.GetFullPath(i)), target, OfPaths)) is { } input)
            {
                throw new OutputException(
                    OutputException.IsInput, path, $"{path} is the input {input}, which is never changed. Name another output.");
            }

            if (targets.Any(t => string.Equals(t, target, OfPaths)))
            {
                throw new OutputException(
                    OutputException.Twice, path, $"{path} would be written twice with different content. Rename the program.");
            }

            targets.Add(target);
        }

        using var batch = new OutputBatch();
        foreach (var (path, write) in files)
        {
            Try(path, () => batch.Stage(path, write));
        }

        if (!mayAppear())
        {
            return false;
        }

        cancellation.ThrowIfCancellationRequested();
        foreach (var (path, _) in files)
        {
            Try(path, batch.RevealNext);
        }

        batch.Keep();
        return true;
    }

    /// <summary>Writes a new file.</summary>
    /// <param name="path">The file.</param>
    /// <param name="bytes">Its content.</param>
    /// <param name="cancellation">Checked last before the file appears.</param>
    /// <exception cref="OutputException">A file of this name exists, or it cannot be written.</exception>
    /// <exception cref="OperationCanceledException">Nothing was written.</exception>
    public static void Create(string path, ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        if (Path.Exists(path))
        {
            throw new OutputException(OutputException.Exists, path, $"{path} exists and is not overwritten. Name a new file.");
        }

        Write(path, bytes, [], cancellation);
    }

    /// <summary>Writes new files that belong together: either all appear, in this order, or none does.</summary>
    /// <param name="files">The files and their contents.</param>
    /// <param name="inputs">The files that were read.</param>
    /// <param name="cancellation">Checked last before the first file appears.</param>
    /// <exception cref="OutputException">A file of one of these names exists, or one cannot be written.</exception>
    /// <exception cref="OperationCanceledException">Nothing was written.</exception>
    public static void CreateAll(
        IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> files,
        IReadOnlyCollection<string> inputs,
        CancellationToken cancellation)
    {
        foreach (var (path, _) in files.Where(f => Path.Exists(f.Path)))
        {
            throw new OutputException(OutputException.Exists, path, $"{path} exists and is not overwritten. Name a new file.");
        }

        WriteAll(files, inputs, cancellation);
    }

    private static T Try<T>(string path, Func<T> work)
    {
        try
        {
            return work();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException or ArgumentException)
        {
            throw new OutputException(
                OutputException.Unwritable,
                path,
                $"{path} cannot be written: {FileFault.Of(path, e)}. Choose a place with room where this user may write.",
                e);
        }
    }

    private static void Try(string path, Action work) => Try(path, () =>
    {
        work();
        return true;
    });

    // Follows links in every folder of the path, because the output's folder may be a link to the input's.
    private static string Final(string path)
    {
        var folder = Path.GetDirectoryName(path);
        if (folder is null)
        {
            return path;
        }

        FileSystemInfo here = Directory.Exists(path) ? new DirectoryInfo(path) : new FileInfo(path);
        return here.LinkTarget is not null && here.ResolveLinkTarget(returnFinalTarget: true) is { } target
            ? Final(target.FullName)
            : Path.Combine(Final(folder), Path.GetFileName(path));
    }
}
