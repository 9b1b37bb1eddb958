using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The touch keyboard of Windows (Windows.UI.ViewManagement.InputPane, from Windows 10 on).</summary>
/// <remarks>Windows decides whether it appears: by default, it does where no other keyboard is connected. What refuses, such as an
/// older system, leaves everything as it is.</remarks>
internal sealed unsafe class Win32TouchKeyboard
{
    private const string Keyboards = "Windows.UI.ViewManagement.InputPane";

    // Places in the tables of functions, after three of IUnknown and three of IInspectable: IInputPaneInterop.GetForWindow, and
    // IInputPane2.TryShow and TryHide.
    private const int ForWindow = 6, TryShow = 6, TryHide = 7;
    private const int IsDone = 0;

    private static readonly Guid Interop = new("75CF2C57-9195-4931-8332-F0B409E916AF");
    private static readonly Guid Pane = new("8A6B3F26-7090-4793-944C-C3F2CDE26276");

    private readonly void* _pane;

    private Win32TouchKeyboard(void* pane) => _pane = pane;

    /// <summary>The touch keyboard for a window; null if there is none.</summary>
    public static Win32TouchKeyboard? For(nint window)
    {
        // Windows 7 has none of this.
        if (!NativeLibrary.TryLoad(Combase.Library, out var library)
            || !NativeLibrary.TryGetExport(library, nameof(Combase.RoGetActivationFactory), out _))
        {
            return null;
        }

        nint name;
        if (Combase.WindowsCreateString(Keyboards, (uint)Keyboards.Length, &name) != IsDone)
        {
            return null;
        }

        var (interop, pane) = (Interop, Pane);
        void* factory = null, found = null;
        if (Combase.RoGetActivationFactory(name, &interop, &factory) == IsDone)
        {
            var get = (delegate* unmanaged[Stdcall]<void*, nint, Guid*, void**, int>)Function(factory, ForWindow);
            if (get(factory, window, &pane, &found) != IsDone)
            {
                found = null;
            }

            _ = Marshal.Release((nint)factory);
        }

        _ = Combase.WindowsDeleteString(name);
        return found is null ? null : new(found);
    }

    /// <summary>Shows it, or takes it away.</summary>
    public void Show(bool isShown)
    {
        byte isAccepted;
        var act = (delegate* unmanaged[Stdcall]<void*, byte*, int>)Function(_pane, isShown ? TryShow : TryHide);
        _ = act(_pane, &isAccepted);
    }

    /// <summary>Ends its use, with the window.</summary>
    public void Leave() => _ = Marshal.Release((nint)_pane);

    private static void* Function(void* it, int place) => (*(void***)it)[place];
}

/// <summary>The few entry points of combase for classes of the Windows Runtime.</summary>
internal static unsafe partial class Combase
{
    /// <summary>Its file.</summary>
    public const string Library = "combase";

    [LibraryImport(Library, StringMarshalling = StringMarshalling.Utf16)]
    public static partial int WindowsCreateString(string text, uint length, nint* made);

    [LibraryImport(Library)] public static partial int WindowsDeleteString(nint text);

    [LibraryImport(Library)] public static partial int RoGetActivationFactory(nint name, Guid* wanted, void** factory);
}
