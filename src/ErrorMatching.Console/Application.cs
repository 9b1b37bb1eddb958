using System.CommandLine;
using ErrorMatching.Jobs;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary>Runs one command line and turns its result into output and an exit code.</summary>
internal static class Application
{
    /// <summary>Runs a command line.</summary>
    /// <param name="args">The arguments after the program's name.</param>
    /// <param name="terminal">Where to write.</param>
    /// <param name="cancellation">Set by Ctrl+C.</param>
    /// <returns>The exit code of the process.</returns>
    public static int Run(IReadOnlyList<string> args, Terminal terminal, CancellationToken cancellation)
    {
        var isJson = args.Contains("--json");
        try
        {
            var parsed = CommandTree.Parse(args);
            if (parsed.Errors.Count == 0 && parsed.Action is not null)
            {
                var exit = parsed.Invoke(
                    new InvocationConfiguration
                    {
                        Output = terminal.Output,
                        Error = terminal.Error,
                        EnableDefaultExceptionHandler = false,
                        ProcessTerminationTimeout = null
                    });
                terminal.Output.Flush();
                return exit;
            }

            // errormatch nc help check
            if (args is [var group, HelpVerb.Word, ..] && CommandTree.Build(group).Subcommands.Any(c => c.Name == group && c is not Verb))
            {
                parsed = CommandTree.Parse([HelpVerb.Word, group, .. args.Skip(2)]);
            }

            var code = OutcomeWriter.Write(OutcomeOf(parsed, terminal, cancellation), terminal, isJson);
            terminal.Output.Flush();
            if (!isJson && IsBegun(parsed))
            {
                CommandTree.WriteHelp(args, terminal.Error);
            }

            return (int)code;
        }
        catch (IOException e)
        {
            // The reader of a pipe has gone, or the disk of a redirection is full. This stream may be the only one left for the message.
            terminal.Error.Write($"errormatch: the output cannot be written: {e.Message}\n");
            return (int)ExitCode.Outside;
        }
    }

    // errormatch alone, or errormatch nc: what may follow is worth more than the complaint. It goes where the complaint goes, so that a
    // script does not take it for a result.
    private static bool IsBegun(ParseResult parsed) =>
        parsed.CommandResult.Command is not Verb && parsed.UnmatchedTokens.Count == 0;

    private static VerbResult OutcomeOf(ParseResult parsed, Terminal terminal, CancellationToken cancellation)
    {
        if (FailureOfCommandLine.Of(parsed) is { } wrong)
        {
            return wrong;
        }

        try
        {
            var verb = (Verb)parsed.CommandResult.Command;
            verb.Input = terminal.Input;
            verb.Secrets = terminal.Secrets;
            verb.ProgressTo = terminal.Progress;
            return verb.Run(parsed, cancellation);
        }
        catch (InputException e)
        {
            return FailureOf.Input(e);
        }
        catch (OutputException e)
        {
            return FailureOf.Output(e);
        }
        catch (OperationCanceledException) when (cancellation.IsCancellationRequested)
        {
            return new Failure(ExitCode.Cancelled, new Refusal("cancelled", "Cancelled. No output is half-written."));
        }
#pragma warning disable CA1031 // A defect's exception must give a documented exit code, not the runtime's.
        catch (Exception e)
        {
            return FailureOf.Defect(e);
        }
#pragma warning restore CA1031
    }
}
