namespace ErrorMatching.Cell;

/// <summary>Which file has a name: another one that takes the name has another identity, even if its content is the same.</summary>
/// <param name="DeviceMajor">The disk's major number.</param>
/// <param name="DeviceMinor">The disk's minor number.</param>
/// <param name="Number">The file's number on its disk (inode).</param>
internal sealed record FileIdentity(uint DeviceMajor, uint DeviceMinor, ulong Number)
{
    // Where an open file keeps its name nothing else can take it: all files are one there.
    private static readonly FileIdentity Any = new(0, 0, 0);

    /// <summary>Which file a path leads to; null if it leads to none.</summary>
    public static FileIdentity? Of(string path) => OperatingSystem.IsLinux() ? LinuxCalls.IdentityOf(path) : File.Exists(path) ? Any : null;
}
