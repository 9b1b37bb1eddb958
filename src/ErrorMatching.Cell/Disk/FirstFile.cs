using System.Runtime.InteropServices;
using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Gives a written file its final name unless that name is taken: of several processes that try at once, exactly one succeeds.
/// <see cref="File.Move(string, string, bool)"/> does not guarantee this on Unix: between its check and its move another file may get the
/// name and would be lost.</summary>
internal static class FirstFile
{
    private const int Exists = 17;

    /// <summary>Moves the file to its final name.</summary>
    /// <param name="written">The written file, in the same folder as the final name.</param>
    /// <param name="file">The final name.</param>
    /// <returns>False if the name is taken.</returns>
    /// <exception cref="IOException">It cannot be moved.</exception>
    public static bool TryPut(string written, string file)
    {
        if (!OperatingSystem.IsWindows())
        {
            if (Link(written, file) == 0)
            {
                File.Delete(written);
                return true;
            }

            if (Marshal.GetLastPInvokeError() == Exists)
            {
                return false;
            }
        }

        // Windows checks and moves in one step. A disk without links offers nothing better than a check followed by a move.
        try
        {
            SharedFile.Rename(written, file);
            return true;
        }
        catch (IOException) when (File.Exists(file))
        {
            return false;
        }
    }

    [DllImport("libc", EntryPoint = "link", ExactSpelling = true, SetLastError = true)]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static extern int Link([MarshalAs(UnmanagedType.LPUTF8Str)] string from, [MarshalAs(UnmanagedType.LPUTF8Str)] string to);
}
