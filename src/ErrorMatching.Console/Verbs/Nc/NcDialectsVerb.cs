using System.CommandLine;

namespace ErrorMatching.Console;

/// <summary><c>errormatch nc dialects</c>.</summary>
internal sealed class NcDialectsVerb : Verb
{
    /// <summary>The verb.</summary>
    public NcDialectsVerb()
        : base("dialects", "Lists the controls that are known, and what is assumed of each.", "errormatch nc dialects")
    {
    }

    /// <inheritdoc/>
    public override Outcome Run(ParseResult arguments, CancellationToken cancellation) => new NcDialectsAnswer();
}
