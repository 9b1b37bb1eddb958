using ErrorMatching.Hmi.Platform;

namespace ErrorMatching.Hmi.Tests;

/// <summary>15 mm are 15 mm, as far as the monitor says how large it is and all of the station fits.</summary>
public sealed class X11MonitorTests
{
    [Theory]
    [InlineData("24 inches, full HD", 1920, 1080, 531, 299, 1)]
    [InlineData("27 inches, 4K", 3840, 2160, 597, 336, 1.7)]
    [InlineData("32 inches, 4K", 3840, 2160, 708, 398, 1.4)]
    [InlineData("15.6 inches, 4K: at most twice", 3840, 2160, 344, 194, 2)]
    [InlineData("15.6 inches, full HD: no room for more", 1920, 1080, 344, 194, 1.35)]
    [InlineData("12 inches, 1280x800: no room", 1280, 800, 261, 163, 1)]
    [InlineData("a wall, 65 inches", 3840, 2160, 1439, 809, 1)]
    [InlineData("no size", 3840, 2160, 0, 0, 1)]
    [InlineData("a shape", 3840, 2160, 160, 90, 1)]
    [InlineData("rounded to a millimeter", 2560, 1600, 542, 339, 1.25)]
    public void A_monitor_gets_the_scale_that_its_size_asks_for(
        string name, int width, int height, int widthMm, int heightMm, double scaling)
    {
        Assert.NotEmpty(name);
        Assert.Equal(scaling, X11Monitor.ScalingOf(width, height, widthMm, heightMm), 1e-9);
    }
}
