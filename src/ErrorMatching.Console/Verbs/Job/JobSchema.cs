using System.CommandLine;
using System.Runtime.CompilerServices;
using ErrorMatching.Cell;
using ErrorMatching.Freeform;
using ErrorMatching.Mating;

namespace ErrorMatching.Console;

/// <summary><c>errormatch job schema</c>.</summary>
internal sealed class JobSchema : Verb
{
    private readonly Argument<string> _kind = JobKind.Argument();

    public JobSchema()
        : base("schema", "Prints the JSON Schema of jobs, or of a cell: every key with its meaning.", "errormatch job schema mating") =>
            Arguments.Add(_kind);

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation) =>
        new JobSchemaAnswer(SchemaOf(arguments.GetRequiredValue(_kind)));

    private static string SchemaOf(string kind) => kind switch
    {
        JobKind.Freeform => FreeformTemplate.Schema,
        JobKind.Cell => CellSchema(),
        _ => JobTemplate.Schema,
    };

    // A method of its own, so that a job does not load the cell.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static string CellSchema() => CellTemplate.Schema;
}
