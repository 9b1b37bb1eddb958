using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The few entry points and numbers of UI Automation (UIAutomationCore.h) that a station needs.</summary>
internal static partial class Uia
{
    /// <summary>The second parameter of the message (WM_GETOBJECT) that asks for a window's elements.</summary>
    public const int Root = -25;

    public const int FocusChanged = 20005;

    public const int Invoke = 10000, Value = 10002, ExpandCollapse = 10005, SelectionItem = 10010, Toggle = 10015, ScrollItem = 10017;

    public const int ProcessId = 30002, ControlType = 30003, Name = 30005, HasFocus = 30008,
        IsFocusable = 30009, IsEnabled = 30010, Id = 30011, ClassName = 30012, Help = 30013, IsControl = 30016, IsContent = 30017,
        IsPassword = 30019, IsOffscreen = 30022, Framework = 30024, ItemStatus = 30026;

    private const string Library = "uiautomationcore";

    /// <summary>False where the system has no UI Automation.</summary>
    public static bool IsThere { get; } = NativeLibrary.TryLoad(Library, out _);

    [LibraryImport(Library, EntryPoint = "UiaReturnRawElementProvider")]
    public static partial nint Return(nint window, nint w, nint l, IElementProvider? provider);

    [LibraryImport(Library, EntryPoint = "UiaHostProviderFromHwnd")]
    public static partial int GetHost(nint window, out IElementProvider? host);

    [LibraryImport(Library, EntryPoint = "UiaClientsAreListening")] public static partial int AreClientsListening();

    [LibraryImport(Library, EntryPoint = "UiaRaiseAutomationEvent")]
    public static partial int Raise(IElementProvider provider, int happened);

    [LibraryImport("oleaut32")] public static partial nint SafeArrayCreateVector(ushort kind, int first, uint count);

    [LibraryImport("oleaut32")] public static unsafe partial int SafeArrayPutElement(nint array, int* index, void* element);

    /// <summary>An array of numbers that the caller frees.</summary>
    public static unsafe nint Array(ReadOnlySpan<int> numbers)
    {
        var array = SafeArrayCreateVector((ushort)VarEnum.VT_I4, 0, (uint)numbers.Length);
        for (var i = 0; i < numbers.Length; i++)
        {
            var number = numbers[i];
            Marshal.ThrowExceptionForHR(SafeArrayPutElement(array, &i, &number));
        }

        return array;
    }
}
