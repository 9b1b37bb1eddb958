using Microsoft.Win32.SafeHandles;

namespace ErrorMatching.Json;

/// <summary>Files that another process may open, replace or delete at any moment.</summary>
/// <remarks>Windows refuses to replace a file while somebody has it open, and to open one while it is replaced. Both pass in a moment, so
/// the operation is tried again there for about a second. Other systems replace a file that is being read: there every failure
/// is final.</remarks>
public static class SharedFile
{
    private const int Repetitions = 10;

    // ERROR_SHARING_VIOLATION, ERROR_LOCK_VIOLATION and ERROR_USER_MAPPED_FILE.
    private const int InUse = unchecked((int)0x80070020);
    private const int Locked = unchecked((int)0x80070021);
    private const int Mapped = unchecked((int)0x800704C8);

    /// <summary>Opens a file for reading. It may be replaced or deleted meanwhile; the stream then still has what was opened. A file that
    /// somebody is writing is not opened, because it could be read in part.</summary>
    /// <exception cref="IOException">The file cannot be opened.</exception>
    /// <exception cref="UnauthorizedAccessException">Access to the file is denied.</exception>
    public static FileStream OpenRead(string path) => OpenRead(path, FileShare.Read | FileShare.Delete);

    /// <summary>Opens a file for reading.</summary>
    /// <param name="path">The file.</param>
    /// <param name="share">What others may do with it meanwhile; writing too, where its writer overwrites it in place.</param>
    /// <exception cref="IOException">The file cannot be opened.</exception>
    /// <exception cref="UnauthorizedAccessException">Access to the file is denied.</exception>
    public static FileStream OpenRead(string path, FileShare share) => Patiently(
        () => new FileStream(path, FileMode.Open, FileAccess.Read, share));

    /// <summary>Opens a file for reading, without a stream.</summary>
    /// <param name="path">The file.</param>
    /// <param name="share">What others may do with it meanwhile.</param>
    /// <exception cref="IOException">The file cannot be opened.</exception>
    /// <exception cref="UnauthorizedAccessException">Access to the file is denied.</exception>
    public static SafeFileHandle OpenHandle(string path, FileShare share) => Patiently(
        () => File.OpenHandle(path, FileMode.Open, FileAccess.Read, share));

    /// <summary>The bytes of a file, opened as by <see cref="OpenRead(string)"/>, or of a pipe to its end.</summary>
    /// <exception cref="IOException">The file cannot be read, or has 2 GB or more.</exception>
    /// <exception cref="UnauthorizedAccessException">Access to the file is denied.</exception>
    public static byte[] ReadAllBytes(string path) => ReadAllBytes(path, Array.MaxLength);

    /// <summary>The same with a limit.</summary>
    /// <param name="path">The file.</param>
    /// <param name="most">The most bytes.</param>
    /// <exception cref="IOException">The file cannot be read, or has more bytes.</exception>
    /// <exception cref="UnauthorizedAccessException">Access to the file is denied.</exception>
    public static byte[] ReadAllBytes(string path, long most)
    {
        using var file = OpenRead(path);
        if (!file.CanSeek)
        {
            return ReadToEnd(file, most);
        }

        if (file.Length > most)
        {
            throw TooLarge(most);
        }

        // A file of the system may have no length and yet content.
        using var bytes = new MemoryStream((int)file.Length);
        file.CopyTo(bytes);
        return bytes.Length == bytes.Capacity ? bytes.GetBuffer() : bytes.ToArray();
    }

    /// <summary>True if a path names something that a process has open, as shells write process substitution: it has no folder and no
    /// name of its own.</summary>
    public static bool IsStream(string path)
    {
        ArgumentNullException.ThrowIfNull(path);
        return path.StartsWith("/dev/", StringComparison.Ordinal) || path.StartsWith("/proc/", StringComparison.Ordinal);
    }

    // A pipe, as a shell makes for process substitution.
    private static byte[] ReadToEnd(FileStream pipe, long most)
    {
        using var bytes = new MemoryStream();
        var buffer = new byte[1 << 16];
        for (int read; (read = pipe.Read(buffer)) > 0;)
        {
            if (bytes.Length + read > most)
            {
                throw TooLarge(most);
            }

            bytes.Write(buffer, 0, read);
        }

        return bytes.ToArray();
    }

    private static IOException TooLarge(long most) =>
        new(string.Create(System.Globalization.CultureInfo.InvariantCulture, $"it has more than the {most} bytes that are read at most"));

    /// <summary>Gives a complete file the name of another one, which is replaced if it exists.</summary>
    /// <param name="from">The complete file, in the same folder.</param>
    /// <param name="to">The name that it gets.</param>
    /// <exception cref="IOException">It cannot be renamed.</exception>
    /// <exception cref="UnauthorizedAccessException">Access is denied, or on Windows another process keeps the file open.</exception>
    public static void Replace(string from, string to) => Patiently(() => File.Move(from, to, overwrite: true));

    /// <summary>Gives a file another name, which must be free.</summary>
    /// <exception cref="IOException">The name is taken, or the file cannot be renamed.</exception>
    /// <exception cref="UnauthorizedAccessException">Access is denied.</exception>
    public static void Rename(string from, string to) => Patiently(() => File.Move(from, to));

    /// <summary>Gives a folder another name, which must be free.</summary>
    /// <exception cref="IOException">The name is taken, or the folder cannot be renamed.</exception>
    /// <exception cref="UnauthorizedAccessException">Access is denied.</exception>
    public static void RenameFolder(string from, string to) => Patiently(() => Directory.Move(from, to));

    /// <summary>Deletes a file; succeeds if there is none.</summary>
    /// <exception cref="IOException">It cannot be deleted.</exception>
    /// <exception cref="UnauthorizedAccessException">Access is denied.</exception>
    public static void Delete(string path) => Patiently(() => File.Delete(path));

    /// <summary>Does something, and again after a pause as long as it fails in a way that passes. The pauses double from 1 ms.</summary>
    /// <param name="work">What to do; after a failure nothing of it must be left.</param>
    /// <param name="passes">True for a failure that passes.</param>
    /// <param name="pause">Waits.</param>
    internal static T Patiently<T>(Func<T> work, Func<Exception, bool> passes, Action<TimeSpan> pause)
    {
        for (var again = 0; ; again++)
        {
            try
            {
                return work();
            }
            catch (Exception e) when (again < Repetitions && passes(e))
            {
                pause(TimeSpan.FromMilliseconds(1 << again));
            }
        }
    }

    /// <summary>True if Windows reports by this failure that another process has the file open at the moment, or that it is just being
    /// replaced. Windows also denies access while a file is being replaced.</summary>
    internal static bool PassesOnWindows(Exception failure) => failure is UnauthorizedAccessException or IOException
    {
        HResult: InUse or Locked or Mapped
    };

    private static T Patiently<T>(Func<T> work) => OperatingSystem.IsWindows() ? Patiently(work, PassesOnWindows, Thread.Sleep) : work();

    private static void Patiently(Action work) => Patiently(() =>
    {
        work();
        return true;
    });
}
