using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Invocation;
using ErrorMatching.Json;

namespace ErrorMatching.Console;

/// <summary>A verb's help followed by its example.</summary>
internal sealed class HelpWithExample(HelpAction help) : SynchronousCommandLineAction
{
    public override bool ClearsParseErrors => true;

    public override int Invoke(ParseResult parseResult)
    {
        var exit = help.Invoke(parseResult);
        switch (parseResult.CommandResult.Command)
        {
            case Verb verb:
                parseResult.InvocationConfiguration.Output.Write($"Example:\n  {verb.Example}\n");
                break;
            case RootCommand:
                parseResult.InvocationConfiguration.Output.Write(
                    $"Example:\n  {CommandTree.Example}\n\nManual:\n  {Page("first-match.md")}, and the tasks listed in "
                        + $"{Page("README.md")}\n");
                break;
        }

        return exit;
    }

    // The packages have the documentation beside the program. A checkout has it where the example works.
    private static string Page(string name)
    {
        var installed = Path.Combine(AppContext.BaseDirectory, "docs", name);
        return File.Exists(installed) ? PathText.Of(installed) : "docs/" + name;
    }
}
