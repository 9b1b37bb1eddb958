using Avalonia;
using ErrorMatching.Hmi.Platform;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>The application without a screen, one for all tests of the process.</summary>
internal static class Drawing
{
    /// <summary>Skips the current test where the libraries that draw are not installed,
    /// or fails it where ERRORMATCH_PEERS=required demands them.</summary>
    public static OffScreenSession Needed()
    {
        var missing = NativeLibraries.MissingForDrawing;
        if (Environment.GetEnvironmentVariable("ERRORMATCH_PEERS") == "required")
        {
            Assert.True(missing.Count == 0, $"Libraries that draw are missing: install {string.Join(" ", missing)}.");
        }

        Assert.SkipUnless(missing.Count == 0, $"The libraries that draw are not installed (packages {string.Join(" ", missing)}).");
        return OffScreenSession.Start(() => AppBuilder.Configure<App>());
    }
}
