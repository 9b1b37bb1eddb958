using System.Runtime.InteropServices;

namespace ErrorMatching.Cell;

/// <summary>
/// Gives a written file its name unless one of that name is there: of several processes that try at once, exactly one succeeds. <see cref="File.Move(string, string, bool)"/> does not promise that on Unix:
/// between its look and its move another file may have got the name, and is lost.
/// </summary>
internal static class FirstFile
{
    private const int Exists = 17;

    /// <summary>Gives it the name, and takes it away where it was written.</summary>
    /// <param name="written">Where it was written, in the folder of its name.</param>
    /// <param name="file">Its name.</param>
    /// <returns>False if there is one of this name.</returns>
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

        // Windows moves and looks in one step. A disk without links has nothing better than one after the other.
        try
        {
            File.Move(written, file, overwrite: false);
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
