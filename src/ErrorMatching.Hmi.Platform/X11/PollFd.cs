using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

/// <summary>A file descriptor to wait for, in the layout for <c>poll</c>.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct PollFd
{
    public int Fd;
    public short Events;
    public short Returned;
}
