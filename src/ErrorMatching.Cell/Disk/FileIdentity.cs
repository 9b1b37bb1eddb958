namespace ErrorMatching.Cell;

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
