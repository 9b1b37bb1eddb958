using System.Runtime.CompilerServices;
using System.Runtime.ExceptionServices;
using System.Runtime.InteropServices;
using Avalonia.Threading;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The one class of the station's windows, and their procedure.</summary>
internal static unsafe class Win32Class
{
    private const string Name = "ErrorMatching";

    // The icon that the compiler writes into the program, and the sizes that the system wants.
    private const int Icon = 32512, IconWidth = 11, IconHeight = 12, SmallIconWidth = 49, SmallIconHeight = 50;
    private const uint IsIcon = 1;
    private static readonly Dictionary<nint, Func<uint, nint, nint, nint?>> Windows = [];
    private static Func<uint, nint, nint, nint?>? _created;

    /// <summary>Registers the class, before the first window.</summary>
    public static void Register()
    {
        var program = Kernel32.GetModuleHandle(0);
        fixed (char* name = Name)
        {
            var description = new User32.WindowClass
            {
                Bytes = (uint)sizeof(User32.WindowClass),
                Procedure = &Procedure,
                Instance = program,
                Name = name,
                Icon = Load(IconWidth, IconHeight),
                SmallIcon = Load(SmallIconWidth, SmallIconHeight),
            };
            _ = User32.RegisterClass(&description);
        }

        nint Load(int width, int height) =>
            User32.LoadImage(program, Icon, IsIcon, User32.GetSystemMetrics(width), User32.GetSystemMetrics(height), 0);
    }

    /// <summary>Creates a window.</summary>
    /// <param name="style">Its style.</param>
    /// <param name="parent">0, or <see cref="User32.MessagesOnly"/>.</param>
    /// <param name="on">Handles its messages; null leaves one to the system.</param>
    /// <exception cref="PlatformNotSupportedException">The system refuses it.</exception>
    public static nint Create(uint style, nint parent, Func<uint, nint, nint, nint?> on)
    {
        // The first messages come before its handle is returned.
        _created = on;
        var window = User32.CreateWindow(
            0, Name, "", style, User32.Anywhere, 0, User32.Anywhere, 0, parent, 0, Kernel32.GetModuleHandle(0), 0);
        _created = null;
        return window != 0 ? window : throw new PlatformNotSupportedException(
            "Windows opens no window for the operator station. It needs a session with a screen.");
    }

    /// <summary>Destroys a window, whose messages are no longer passed on.</summary>
    public static void Destroy(nint window)
    {
        Windows.Remove(window);
        _ = User32.DestroyWindow(window);
    }

    [UnmanagedCallersOnly(CallConvs = [typeof(CallConvStdcall)])]
    private static nint Procedure(nint window, uint message, nint w, nint l)
    {
        if (_created is { } created)
        {
            Windows[window] = created;
            _created = null;
        }

        try
        {
            if (Windows.TryGetValue(window, out var on) && on(message, w, l) is { } answer)
            {
                return answer;
            }
        }
        catch (Exception e)
        {
            // The system's code is below: no exception may pass through it. The dispatcher handles it as that of any other input.
            var caught = ExceptionDispatchInfo.Capture(e);
            Dispatcher.UIThread.Post(caught.Throw, DispatcherPriority.Send);
        }

        return User32.Default(window, message, w, l);
    }
}
