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
        if (parseResult.CommandResult.Command is Verb verb)
        {
            parseResult.InvocationConfiguration.Output.Write($"Example:\n  {verb.Example}\n");
        }

        return exit;
    }
}
