using System.CommandLine;
using System.CommandLine.Help;
using System.CommandLine.Invocation;

namespace ErrorMatching.Console;

/// <summary>The help of a verb with its example below.</summary>
internal sealed class HelpWithExample(HelpAction help) : SynchronousCommandLineAction
{
    /// <inheritdoc/>
    public override bool ClearsParseErrors => true;

    /// <inheritdoc/>
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
