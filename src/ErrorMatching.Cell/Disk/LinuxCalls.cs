using System.ComponentModel;
using System.Runtime.InteropServices;
using System.Text;
using Microsoft.Win32.SafeHandles;

namespace ErrorMatching.Cell;

/// <summary>Calls of Linux that the runtime has no name for: what something is before it is opened, folders that are held fast, and
/// renaming that overwrites nothing unseen.</summary>
internal static class LinuxCalls
{
    /// <summary>The bits of a mode that say what kind of file something is (inode(7)).</summary>
    public const int KindMask = 0xF000;

    public const int PlainKind = 0x8000;
    public const int FolderKind = 0x4000;
    public const int LinkKind = 0xA000;

    private const int CurrentFolder = -100;
    private const int PathOnly = 0x200000;
    private const int CloseOnExec = 0x80000;
    private const int NotThroughLinks = 0x100;
    private const int OfHandle = 0x1000;
    private const int TypeWanted = 1;
    private const int NumberWanted = 0x100;
    private const int StatusLength = 256;
    private const int PlaceOfMode = 28;
    private const int PlaceOfNumber = 32;
    private const int PlaceOfDevice = 136;
    private const int MayWriteAndSearch = 2 | 1;
    private const uint OnlyIfFree = 1;
    private const uint InExchange = 2;

    // These two are the only ones that differ between processors (fcntl(2)).
    private static readonly bool IsArm = RuntimeInformation.ProcessArchitecture is Architecture.Arm or Architecture.Arm64;
    private static readonly int NoLink = IsArm ? 0x8000 : 0x20000;
    private static readonly int FolderOnly = IsArm ? 0x4000 : 0x10000;

    /// <summary>Takes hold of a file or folder without opening it, and of a link itself: nothing waits, and nothing is followed.</summary>
    /// <param name="path">Its path.</param>
    /// <exception cref="IOException">It cannot be reached; its HResult is the system's error.</exception>
    /// <exception cref="UnauthorizedAccessException">It must not be reached.</exception>
    public static SafeFileHandle Hold(string path) => Opened(path, PathOnly | NoLink | CloseOnExec);

    /// <summary>The path of what is held, by which the runtime reaches that very thing whatever has its name meanwhile.</summary>
    public static string PathOf(SafeFileHandle held) => FormattableString.Invariant($"/proc/self/fd/{held.DangerousGetHandle()}");

    /// <summary>True if <see cref="PathOf"/> leads anywhere on this computer.</summary>
    public static bool HasPaths { get; } = OperatingSystem.IsLinux() && Directory.Exists("/proc/self/fd");

    /// <summary>What kind of file is held: one of the kinds.</summary>
    public static int KindOf(SafeFileHandle held) =>
        Kind((int)held.DangerousGetHandle(), [0], OfHandle) ?? throw Failure("", Marshal.GetLastPInvokeError());

    /// <summary>What kind of file something is; null where nothing can be said.</summary>
    public static int? KindOf(string path) => Kind(CurrentFolder, Bytes(path), NotThroughLinks);

    /// <summary>Which file a path leads to; null if it leads to none.</summary>
    public static FileIdentity? IdentityOf(string path)
    {
        var status = new byte[StatusLength];
        return StatX(CurrentFolder, Bytes(path), 0, NumberWanted, status) != 0 ? null : new(
            BitConverter.ToUInt32(status, PlaceOfDevice), BitConverter.ToUInt32(status, PlaceOfDevice + 4), BitConverter.ToUInt64(status, PlaceOfNumber));
    }

    /// <summary>Lets two names change what they name, in one step.</summary>
    /// <returns>False if one of them is not there, null if the file system cannot.</returns>
    public static bool? Exchange(string one, string other) => Renamed(one, other, InExchange, unfit: 2);

    /// <summary>Gives a file another name that nothing has, in one step.</summary>
    /// <returns>False if something has the name, null if the file system cannot.</returns>
    public static bool? RenameToFree(string from, string to) => Renamed(from, to, OnlyIfFree, unfit: 17);

    /// <summary>Brings the names of a folder onto the disk. File systems that know no such thing do it by themselves or not at
    /// all.</summary>
    public static void SyncFolder(string folder)
    {
        using var handle = Opened(folder, FolderOnly | CloseOnExec);
        if (Sync((int)handle.DangerousGetHandle()) != 0 && Marshal.GetLastPInvokeError() is var error && !IsUnsupported(error))
        {
            throw Failure(folder, error);
        }
    }

    /// <summary>Why nothing may be written into a folder; null if it may, as far as rights and mounts tell.</summary>
    public static Exception? WhyNotWritable(string folder) =>
        Access(Bytes(folder), MayWriteAndSearch) == 0 ? null : Failure(folder, Marshal.GetLastPInvokeError());

    private static bool? Renamed(string from, string to, uint how, int unfit)
    {
        if (Rename(CurrentFolder, Bytes(from), CurrentFolder, Bytes(to), how) == 0)
        {
            return true;
        }

        var error = Marshal.GetLastPInvokeError();
        return error == unfit ? false : IsUnsupported(error) ? null : throw Failure(from, error);
    }

    // What a file system answers that cannot do something: EINVAL, ENOSYS, ENOTTY and EOPNOTSUPP.
    private static bool IsUnsupported(int error) => error is 22 or 38 or 25 or 95;

    private static SafeFileHandle Opened(string path, int flags)
    {
        var handle = new SafeFileHandle(Open(Bytes(path), flags, 0), ownsHandle: true);
        if (!handle.IsInvalid)
        {
            return handle;
        }

        var error = Marshal.GetLastPInvokeError();
        handle.Dispose();
        throw Failure(path, error);
    }

    private static int? Kind(int folder, byte[] path, int flags)
    {
        var status = new byte[StatusLength];
        return StatX(folder, path, flags, TypeWanted, status) == 0 ? BitConverter.ToUInt16(status, PlaceOfMode) & KindMask : null;
    }

    private static Exception Failure(string path, int error)
    {
        var message = $"{path}: {new Win32Exception(error).Message}";
        return error switch
        {
            2 => new FileNotFoundException(message, path),
            20 => new DirectoryNotFoundException(message),
            1 or 13 => new UnauthorizedAccessException(message),
            _ => new IOException(message, error),
        };
    }

    private static byte[] Bytes(string path) => [.. Encoding.UTF8.GetBytes(path), 0];

    // The layout of what statx answers is the same on every processor (statx(2)).
#pragma warning disable SYSLIB1054 // Arrays of bytes need no generated code.
    [DllImport("libc", EntryPoint = "open", ExactSpelling = true, SetLastError = true)]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static extern int Open(byte[] path, int flags, uint mode);

    [DllImport("libc", EntryPoint = "statx", ExactSpelling = true, SetLastError = true)]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static extern int StatX(int folder, byte[] path, int flags, uint wanted, byte[] status);

    [DllImport("libc", EntryPoint = "renameat2", ExactSpelling = true, SetLastError = true)]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static extern int Rename(int fromFolder, byte[] from, int toFolder, byte[] to, uint how);

    [DllImport("libc", EntryPoint = "fsync", ExactSpelling = true, SetLastError = true)]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static extern int Sync(int handle);

    [DllImport("libc", EntryPoint = "access", ExactSpelling = true, SetLastError = true)]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static extern int Access(byte[] path, int mode);
#pragma warning restore SYSLIB1054
}
