using System.Buffers.Binary;
using System.Runtime.InteropServices;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>Which file has a name: another one that takes the name has another identity, though its content be the same.</summary>
/// <param name="DeviceMajor">The disk's major number.</param>
/// <param name="DeviceMinor">The disk's minor number.</param>
/// <param name="Number">The file's number on its disk (inode).</param>
internal sealed record FileIdentity(uint DeviceMajor, uint DeviceMinor, ulong Number)
{
    private const int CurrentFolder = -100;
    private const uint NumberWanted = 0x100;
    private const int PlaceOfNumber = 32;
    private const int PlaceOfDevice = 136;

    // Where an open file keeps its name nothing else can take it: all files are one there.
    private static readonly FileIdentity Any = new(0, 0, 0);

    /// <summary>Which file a path leads to; null if it leads to none.</summary>
    public static FileIdentity? Of(string path)
    {
        if (!OperatingSystem.IsLinux())
        {
            return File.Exists(path) ? Any : null;
        }

        var status = new byte[256];
        return StatX(CurrentFolder, [.. Encoding.UTF8.GetBytes(path), 0], 0, NumberWanted, status) != 0 ? null : new(
            BinaryPrimitives.ReadUInt32LittleEndian(status.AsSpan(PlaceOfDevice)),
            BinaryPrimitives.ReadUInt32LittleEndian(status.AsSpan(PlaceOfDevice + 4)),
            BinaryPrimitives.ReadUInt64LittleEndian(status.AsSpan(PlaceOfNumber)));
    }

    // The layout of what statx answers is the same on every processor (statx(2)).
#pragma warning disable SYSLIB1054 // Arrays of bytes need no generated code.
    [DllImport("libc", EntryPoint = "statx", ExactSpelling = true)]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static extern int StatX(int folder, byte[] path, int flags, uint wanted, byte[] status);
#pragma warning restore SYSLIB1054
}
