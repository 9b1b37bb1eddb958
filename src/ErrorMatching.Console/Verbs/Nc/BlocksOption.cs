using System.CommandLine;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary>The option that names blocks.</summary>
internal sealed class BlocksOption : Option<string[]>
{
    public BlocksOption()
        : base("--blocks")
    {
        Description = "The blocks: a number (N110), a range (N110..N130), lines of the file (L12..L40) or a regular expression "
            + "(/^N8[0-9]{3}/), one or more of them.";
        HelpName = "SELECTOR";
        Required = true;
        Arity = ArgumentArity.OneOrMore;
        AllowMultipleArgumentsPerToken = true;
    }

    /// <summary>The positions of the named blocks, in ascending order.</summary>
    /// <exception cref="InputException">A selector cannot be read.</exception>
    public Outcome<int[]> Select(ParseResult arguments, NcProgram program) =>
        BlockSelector.Select(program, [.. arguments.GetRequiredValue(this).Select(BlockSelector.Parse)]);
}
