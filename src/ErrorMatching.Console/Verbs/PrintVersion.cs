using System.CommandLine;
using System.CommandLine.Invocation;
using System.Reflection;

namespace ErrorMatching.Console;

/// <summary>Prints the version of the console and nothing else.</summary>
internal sealed class PrintVersion : SynchronousCommandLineAction
{
    /// <summary>The version, such as <c>0.2.0</c>.</summary>
    public static string Version { get; } = typeof(
        PrintVersion).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()!.InformationalVersion;

    public override int Invoke(ParseResult parseResult)
    {
        parseResult.InvocationConfiguration.Output.Write(Version + "\n");
        return 0;
    }
}
