using System.CommandLine;

namespace ErrorMatching.Console;

/// <summary>One command of the console. It parses nothing by itself and writes nothing: it turns arguments into an outcome.</summary>
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

    /// <summary>Does the work.</summary>
    /// <param name="arguments">What the user typed, parsed without errors.</param>
    /// <param name="cancellation">Set by Ctrl+C.</param>
    public abstract Outcome Run(ParseResult arguments, CancellationToken cancellation);
}
