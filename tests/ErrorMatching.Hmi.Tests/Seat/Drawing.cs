using Avalonia;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>The application without a screen, one for all tests of the process.</summary>
internal static class Drawing
{
    /// <summary>Starts it, or returns the running one.</summary>
    public static OffScreenSession Needed() => OffScreenSession.Start(
        () => AppBuilder.Configure<App>().AfterSetup(_ => Avalonia.Logging.Logger.Sink = FailedBindings.Seen));
}
