using System.CommandLine;
using ErrorMatching.Freeform;
using ErrorMatching.Mating;

namespace ErrorMatching.Console;

/// <summary><c>errormatch job schema</c>.</summary>
internal sealed class JobSchema : Verb
{
    private readonly Argument<string> _kind = JobKind.Argument();

    /// <summary>The verb.</summary>
    public JobSchema()
        : base("schema", "Prints the JSON Schema of jobs: every key with its meaning.", "errormatch job schema mating") => Arguments.Add(_kind);

    /// <inheritdoc/>
    public override Outcome Run(ParseResult arguments, CancellationToken cancellation) =>
        new JobSchemaAnswer(arguments.GetRequiredValue(_kind) == JobKind.Freeform ? FreeformTemplate.Schema : JobTemplate.Schema);
}
