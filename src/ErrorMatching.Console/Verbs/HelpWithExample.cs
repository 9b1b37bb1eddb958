using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Invocation;

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
                    $"Example:\n  {CommandTree.Example}\n\nManual:\n  docs/first-match.md, and the tasks listed in docs/README.md\n");
                break;
        }

        return exit;
    }
}
