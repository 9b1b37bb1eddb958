using System.CommandLine;

namespace ErrorMatching.Console;

/// <summary>One command of the console. It parses nothing by itself and prints nothing: it turns arguments into an outcome.</summary>
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

    /// <summary>Where passwords come from, for verbs that people sign.</summary>
    public SecretInput? Secrets { get; set; }

    /// <summary>The terminal on which long work says how far it is; null if there is none.</summary>
    public TextWriter? ProgressTo { get; set; }

    /// <summary>Does the work.</summary>
    /// <param name="arguments">What the user typed, parsed without errors.</param>
    /// <param name="cancellation">Set by Ctrl+C.</param>
    public abstract Outcome Run(ParseResult arguments, CancellationToken cancellation);

    /// <summary>An option that names a file.</summary>
    protected static Option<string> FileOption(string name, string description) => new(name) { Description = description, HelpName = "FILE" };

    /// <summary>Makes a value of another form a wrong command line.</summary>
    protected static void Demand(Option<string> option, Predicate<string> isGood, string expected) => option.Validators.Add(result =>
    {
        if (result.Tokens is [var token] && !isGood(token.Value))
        {
            result.AddError($"{option.Name} is {token.Value}; expected {expected}.");
        }
    });
}
