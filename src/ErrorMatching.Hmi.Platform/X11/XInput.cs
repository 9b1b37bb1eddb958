using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The entry points of the X Input Extension that touches need (Debian: libxi6).</summary>
internal static unsafe partial class XInput
{
    public const string Library = "libXi.so.6";
    public const int Motion = 6, TouchBegin = 18, TouchUpdate = 19, TouchEnd = 20;

    /// <summary>The devices that clients see: all screens with fingers together.</summary>
    public const int AllMasterDevices = 1;

    [LibraryImport(Library)] public static partial int XIQueryVersion(nint display, ref int major, ref int minor);
    [LibraryImport(Library)] public static partial int XISelectEvents(nint display, nint window, Mask* masks, int count);

    /// <summary>XIEventMask: the events of a device, as a bit set.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Mask
    {
        public int Device;
        public int Length;
        public byte* Bits;
    }

    /// <summary>XIDeviceEvent: the members used here, in its 64-bit layout. Positions are in pixels, with fractions.</summary>
    [StructLayout(LayoutKind.Explicit)]
    public struct DeviceEvent
    {
        [FieldOffset(36)] public int Kind;
        [FieldOffset(56)] public uint Detail;
        [FieldOffset(72)] public nint Window;
        [FieldOffset(104)] public double X;
        [FieldOffset(112)] public double Y;
        [FieldOffset(120)] public int Flags;
        [FieldOffset(128)] public int ButtonBytes;
        [FieldOffset(136)] public byte* Buttons;
        [FieldOffset(180)] public int Modifiers;
    }
}
