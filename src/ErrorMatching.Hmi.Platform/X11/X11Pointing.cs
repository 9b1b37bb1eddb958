namespace ErrorMatching.Hmi.Platform;

/// <summary>Has the server report fingers each by itself, and tell the mouse from a pointer that a finger moves.</summary>
/// <remarks>Source: The X Input Extension 2.2, chapter 4, "Touch events", and "Pointer emulation". A window that selects touches gets no
/// emulated buttons for them. But before a finger's beginning, the server moves the pointer to it; only the extension's own motion events
/// say so. Ownership is not selected, so the server tells of a finger only when no other client, such as a window manager, can claim it
/// any more.</remarks>
internal static unsafe class X11Pointing
{
    private const int Success = 0, Marked = 1 << 16;
    private const int None = -1;

    // The extension's number; none if the server or the library lacks it, null before the first window.
    private static int? _extension;

    /// <summary>Has the server report fingers and the pointer's motion on a window. Without XInput 2.2, a finger remains a mouse.</summary>
    /// <param name="window">The window.</param>
    /// <param name="advise">Told once if fingers are not reported, and why; null if nobody wants to know.</param>
    public static void Select(nint window, Action<string>? advise)
    {
        if (_extension is null)
        {
            _extension = Find(out var missing);
            if (missing is not null)
            {
                advise?.Invoke($"A finger acts as a mouse, and two fingers cannot zoom: {missing}");
            }
        }

        if (_extension == None)
        {
            return;
        }

        const int Length = (XInput.TouchEnd / 8) + 1;
        var bits = stackalloc byte[Length];
        foreach (var kind in (ReadOnlySpan<int>)[XInput.Motion, XInput.TouchBegin, XInput.TouchUpdate, XInput.TouchEnd])
        {
            bits[kind / 8] |= (byte)(1 << (kind % 8));
        }

        var mask = new XInput.Mask { Device = XInput.AllMasterDevices, Length = Length, Bits = bits };
        _ = XInput.XISelectEvents(X11Connection.Display, window, &mask, 1);
    }

    /// <summary>Fetches what an event with data says, and frees the data.</summary>
    /// <returns>Null if it is not about a finger or the pointer's motion.</returns>
    public static XInputEvent? Read(ref XEvent e)
    {
        if (e.Extension != _extension || Xlib.XGetEventData(X11Connection.Display, ref e) == 0)
        {
            return null;
        }

        try
        {
            return Decode(in *(XInput.DeviceEvent*)e.Cookie);
        }
        finally
        {
            Xlib.XFreeEventData(X11Connection.Display, ref e);
        }
    }

    /// <summary>Reads an event's data.</summary>
    /// <returns>Null if it is not about a finger or the pointer's motion.</returns>
    public static XInputEvent? Decode(in XInput.DeviceEvent data)
    {
        if (data.Kind is not (XInput.Motion or XInput.TouchBegin or XInput.TouchUpdate or XInput.TouchEnd))
        {
            return null;
        }

        // Button 1 is bit 1 here, and bit 8 in the core protocol.
        var buttons = data.ButtonBytes > 0 ? (uint)(data.Buttons[0] & 0xE) << 7 : 0;
        return new(
            data.Window, data.Kind, data.Detail, data.X, data.Y, (uint)data.Modifiers | buttons, (data.Flags & Marked) != 0);
    }

    private static int Find(out string? missing)
    {
        missing = "libXi is missing. Install it: apt-get install libxi6";
        if (!NativeLibraries.IsThere(XInput.Library))
        {
            return None;
        }

        // Asked for first: without the extension, the library writes to standard error.
        missing = "the X server has no XInput 2.2.";
        var display = X11Connection.Display;
        if (Xlib.XQueryExtension(display, "XInputExtension", out var extension, out _, out _) == 0)
        {
            return None;
        }

        var (major, minor) = (2, 2);
        if (XInput.XIQueryVersion(display, ref major, ref minor) != Success || (major, minor).CompareTo((2, 2)) < 0)
        {
            return None;
        }

        missing = null;
        return extension;
    }
}
