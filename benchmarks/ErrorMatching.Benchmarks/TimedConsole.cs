using ErrorMatching.Testing;

namespace ErrorMatching.Benchmarks;

/// <summary>The console that is timed.</summary>
internal static class TimedConsole
{
    /// <summary>What <c>ERRORMATCH_CONSOLE</c> names, such as the native one of <c>deploy/pack --native</c>; without it, the one from the
    /// build.</summary>
    public static string Path => Environment.GetEnvironmentVariable("ERRORMATCH_CONSOLE")
        ?? Repository.PathTo(
            "artifacts", "bin", "ErrorMatching.Console", "release", OperatingSystem.IsWindows() ? "errormatch.exe" : "errormatch");
}
