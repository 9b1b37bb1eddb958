namespace ErrorMatching.Console;

/// <summary>Writes outputs that appear whole or not at all: beside their place, flushed to the disk, renamed.</summary>
internal static class OutputFile
{
    /// <summary>Writes a file, replacing one that is there. Missing folders are made.</summary>
    /// <param name="path">The file.</param>
    /// <param name="bytes">Its content.</param>
    /// <param name="inputs">The files that were read: none of them is ever replaced, not even through a link.</param>
    /// <param name="cancellation">Looked at last before the file appears.</param>
    /// <exception cref="OutputException">The file is an input, or cannot be written.</exception>
    /// <exception cref="OperationCanceledException">Nothing was written.</exception>
    public static void Write(string path, ReadOnlySpan<byte> bytes, IReadOnlyCollection<string> inputs, CancellationToken cancellation)
    {
        string? temporary = null;
        try
        {
            var target = Path.GetFullPath(path);
            RefuseInput(path, target, inputs);
            var folder = Directory.CreateDirectory(Path.GetDirectoryName(target) ?? target);
            temporary = Path.Combine(folder.FullName, $".{Path.GetFileName(target)}.{Path.GetRandomFileName()}.tmp");
            using (var stream = new FileStream(temporary, FileMode.CreateNew, FileAccess.Write, FileShare.None, bufferSize: 0))
            {
                stream.Write(bytes);
                stream.Flush(flushToDisk: true);
            }

            cancellation.ThrowIfCancellationRequested();
            File.Move(temporary, target, overwrite: true);
            temporary = null;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException or ArgumentException)
        {
            throw new OutputException(path, isInput: false, $"{path} cannot be written: {e.Message.TrimEnd('.')}. Choose a place with room where this user may write.", e);
        }
        finally
        {
            Remove(temporary);
        }
    }

    private static void RefuseInput(string path, string target, IReadOnlyCollection<string> inputs)
    {
        var comparison = OperatingSystem.IsWindows() ? StringComparison.OrdinalIgnoreCase : StringComparison.Ordinal;
        var final = Final(target);
        if (inputs.FirstOrDefault(i => string.Equals(Final(Path.GetFullPath(i)), final, comparison)) is { } input)
        {
            throw new OutputException(path, isInput: true, $"{path} is the input {input}, which is never changed. Name another output.");
        }
    }

    // Links are followed in every folder of the path, for the output's folder may be a link to the input's.
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

    private static void Remove(string? temporary)
    {
        try
        {
            if (temporary is not null)
            {
                File.Delete(temporary);
            }
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // The failure that led here is the one to report; a stray temporary file is harmless and its name says what it is.
        }
    }
}
