using System.Runtime.InteropServices;
using System.Runtime.Versioning;

namespace ErrorMatching.Hmi.Desktop;

/// <summary>A window of the system with a sentence, for what prevents the station's own window.</summary>
[SupportedOSPlatform("windows")]
internal static partial class MessageWindow
{
    private const uint WithErrorIcon = 0x10, WithInformationIcon = 0x40;

    /// <summary>Shows what is wrong and waits until it is closed.</summary>
    public static void ShowError(string sentence) => _ = Show(0, sentence, "ErrorMatching", WithErrorIcon);

    /// <summary>Shows what was asked for, such as the options, and waits until it is closed.</summary>
    public static void Show(string text) => _ = Show(0, text, "ErrorMatching", WithInformationIcon);

    [LibraryImport("user32", EntryPoint = "MessageBoxW", StringMarshalling = StringMarshalling.Utf16)]
    [DefaultDllImportSearchPaths(DllImportSearchPath.System32)]
    private static partial int Show(nint owner, string text, string caption, uint kind);
}
