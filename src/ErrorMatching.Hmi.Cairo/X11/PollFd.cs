using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Cairo;

/// <summary>A file that is waited for, as <c>poll</c> takes it.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct PollFd
{
    public int Fd;
    public short Events;
    public short Returned;
}
