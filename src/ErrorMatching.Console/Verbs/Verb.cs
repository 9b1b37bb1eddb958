using System.CommandLine;

namespace ErrorMatching.Console;

/// <summary>One command of the console. It turns parsed arguments into an outcome, without parsing or printing.</summary>
internal abstract class Verb : Command
{
    /// <summary>A command.</summary>
    /// <param name="name">The word on the command line.</param>
    /// <param name="description">One sentence for the help.</param>
    /// <param name="example">A whole command line that works in the root of the checkout.</param>
    protected Verb(string name, string description, string example)
        : base(name, description) => Example = example;

    /// <summary>A whole command line that works in the root of the checkout.</summary>
    public string Example { get; }

    /// <summary>The source of passwords, for verbs that people sign.</summary>
    public SecretInput? Secrets { get; set; }

    /// <summary>The terminal for progress of long operations; null if there is none.</summary>
    public TextWriter? ProgressTo { get; set; }

    /// <summary>Runs the command.</summary>
    /// <param name="arguments">The user's arguments, parsed without errors.</param>
    /// <param name="cancellation">Set by Ctrl+C.</param>
    public abstract VerbResult Run(ParseResult arguments, CancellationToken cancellation);

    /// <summary>An option for a file.</summary>
    protected static Option<string> FileOption(string name, string description) =>
        new(name) { Description = description, HelpName = "FILE" };

    /// <summary>Rejects a value of the wrong form as a command line error.</summary>
    protected static void Demand(Option<string> option, Predicate<string> isGood, string expected) => option.Validators.Add(result =>
    {
        if (result.Tokens is [var token] && !isGood(token.Value))
        {
            result.AddError($"{option.Name} is {token.Value}; expected {expected}.");
        }
    });
}
