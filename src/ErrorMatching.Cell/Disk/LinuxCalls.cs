using System.ComponentModel;
using System.Runtime.InteropServices;
using System.Text;
using Microsoft.Win32.SafeHandles;

namespace ErrorMatching.Cell;

/// <summary>Linux system calls that the runtime does not offer: a file's type before it is opened, handles that pin folders, and renaming
/// without unnoticed overwriting.</summary>
internal static class LinuxCalls
{
    /// <summary>The bits of a mode that hold the file type (inode(7)).</summary>
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
    private const int OwnerWanted = 8;
    private const int StatusLength = 256;
    private const int PlaceOfOwner = 20;
    private const int PlaceOfMode = 28;
    private const int PlaceOfNumber = 32;
    private const int PlaceOfDevice = 136;
    private const int MayWriteAndSearch = 2 | 1;
    private const uint OnlyIfFree = 1;
    private const uint InExchange = 2;

    // Only these two differ between processors (fcntl(2)).
    private static readonly bool IsArm = RuntimeInformation.ProcessArchitecture is Architecture.Arm or Architecture.Arm64;
    private static readonly int NoLink = IsArm ? 0x8000 : 0x20000;
    private static readonly int FolderOnly = IsArm ? 0x4000 : 0x10000;

    /// <summary>Gets a handle to a file or folder without opening it, or to a link itself: this never blocks and follows no link.</summary>
    /// <exception cref="IOException">It cannot be reached; its HResult is the system's error.</exception>
    /// <exception cref="UnauthorizedAccessException">Access is denied.</exception>
    public static SafeFileHandle Hold(string path) => Opened(path, PathOnly | NoLink | CloseOnExec);

    /// <summary>The path by which the runtime reaches the held file itself, even if its name now belongs to another.</summary>
    public static string PathOf(SafeFileHandle held) => FormattableString.Invariant($"/proc/self/fd/{held.DangerousGetHandle()}");

    /// <summary>True if <see cref="PathOf"/> works on this computer.</summary>
    public static bool HasPaths { get; } = OperatingSystem.IsLinux() && Directory.Exists("/proc/self/fd");

    /// <summary>The type of the held file.</summary>
    public static int KindOf(SafeFileHandle held) =>
        Kind((int)held.DangerousGetHandle(), [0], OfHandle) ?? throw Failure("", Marshal.GetLastPInvokeError());

    /// <summary>The type of the file at a path; null if unknown.</summary>
    public static int? KindOf(string path) => Kind(CurrentFolder, Bytes(path), NotThroughLinks);

    /// <summary>The identity of the file at a path; null if there is none.</summary>
    public static FileIdentity? IdentityOf(string path)
    {
        var status = new byte[StatusLength];
        return StatX(CurrentFolder, Bytes(path), 0, NumberWanted, status) != 0 ? null : new(
            BitConverter.ToUInt32(status, PlaceOfDevice),
            BitConverter.ToUInt32(status, PlaceOfDevice + 4),
            BitConverter.ToUInt64(status, PlaceOfNumber));
    }

    /// <summary>True if the file at a path belongs to the user of this process; a link is followed.</summary>
    public static bool IsOwn(string path)
    {
        var status = new byte[StatusLength];
        return StatX(CurrentFolder, Bytes(path), 0, OwnerWanted, status) == 0
            && BitConverter.ToUInt32(status, PlaceOfOwner) == EffectiveUser();
    }

    /// <summary>Exchanges two names atomically.</summary>
    /// <returns>False if one of them does not exist, null if the file system does not support it.</returns>
    public static bool? Exchange(string one, string other) => Renamed(one, other, InExchange, unfit: 2);

    /// <summary>Renames a file to a free name, atomically.</summary>
    /// <returns>False if the name is taken, null if the file system does not support it.</returns>
    public static bool? RenameToFree(string from, string to) => Renamed(from, to, OnlyIfFree, unfit: 17);

    /// <summary>Flushes the names in a folder to disk. File systems without this operation do it on their own or not at all.</summary>
    public static void SyncFolder(string folder)
    {
        using var handle = Opened(folder, FolderOnly | CloseOnExec);
        if (Sync((int)handle.DangerousGetHandle()) != 0 && Marshal.GetLastPInvokeError() is var error && !IsUnsupported(error))
        {
            throw Failure(folder, error);
        }
    }

    /// <summary>Why a folder is not writable; null if it is, as far as permissions and mounts show.</summary>
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

    // Errors of a file system that does not support an operation: EINVAL, ENOSYS, ENOTTY and EOPNOTSUPP.
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

    // The layout of the statx result is the same on every processor (statx(2)).
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

    [DllImport("libc", EntryPoint = "geteuid", ExactSpelling = true)]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static extern uint EffectiveUser();
#pragma warning restore SYSLIB1054
}

/// <summary>The identity of the file behind a name. A file that replaces it under the same name has another identity, even with the same
/// content.</summary>
/// <param name="DeviceMajor">The disk's major number.</param>
/// <param name="DeviceMinor">The disk's minor number.</param>
/// <param name="Number">The file's number on its disk (inode).</param>
internal sealed record FileIdentity(uint DeviceMajor, uint DeviceMinor, ulong Number)
{
    // Where an open file cannot lose its name to another file, a single identity is enough.
    private static readonly FileIdentity Any = new(0, 0, 0);

    /// <summary>The identity of the file at a path; null if there is none.</summary>
    public static FileIdentity? Of(string path) => OperatingSystem.IsLinux() ? LinuxCalls.IdentityOf(path) : File.Exists(path) ? Any : null;
}
