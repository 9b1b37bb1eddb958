using System.Runtime.InteropServices;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>Tells plain files from what only looks like one. Opening a pipe or a device could wait for ever.</summary>
internal static class PlainFile
{
    private const int CurrentFolder = -100;
    private const int NotThroughLinks = 0x100;
    private const int TypeWanted = 1;
    private const int PlaceOfMode = 28;
    private const int KindMask = 0xF000;
    private const int Plain = 0x8000;

    /// <summary>Why something is no plain file; null if it is one.</summary>
    public static string? Defect(FileSystemInfo item)
    {
        var attributes = item.Attributes;
        if (attributes.HasFlag(FileAttributes.ReparsePoint))
        {
            return "it is a link";
        }

        if (attributes.HasFlag(FileAttributes.Directory))
        {
            return "it is a folder";
        }

        return attributes.HasFlag(FileAttributes.Device) || (OperatingSystem.IsLinux() && !IsPlainOnLinux(item.FullName)) ? "it is a pipe, a socket or a device" : null;
    }

    // A name that cannot be spelled has no answer, and opening it only fails.
    private static bool IsPlainOnLinux(string path)
    {
        var status = new byte[256];
        return StatX(CurrentFolder, [.. Encoding.UTF8.GetBytes(path), 0], NotThroughLinks, TypeWanted, status) != 0
            || (BitConverter.ToUInt16(status, PlaceOfMode) & KindMask) == Plain;
    }

    // The runtime does not tell what kind of file something is before it is opened. The layout of the answer is the same on every processor (statx(2)).
#pragma warning disable SYSLIB1054 // Arrays of bytes need no generated code.
    [DllImport("libc", EntryPoint = "statx", ExactSpelling = true)]
    [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
    private static extern int StatX(int folder, byte[] path, int flags, uint wanted, byte[] status);
#pragma warning restore SYSLIB1054
}
