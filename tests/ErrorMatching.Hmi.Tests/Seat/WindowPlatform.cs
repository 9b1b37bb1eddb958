using Avalonia.Controls;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What is below a window that nobody sees: its keys and its pixels.</summary>
internal static class WindowPlatform
{
    public static OffScreenWindow Platform(this Window window) => (OffScreenWindow)window.PlatformImpl!;
}
