using ErrorMatching.Hmi.Platform;

namespace ErrorMatching.Hmi.Tests;

public sealed class NativeLibrariesTests
{
    [Fact]
    public void What_is_missing_is_named_with_the_command_that_brings_it()
    {
        var e = Assert.Throws<PlatformNotSupportedException>(() => NativeLibraries.Demand(
            [("libc.so.6", "libc6"), ("libnobody-has-it.so.9", "libnobody9"), ("libnor-this.so.1", "libnor1")]));
        Assert.Equal(
            "The operator station needs libraries of the system, and some are missing here. Install them: apt-get install "
                + "libnobody9 libnor1",
            e.Message);
    }

    [Fact]
    public void Windows_need_X_and_nothing_else() =>
        Assert.Equal(["libx11-6"], NativeLibraries.ForWindows.Select(l => l.Package));
}
