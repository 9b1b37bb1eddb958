using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

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
